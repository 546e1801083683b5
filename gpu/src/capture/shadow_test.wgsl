// Who is in shadow. Needs the parts CUBE, LIGHTS and SHADOW_MAPS, and the texture `shadow_maps`.

// Whether a light reaches a surface. The shadow map holds the distance along the ray of a texel's
// centre, so the surface's own plane is followed to that same ray before the two are compared: a
// plane never shadows itself, whatever its slope. The bias of one texel's width is for what is not
// one plane (creases, rounding): shadows begin that far behind an occluder.
fn reached(light: Light, x: vec3f, normal: vec3f) -> bool {
    let offset = x - shadow_origin(light);
    var st: vec2f;
    var face = 0u;
    var along: f32;
    var texel_width: f32;
    if light.kind == LIGHT_DIRECTIONAL {
        let right = cross(light.axis, light.up);
        st = vec2f(dot(offset, right), -dot(offset, light.up)) / light.limit;
        along = dot(offset, light.axis);
        texel_width = 2.0 * light.limit / f32(SHADOW_SIZE);
    } else {
        let coordinates = cube_coordinates(offset);
        st = vec2f(coordinates.s, coordinates.t);
        face = coordinates.face;
        along = length(offset);
        texel_width = 2.0 * along / f32(SHADOW_SIZE);
    }
    let column = texel_at(SHADOW_SIZE, st.x);
    let row = texel_at(SHADOW_SIZE, st.y);
    let first = textureLoad(shadow_maps, vec2u(column, row), light.first_layer + face, 0).r;
    let centre = vec2f(texel_centre(SHADOW_SIZE, column), texel_centre(SHADOW_SIZE, row));
    let ray = shadow_ray(light, face, centre);
    // Where the ray misses the plane, `along` is what remains to compare.
    let cos_theta = dot(normal, ray.direction);
    let height = dot(normal, offset - ray.start);
    let meets = height * cos_theta > 0.0;
    let own = select(along, height / select(1.0, cos_theta, meets), meets);
    // 0: the ray meets no surface.
    return first == 0.0 || first >= min(own, along) - texel_width;
}
