// Walkers that follow fans.

// Begins a walk.
fn set_out(camera_ray: Ray) {
    send_fan(white_fan(camera_ray.origin, camera_ray.direction, walk.seed));
}

// Follows the next fan.
fn get_on() {
    follow_fan();
}
