//! The window without a window system: each control changes what it says it changes.

mod drawing;
mod export;
mod files;
mod graphics;
mod inspector;
mod inspector_rays;
mod inspector_spectrum;
mod panel;
mod picture;
mod shown;
mod status;
mod window;
