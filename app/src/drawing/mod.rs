//! Line drawings in the window: shown live, written as SVG and PNG.

mod draughting;
mod facet_window;
mod paint;
mod prism_window;
mod sheet_files;
mod sheet_view;

pub use facet_window::FacetWindow;
pub use paint::paint_sheet;
pub use prism_window::PrismWindow;
pub use sheet_files::{SaveSheet, SheetFiles, extension};
pub use sheet_view::SheetView;
