// Twins of math.rs, function by function. A texel's surface point relative to o is direction / w.

struct TowardsTexel {
    // Unit direction I from x, zero where x is the texel's own point.
    i: vec3f,
    // (r/d)².
    r2: f32,
}

fn towards_texel(direction: vec3f, w: f32, x: vec3f) -> TowardsTexel {
    let r = direction - x * w;
    let r2 = dot(r, r);
    let tiny = 1.17549435e-38;
    if r2 > tiny {
        return TowardsTexel(r * (1.0 / sqrt(r2)), r2);
    }
    return TowardsTexel(vec3f(0.0), r2);
}

fn cos_half(n: vec3f, i: vec3f, v: vec3f) -> f32 {
    let h = i + v;
    let h2 = dot(h, h);
    if h2 > 1e-20 {
        return dot(n, h) * (1.0 / sqrt(h2));
    }
    return 0.0;
}
