//! From film to display: CIE XYZ, white point, exposure, tone curve, gamut, encoding.
