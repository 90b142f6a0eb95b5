//! Files that bring stones and meshes.
