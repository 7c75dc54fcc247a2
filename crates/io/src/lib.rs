//! Readers of point clouds and writers of feature lines.
