//! Line drawings: what they show, where it stands, and the files they become.
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

mod bodies;
mod edges;
mod facets;
mod files;
mod layout;
mod prism;
