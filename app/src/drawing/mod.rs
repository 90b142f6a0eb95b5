//! Line drawings in the window: shown live, written as SVG and PNG.

mod facet_window;
mod paint;
mod sheet_files;
mod sheet_view;

pub use facet_window::FacetWindow;
pub use paint::paint_sheet;
pub use sheet_files::{SaveSheet, SheetFiles, extension};
pub use sheet_view::SheetView;
