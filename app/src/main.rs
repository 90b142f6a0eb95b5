//! The `brilliance` program: opens the window on the default scene.

use brilliance_renderer::scene_file::Document;

fn main() -> anyhow::Result<()> {
    env_logger::init();
    brilliance::window::open(Document::default(), None)
}
