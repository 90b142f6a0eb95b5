//! What is printed on matte bodies: images, looked up where a ray ends.

use glam::{Vec2, Vec3};

use crate::kernel::deposit::Reflectance;
use crate::kernel::ray::Hit;
use crate::material::Outside;
use crate::packed::{PackedMaterial, PackedPrint, PackedScene};

/// The reflectance of a printed body at `point`, where it was met.
#[inline]
pub fn print_reflectance(
    scene: &PackedScene,
    material: &PackedMaterial,
    hit: &Hit,
    point: Vec3,
) -> Reflectance {
    let print = &material.print;
    let [row_x, row_y, row_z] = scene.instances[hit.instance as usize].object_from_world;
    let normal = Vec3::new(
        row_x.truncate().dot(hit.normal),
        row_y.truncate().dot(hit.normal),
        row_z.truncate().dot(hit.normal),
    )
    .normalize_or_zero();
    let extended = point.extend(1.0);
    let place =
        Vec3::new(row_x.dot(extended), row_y.dot(extended), row_z.dot(extended)).extend(1.0);
    let projection = print.projection + hit.facet * print.projection_stride;
    let at = Vec2::new(
        scene.projection_row(projection).dot(place),
        scene.projection_row(projection + 4).dot(place),
    );
    let is_bare = print.front.dot(normal) + print.front_offset <= 0.0
        || is_off(at.x, print.outside[0])
        || is_off(at.y, print.outside[1]);
    if is_bare {
        return Reflectance::bare(material.reflectance);
    }
    Reflectance {
        row: material.reflectance,
        primaries: print.primaries,
        weights: filtered_texel(scene, print, at) * print.tint,
    }
}

/// Whether a texture coordinate lies beyond an image that ends there.
#[inline]
pub fn is_off(coordinate: f32, outside: u32) -> bool {
    outside == Outside::Bare as u32 && !(0.0..=1.0).contains(&coordinate)
}

/// The texture coordinate in 0..=1 of what is shown at one that may lie outside of the image.
#[inline]
pub fn folded(coordinate: f32, outside: u32) -> f32 {
    if outside == Outside::Repeat as u32 {
        return coordinate - coordinate.floor();
    }
    if outside == Outside::Mirror as u32 {
        let within_two = coordinate - 2.0 * (0.5 * coordinate).floor();
        return 1.0 - (within_two - 1.0).abs();
    }
    coordinate.clamp(0.0, 1.0)
}

/// The colour in linear sRGB between the four texels about the texture coordinates `at`.
#[inline]
pub fn filtered_texel(scene: &PackedScene, print: &PackedPrint, at: Vec2) -> Vec3 {
    // Colours are those of the middles of the texels.
    let x = folded(at.x, print.outside[0]) * print.size[0] as f32 - 0.5;
    let y = folded(at.y, print.outside[1]) * print.size[1] as f32 - 0.5;
    let left = neighbour(x.floor() as i32, print.size[0], print.outside[0]);
    let right = neighbour(x.floor() as i32 + 1, print.size[0], print.outside[0]);
    let above = neighbour(y.floor() as i32, print.size[1], print.outside[1]);
    let below = neighbour(y.floor() as i32 + 1, print.size[1], print.outside[1]);
    let across = x - x.floor();
    let along = y - y.floor();
    let upper = texel(scene, print, left, above) * (1.0 - across)
        + texel(scene, print, right, above) * across;
    let lower = texel(scene, print, left, below) * (1.0 - across)
        + texel(scene, print, right, below) * across;
    upper * (1.0 - along) + lower * along
}

/// The column or row that is shown at one that may lie just outside of the image.
#[inline]
pub fn neighbour(index: i32, count: u32, outside: u32) -> u32 {
    let last = count as i32 - 1;
    if outside == Outside::Repeat as u32 && index < 0 {
        return last as u32;
    }
    if outside == Outside::Repeat as u32 && index > last {
        return 0;
    }
    index.clamp(0, last) as u32
}

/// The colour of one texel, in linear sRGB.
#[inline]
pub fn texel(scene: &PackedScene, print: &PackedPrint, column: u32, row: u32) -> Vec3 {
    let codes = scene.words[(print.texels + row * print.size[0] + column) as usize];
    let level = |code: u32| f32::from_bits(scene.words[(print.levels + (code & 0xff)) as usize]);
    Vec3::new(level(codes), level(codes >> 8), level(codes >> 16))
}
