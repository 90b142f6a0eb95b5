//! `brilliance inspect`: the tree of rays of one pixel, as text or JSON.

mod text;

use std::io::{self, BufWriter, ErrorKind, Write as _};
use std::path::PathBuf;
use std::sync::Arc;

use anyhow::Context as _;
use brilliance_renderer::inspect::{RayTree, RayTreeRequest};
use clap::Args;

use super::assignment::{Assignment, open_with};
use super::image_size::ImageSize;
use super::pixel::Pixel;

/// A pixel to look into.
#[derive(Args, Debug)]
pub(super) struct InspectArguments {
    /// Scene (.toml), mesh (.gltf, .glb) or a still made before (.png, .exr)
    scene: PathBuf,

    /// Column and row of the pixel, counted from 0 at the upper left corner
    #[arg(long, value_name = "X,Y")]
    pixel: Pixel,

    /// Width and height of the picture in pixels [default: the scene's]
    #[arg(long, value_name = "WxH")]
    size: Option<ImageSize>,

    /// Pass whose camera ray is followed, counted from 0; that of pass 0 goes through the pixel's
    /// middle
    #[arg(long, value_name = "N", default_value_t = 0)]
    pass: u32,

    /// Change a value of the scene, named by its path in the scene file; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    assignments: Vec<Assignment>,

    /// Print the tree as JSON
    #[arg(long)]
    json: bool,
}

/// Traces the tree and prints it.
pub(super) fn inspect(arguments: &InspectArguments) -> anyhow::Result<()> {
    let document = open_with(&arguments.scene, &arguments.assignments)?;
    let request = RayTreeRequest {
        camera: document.scene.camera,
        scene: Arc::new(document.scene),
        size: arguments.size.map_or(document.still.size, |size| size.0),
        pixel: arguments.pixel.0,
        pass_index: arguments.pass,
        trace: document.trace,
    };
    let tree = RayTree::trace(&request, RayTree::MAX_RAYS)?;
    match print(&tree, arguments.json) {
        // Who reads the tree has seen enough.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        result => result.context("the tree can't be printed on the standard output"),
    }
}

fn print(tree: &RayTree, as_json: bool) -> io::Result<()> {
    let mut out = BufWriter::new(io::stdout().lock());
    if as_json {
        serde_json::to_writer(&mut out, tree)?;
        writeln!(out)?;
    } else {
        text::write(&mut out, tree)?;
    }
    out.flush()
}
