//! How far pictures are from a tracer that divides nothing: every wavelength alone, in double
//! precision, along the same camera rays.

mod bodies;
mod brute_force;
mod difference;
mod emitters;
mod formulas;
mod general;
mod interface;
mod method;
mod quadrature;
mod reference;
mod scenes;
mod table;
