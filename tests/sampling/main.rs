//! Where camera rays go: the points of a pixel, the noise that is left, and which pixels need more.

mod adaptive;
mod films;
mod noise;
mod sequence;
