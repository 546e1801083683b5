// Twins of math.rs, function by function.

const DEPTH_ROUNDING: f32 = 5e-7;

fn passes(depth: f32, map_depth: f32, margin: f32) -> f32 {
    let behind = depth - (map_depth + margin + DEPTH_ROUNDING);
    return select(1.0, 0.0, behind > 0.0);
}

fn open_cosine(cos_theta: f32, open: f32, least: f32) -> f32 {
    return max(cos_theta, least) * open;
}
