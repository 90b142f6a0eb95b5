//! The brute force itself against formulas.
