//! The materials that ship.
