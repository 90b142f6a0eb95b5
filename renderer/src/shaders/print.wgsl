// What is printed on matte bodies: images, looked up where a ray ends.

// The reflectance of a printed body at `point`, where it was met.
fn print_reflectance(material: PackedMaterial, hit: Hit, point: vec3f) -> Reflectance {
    let print = material.print;
    let rows = instances[hit.instance].object_from_world;
    let normal = normalize_or_zero(
        vec3f(dot(rows[0].xyz, hit.normal), dot(rows[1].xyz, hit.normal), dot(rows[2].xyz, hit.normal)),
    );
    let extended = vec4f(point, 1.0);
    let place = vec4f(dot(rows[0], extended), dot(rows[1], extended), dot(rows[2], extended), 1.0);
    let projection = print.projection + hit.facet * print.projection_stride;
    let at = vec2f(
        dot(projection_row(projection), place),
        dot(projection_row(projection + 4u), place),
    );
    let is_bare = dot(print.front, normal) + print.front_offset <= 0.0
        || is_off(at.x, print.outside.x)
        || is_off(at.y, print.outside.y);
    if is_bare {
        return bare(material.reflectance);
    }
    return Reflectance(
        material.reflectance,
        print.primaries,
        filtered_texel(print, at) * print.tint,
    );
}

// Whether a texture coordinate lies beyond an image that ends there.
fn is_off(coordinate: f32, outside: u32) -> bool {
    return outside == OUTSIDE_BARE && !(coordinate >= 0.0 && coordinate <= 1.0);
}

// The texture coordinate in 0..=1 of what is shown at one that may lie outside of the image.
fn folded(coordinate: f32, outside: u32) -> f32 {
    if outside == OUTSIDE_REPEAT {
        return coordinate - floor(coordinate);
    }
    if outside == OUTSIDE_MIRROR {
        let within_two = coordinate - 2.0 * floor(0.5 * coordinate);
        return 1.0 - abs(within_two - 1.0);
    }
    return clamp(coordinate, 0.0, 1.0);
}

// The colour in linear sRGB between the four texels about the texture coordinates `at`.
fn filtered_texel(print: PackedPrint, at: vec2f) -> vec3f {
    // Colours are those of the middles of the texels.
    let x = folded(at.x, print.outside.x) * f32(print.size.x) - 0.5;
    let y = folded(at.y, print.outside.y) * f32(print.size.y) - 0.5;
    let left = neighbour(i32(floor(x)), print.size.x, print.outside.x);
    let right = neighbour(i32(floor(x)) + 1, print.size.x, print.outside.x);
    let above = neighbour(i32(floor(y)), print.size.y, print.outside.y);
    let below = neighbour(i32(floor(y)) + 1, print.size.y, print.outside.y);
    let across = x - floor(x);
    let along = y - floor(y);
    let upper = texel(print, left, above) * (1.0 - across) + texel(print, right, above) * across;
    let lower = texel(print, left, below) * (1.0 - across) + texel(print, right, below) * across;
    return upper * (1.0 - along) + lower * along;
}

// The column or row that is shown at one that may lie just outside of the image.
fn neighbour(index: i32, count: u32, outside: u32) -> u32 {
    let last = i32(count) - 1;
    if outside == OUTSIDE_REPEAT && index < 0 {
        return u32(last);
    }
    if outside == OUTSIDE_REPEAT && index > last {
        return 0u;
    }
    return u32(clamp(index, 0, last));
}

// The colour of one texel, in linear sRGB.
fn texel(print: PackedPrint, column: u32, row: u32) -> vec3f {
    let codes = words[print.texels + row * print.size.x + column];
    return vec3f(
        bitcast<f32>(words[print.levels + (codes & 0xffu)]),
        bitcast<f32>(words[print.levels + (codes >> 8u & 0xffu)]),
        bitcast<f32>(words[print.levels + (codes >> 16u & 0xffu)]),
    );
}
