//! Brilliance, a viewer of gemstones: the window and the command line.
//!
//! [`app`] holds the document that is edited and, each frame, asks the renderer's session for
//! the picture it describes; the panels edit the document, the viewport shows the picture.
//! [`cli`] does the same work without a window.

pub mod app;
pub mod bounds;
pub mod cli;
pub mod command;
pub mod drawing;
pub mod editor;
pub mod export;
pub mod first_picture;
pub mod help;
pub mod history;
pub mod inspector;
pub mod legend;
pub mod live;
pub mod menu;
pub mod notice;
pub mod opening;
pub mod orbit;
pub mod panels;
pub mod path_dialog;
pub mod picture_painter;
pub mod question;
pub(crate) mod ray_words;
pub mod row;
pub mod shown;
pub mod spectrum_csv;
pub mod status;
pub mod task;
pub mod theme;
pub mod tracers;
pub mod viewport;
pub mod waker;
pub mod window;
