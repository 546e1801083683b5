// The lookup into convolved maps, in slot 4: the irradiance first, then one map a lobe.

@group(0) @binding(4) var<storage, read> maps: array<vec4f>;

// Bilinear value of map `index`, of so many cells along a face's edge, in a direction.
fn map_lookup(cells: u32, index: u32, direction: vec3f) -> vec3f {
    let taps = map_taps(cells, direction);
    let base = index * map_nodes(cells) + taps.base;
    return maps[base].rgb * ((1.0 - taps.u) * (1.0 - taps.v))
        + maps[base + 1u].rgb * (taps.u * (1.0 - taps.v))
        + maps[base + taps.side].rgb * ((1.0 - taps.u) * taps.v)
        + maps[base + taps.side + 1u].rgb * (taps.u * taps.v);
}
