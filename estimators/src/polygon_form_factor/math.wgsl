// Twins of math.rs, function by function. Corners run clockwise seen from x.

// Height of a corner above the horizon, negative within rounding.
fn corner_height(r: vec3f, n: vec3f, w: f32, reach: f32) -> f32 {
    return dot(n, r) - 2e-6 * (1.0 + w * reach);
}

// An edge's angle times n·ĉ.
fn edge_integral(a: vec3f, b: vec3f, n: vec3f) -> f32 {
    let c = cross(a, b - a);
    let length_c = sqrt(dot(c, c));
    if length_c > 1e-30 {
        return angle(length_c, dot(a, b)) / length_c * dot(c, n);
    }
    return 0.0;
}

// n·ĉ of an edge.
fn edge_cosine(a: vec3f, b: vec3f, n: vec3f) -> f32 {
    let c = cross(a, b - a);
    let length_c = sqrt(dot(c, c));
    if length_c > 1e-30 {
        return dot(c, n) / length_c;
    }
    return 0.0;
}

// The angle that an edge spans.
fn edge_angle(a: vec3f, b: vec3f) -> f32 {
    let c = cross(a, b - a);
    return angle(sqrt(dot(c, c)), dot(a, b));
}

// Half the sum over the contour clipped at the horizon and closed along it.
fn clipped_quad(corners: array<vec3f, 4>, heights: vec4f, n: vec3f) -> f32 {
    var r = corners;
    // The crossing through which the contour left the upper side last, before it comes back.
    var left_at = vec3f(0.0);
    for (var k = 0u; k < 4u; k++) {
        let a = r[k];
        let b = r[(k + 1u) % 4u];
        let h_a = heights[k];
        let h_b = heights[(k + 1u) % 4u];
        if h_a > 0.0 && h_b <= 0.0 {
            left_at = a + (b - a) * (h_a / (h_a - h_b));
        }
    }
    var sum = 0.0;
    for (var k = 0u; k < 4u; k++) {
        let a = r[k];
        let b = r[(k + 1u) % 4u];
        let h_a = heights[k];
        let h_b = heights[(k + 1u) % 4u];
        if h_a > 0.0 && h_b > 0.0 {
            sum += edge_integral(a, b, n);
        } else if h_a > 0.0 || h_b > 0.0 {
            let crossing = a + (b - a) * (h_a / (h_a - h_b));
            if h_a > 0.0 {
                sum += edge_integral(a, crossing, n);
                left_at = crossing;
            } else {
                sum += edge_integral(crossing, b, n) + edge_integral(left_at, crossing, n);
            }
        }
    }
    return 0.5 * sum;
}
