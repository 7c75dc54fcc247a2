//! Tests of readers and writers, one module a subject.

mod arrays;
mod bounded;
mod common;
mod compare;
mod copc;
mod findings;
mod formats;
mod gltf;
mod gpkg;
mod gps;
mod killed;
mod las;
mod lessons;
mod meshes;
mod networks;
mod obj;
mod output;
mod pcd;
mod ply;
mod points;
mod scans;
mod seeds;
mod select;
mod shared;
mod table;
