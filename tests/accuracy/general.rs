//! A concave mesh over a matte ground.
