//! The session: the newest request wins, display settings do not retrace, a device that fails is
//! replaced by the processor; and stills.

mod graphics;
mod readings;
mod requests;
mod stills;
mod watched;
