//! The leaf functions of math.rs and math.wgsl, with inputs and tolerances.

use super::math as polygon;
use crate::leaves::*;

/// Error of an edge: products that cancel in c, then the angle and a division.
const EDGE: Tolerance = ulps(
    20,
    4.0,
    "a vector product whose terms cancel, and an angle with a relative error of 3e-7",
);

/// The leaf functions.
pub(super) const LEAVES: Leaves = Leaves {
    folder: "polygon_form_factor",
    wgsl: include_str!("math.wgsl"),
    functions: FUNCTIONS,
    host_only: &[],
};

const FUNCTIONS: &[Leaf] = &[
    Leaf {
        name: "edge_integral",
        wgsl: "outputs[id.x] = vec4f(edge_integral(vec3f(a[0], a[1], a[2]), vec3f(a[3], a[4], a[5]), vec3f(a[6], a[7], a[8])), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![polygon::edge_integral(
            vector(a, 0),
            vector(a, 3),
            vector(a, 6)
        )]),
        inputs: edges,
        tolerance: EDGE,
    },
    Leaf {
        name: "corner_height",
        wgsl: "outputs[id.x] = vec4f(corner_height(vec3f(a[0], a[1], a[2]), vec3f(a[6], a[7], a[8]), a[3], a[4]), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![polygon::corner_height(
            vector(a, 0),
            vector(a, 6),
            a[3],
            a[4]
        )]),
        inputs: edges,
        tolerance: ulps(3, 3.0, "a scalar product whose terms cancel"),
    },
    Leaf {
        name: "edge_cosine",
        wgsl: "outputs[id.x] = vec4f(edge_cosine(vec3f(a[0], a[1], a[2]), vec3f(a[3], a[4], a[5]), vec3f(a[6], a[7], a[8])), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![polygon::edge_cosine(
            vector(a, 0),
            vector(a, 3),
            vector(a, 6)
        )]),
        inputs: edges,
        tolerance: EDGE,
    },
    Leaf {
        name: "edge_angle",
        wgsl: "outputs[id.x] = vec4f(edge_angle(vec3f(a[0], a[1], a[2]), vec3f(a[3], a[4], a[5])), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| vec![polygon::edge_angle(vector(a, 0), vector(a, 3))]),
        inputs: edges,
        tolerance: EDGE,
    },
    Leaf {
        name: "clipped_quad",
        wgsl: "let corners = array<vec3f, 4>(vec3f(a[0], a[1], a[2]), vec3f(a[3], a[4], a[5]), vec3f(a[6], a[7], a[8]), vec3f(a[9], a[10], a[11]));\n\
         let n = vec3f(a[12], a[13], a[14]);\n\
         let heights = vec4f(dot(n, corners[0]), dot(n, corners[1]), dot(n, corners[2]), dot(n, corners[3]));\n\
         outputs[id.x] = vec4f(clipped_quad(corners, heights, n), 0.0, 0.0, 0.0);",
        calls: over_lanes!(|a| {
            let corners = [vector(a, 0), vector(a, 3), vector(a, 6), vector(a, 9)];
            let n = vector(a, 12);
            vec![polygon::clipped_quad(
                &corners,
                &corners.map(|r| n.dot(r)),
                n,
            )]
        }),
        inputs: quads,
        tolerance: Tolerance {
            absolute: 2e-5,
            relative: 1e-5,
            cause: "up to eight edges; a crossing of the horizon moves with the rounding of a \
                    height that is small beside its terms",
        },
    },
];

/// Edges whose ends lie apart, short ones, one end far away, and ones that pass at a tenth of a unit,
/// seen by a unit normal; and one without a length. Nearer edges lose accuracy in proportion: the
/// direction of c has the rounding of |a|·|b|/|c|.
fn edges() -> Vec<Input> {
    let mut inputs = spread(9, -1.0, 1.0);
    for a in &mut inputs {
        a[2] += 2.0;
        unit(a, 6);
    }
    for (i, mut a) in inputs.clone().into_iter().enumerate().step_by(5) {
        for k in 0..3 {
            a[3 + k] = match i % 15 {
                0 => a[k] + 1e-4 * (a[3 + k] - a[k]),
                5 => 1e4 * a[3 + k],
                _ => 0.1 * a[6 + k] - a[k],
            };
        }
        inputs.push(a);
    }
    let mut point = inputs[0];
    for k in 0..3 {
        point[3 + k] = point[k];
    }
    inputs.push(point);
    inputs
}

/// Quadrilaterals at unit distance around some direction, seen by normals in all directions: above,
/// below and cut by the horizon. Clockwise and counter-clockwise.
fn quads() -> Vec<Input> {
    let mut inputs = spread(8, -1.0, 1.0);
    for a in &mut inputs {
        let b = *a;
        let corner = [(-0.4, -0.4), (-0.4, 0.4), (0.4, 0.4), (0.4, -0.4)];
        for (k, (s, t)) in corner.into_iter().enumerate() {
            a[3 * k] = s + 0.1 * b[k];
            a[3 * k + 1] = t + 0.1 * b[(k + 1) % 4];
            a[3 * k + 2] = 1.0 + 0.2 * b[(k + 2) % 4];
        }
        (a[12], a[13], a[14]) = (b[4], b[5], b[6]);
        unit(a, 12);
    }
    inputs.extend(at_the_horizon());
    inputs
}

/// A square whose edge, whose corner or whose diagonal lies in the horizon, to a rounding.
fn at_the_horizon() -> Vec<Input> {
    let square = [
        -0.4, -0.4, 1.0, -0.4, 0.4, 1.0, 0.4, 0.4, 1.0, 0.4, -0.4, 1.0,
    ];
    let normals = [
        [1.0, 0.0, 0.4],
        [1.0, 1.0, 0.8],
        [1.0, -1.0, 0.0],
        [1.0, 0.0, -0.4],
    ];
    let seen_by = |normal: [f32; 3]| {
        let mut a = [0.0; ARGUMENTS];
        a[..12].copy_from_slice(&square);
        a[12..15].copy_from_slice(&normal);
        unit(&mut a, 12);
        a
    };
    normals.map(seen_by).into()
}

fn unit(a: &mut Input, first: usize) {
    let length = (0..3).map(|k| a[first + k].powi(2)).sum::<f32>().sqrt();
    (0..3).for_each(|k| a[first + k] /= length);
}
