// Camera rays.

// The ray through a point of pixel (`x`, `y`), row 0 at the top, that moves evenly over the
// pixel from pass to pass.
fn camera_ray(x: u32, y: u32, pass_index: u32) -> Ray {
    let jitter = pixel_sample(pixel_seed(x, y), pass_index);
    let across = 2.0 * (f32(x) + jitter.x) / f32(frame.width) - 1.0;
    let upwards = 1.0 - 2.0 * (f32(y) + jitter.y) / f32(frame.height);
    let direction = frame.forward + frame.right * across + frame.up * upwards;
    return white(frame.position, normalize_or_zero(direction));
}

// A random word that is the pixel's own.
fn pixel_seed(x: u32, y: u32) -> u32 {
    return hash(x ^ hash(y));
}
