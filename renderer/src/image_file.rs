//! Image files: PNG and OpenEXR, written to a temporary name and renamed.
