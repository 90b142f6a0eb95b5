//! `brilliance draw`: the line drawing of a stone.

use std::io::Write as _;
use std::path::PathBuf;

use anyhow::{anyhow, bail};
use brilliance_renderer::drawing::{
    PerturbShown, PrismSetup, Sheet, SheetFormat, facet_diagram, prism_diagram,
};
use brilliance_renderer::material::Material;
use brilliance_renderer::scene::Object;
use brilliance_renderer::scene_file::Document;
use brilliance_renderer::whole_file;
use clap::{Args, ValueEnum, value_parser};

use super::arguments::same_file;
use super::image_size::ImageSize;

/// A drawing to make.
#[derive(Args, Debug)]
pub(super) struct DrawArguments {
    /// Scene (.toml), mesh (.gltf, .glb) or still (.png, .exr) with the stone
    #[arg(required_unless_present = "prism")]
    scene: Option<PathBuf>,

    /// Drawing to write: .svg or .png
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,

    /// Which object of the scene, by its name or its number from 1 [default: the first clear one]
    #[arg(long, value_name = "NAME")]
    object: Option<String>,

    /// Draw instead how a prism divides rays, with values for which wrongly divided ones do this
    #[arg(long, value_enum, value_name = "CASE", conflicts_with_all = ["scene", "object"])]
    prism: Option<PrismCase>,

    /// Width and height of a PNG in pixels [default: A4 at 200 dots per inch]
    #[arg(long, value_name = "WxH", conflicts_with = "dpi")]
    size: Option<ImageSize>,

    /// Dots per inch of a PNG
    #[arg(long, value_name = "N", value_parser = value_parser!(u32).range(10..=600))]
    dpi: Option<u32>,
}

/// What rays do that are divided without `perturb`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum PrismCase {
    /// They leave in clumps.
    Clumping,
    /// They cross.
    Crossing,
}

impl DrawArguments {
    /// What clap can't see: options that contradict each other.
    pub(super) fn check(&self) -> Result<(), String> {
        let format = SheetFormat::of(&self.output).map_err(|fault| fault.to_string())?;
        if format == SheetFormat::Svg && (self.size.is_some() || self.dpi.is_some()) {
            return Err("an SVG has no pixels; --size and --dpi are for a .png".into());
        }
        if self.scene.as_ref().is_some_and(|scene| same_file(&self.output, scene)) {
            return Err(format!(
                "-o {} would overwrite the scene; give the drawing another name",
                self.output.display()
            ));
        }
        Ok(())
    }
}

/// Draws, writes and says what was drawn.
pub(super) fn draw(arguments: &DrawArguments) -> anyhow::Result<()> {
    whole_file::check(&arguments.output)?;
    let sheet = sheet(arguments)?;
    let dpi = arguments.dpi.map_or(Sheet::DPI, f64::from);
    let size = arguments.size.map_or_else(|| sheet.size_at(dpi), |size| size.0);
    sheet.save(&arguments.output, size)?;
    writeln!(std::io::stdout(), "{}: {}", arguments.output.display(), sheet.title)?;
    Ok(())
}

fn sheet(arguments: &DrawArguments) -> anyhow::Result<Sheet> {
    let setup = match (&arguments.scene, arguments.prism) {
        (Some(scene), _) => {
            let document = Document::open(scene)?;
            let object = chosen(&document.scene.objects, arguments.object.as_deref())?;
            return Ok(facet_diagram(object)?);
        }
        (None, Some(PrismCase::Crossing)) => PrismSetup::CROSSING,
        (None, Some(PrismCase::Clumping) | None) => PrismSetup::CLUMPING,
    };
    Ok(prism_diagram(&setup, PerturbShown::Both)?)
}

/// The object of this name or number, or the first clear one, or the first.
fn chosen<'a>(objects: &'a [Object], wanted: Option<&str>) -> anyhow::Result<&'a Object> {
    let Some(wanted) = wanted else {
        let clear = |object: &&Object| matches!(object.material, Material::Dielectric(_));
        return objects
            .iter()
            .find(clear)
            .or(objects.first())
            .ok_or_else(|| anyhow!("the scene has no object to draw; give it a stone"));
    };
    let numbered = || objects.get(wanted.parse::<usize>().ok()?.checked_sub(1)?);
    if let Some(object) = objects.iter().find(|object| object.name == wanted).or_else(numbered) {
        return Ok(object);
    }
    let known: Vec<String> = objects
        .iter()
        .take(20)
        .enumerate()
        .map(|(index, object)| format!("{} {}", index + 1, object.name))
        .collect();
    if known.is_empty() {
        bail!("the scene has no object '{wanted}', nor any other");
    }
    bail!("the scene has no object '{wanted}'; it has {}", known.join(", "));
}
