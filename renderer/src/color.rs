//! Colour spaces: CIE XYZ, linear Rec. 709 RGB, sRGB encoding, chromatic adaptation.
