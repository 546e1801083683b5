// The coarse solution: irradiance on both sides of each triangle, linear between the vertices of a
// uniform grid. The host's twin is interreflect_scene::coarse_irradiance.

struct Grid {
    // Index of the first vertex, at corner 0.
    first: u32,
    // Cells along an edge.
    cells: u32,
}

@group(0) @binding(5) var<storage, read> grids: array<Grid>;
// Two for each vertex: front, back.
@group(0) @binding(6) var<storage, read> coarse_irradiance: array<vec4f>;

// Index of a vertex: i cells towards corner 1, j towards corner 2.
fn grid_index(grid: Grid, i: u32, j: u32) -> u32 {
    return grid.first + i * (2u * grid.cells + 3u - i) / 2u + j;
}

// Irradiance on one side of a triangle, at the place with these weights of its corners 1 and 2.
fn coarse_at(triangle: u32, weights: vec2f, front: bool) -> vec3f {
    let grid = grids[triangle];
    let n = f32(grid.cells);
    let place = clamp(weights * n, vec2f(0.0), vec2f(n));
    let i = min(u32(place.x), grid.cells - 1u);
    let j = min(u32(place.y), grid.cells - 1u - i);
    let x = min(place.x - f32(i), 1.0);
    let y = min(place.y - f32(j), 1.0);
    let side = select(1u, 0u, front);
    // The last cell of a row has no upper half.
    let lower = x + y <= 1.0 || i + j + 1u == grid.cells;
    let corner = select(grid_index(grid, i + 1u, j + 1u), grid_index(grid, i, j), lower);
    let along_i = coarse_irradiance[2u * grid_index(grid, i + 1u, j) + side].rgb;
    let along_j = coarse_irradiance[2u * grid_index(grid, i, j + 1u) + side].rgb;
    let at_corner = coarse_irradiance[2u * corner + side].rgb;
    let lower_sum = at_corner * (1.0 - x - y) + along_i * x + along_j * y;
    let upper_sum = at_corner * (x + y - 1.0) + along_j * (1.0 - x) + along_i * (1.0 - y);
    return select(upper_sum, lower_sum, lower);
}
