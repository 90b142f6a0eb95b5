//! Seeing why a pixel looks as it does: the recorded tree of its camera ray.
//!
//! The tree is not traced by a second tracer. [`RayTree::trace`] makes the picture's own walk, ray by
//! ray, and looks over its shoulder: before each ray is followed by the rules, it is followed once
//! more on a walk beside it that keeps all rays, so that those which the rules prune are seen too.
//! What that does to the rays of the paper and to the fans of exact splitting are `paper` and `exact`.

mod branch;
mod counts;
mod end;
mod exact;
mod names;
mod paper;
mod received;
mod recorder;
mod request;
mod tree;

pub use counts::RayCounts;
pub use end::{InterfaceEvent, LightKind, Limit, RayEnd, SeenLight};
pub use names::{Name, Surface};
pub use received::ReceivedLight;
pub use request::RayTreeRequest;
pub use tree::{RayEdge, RayKind, RayTree, RecordedRay};
