// Walkers that follow rays.

// Begins a walk.
fn set_out(camera_ray: Ray) {
    send(camera_ray);
}

// Follows the next ray.
fn get_on() {
    follow();
}
