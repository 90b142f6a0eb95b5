//! Line drawings: plain sheets of strokes and words, and what makes them.
//!
//! A drawing is made as a [`Sheet`], which becomes SVG text or pixels here and is painted in the
//! window by the app.

mod body;
mod dimensions;
mod facet_class;
mod facet_diagram;
mod figure;
mod file;
pub mod font;
mod labels;
mod measures;
mod perturb_figure;
mod prism_diagram;
mod prism_rays;
mod raster;
mod rect;
mod sheet;
mod svg;
mod title_block;
mod view;

pub use body::{BodyEdge, BodyFacet, FacetedBody};
pub use facet_class::{FacetClass, Zone};
pub use facet_diagram::facet_diagram;
pub use file::SheetFormat;
pub use measures::BodyMeasures;
pub use prism_diagram::{PerturbShown, prism_diagram};
pub use prism_rays::{PrismRay, PrismRays, PrismSetup};
pub use rect::Rect;
pub use sheet::{Anchor, Fill, Ink, Mark, Sheet, Stroke, Words};
pub use view::{View, VisibleEdge};
