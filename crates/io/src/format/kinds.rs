//! Formats by content: scans, networks, points, patches, sections, graphs, meshes.

/// A file format with its uses. A line for help texts stands beside each use that writes.
#[derive(Clone, Copy, Debug)]
pub struct FileFormat {
    /// Name in messages.
    pub name: &'static str,
    /// Extensions without their dots, in lower case; the first is the usual one.
    pub extensions: &'static [&'static str],
    /// As a format of point clouds that are read.
    pub read: Option<Format>,
    /// As a format of networks.
    pub network: Written<NetworkFormat>,
    /// As a format of classified points.
    pub points: Written<PointFormat>,
    /// As a format of patches.
    pub patches: Written<PatchFormat>,
    /// As a format of sections.
    pub section: Written<SectionFormat>,
    /// As a format of neighbour graphs.
    pub graph: Written<GraphFormat>,
    /// As a format of meshes that are written.
    pub mesh: Written<MeshFormat>,
}

/// A format that is written, with its line in help texts.
pub type Written<T> = Option<(T, &'static str)>;

/// A format that point clouds are read from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Format {
    /// Polygon file format, ascii or binary.
    Ply,
    /// Rows of numbers: XYZ, TXT, CSV, ASC, PTS and their kin.
    Table,
    /// Wavefront object.
    Obj,
    /// Point cloud data, ascii, binary or compressed.
    Pcd,
    /// LAS and LAZ, and COPC, which is LAZ.
    Las,
    /// ASTM E2807.
    E57,
    /// Leica's organised scans as text.
    Ptx,
    /// Triangles, ascii or binary.
    Stl,
    /// Geomview's object file format.
    Off,
    /// NumPy's array format.
    Npy,
    /// NumPy's archives of arrays.
    Npz,
    /// Apache Parquet.
    Parquet,
    /// Binary point sets of the Expe library.
    Expe,
    /// glTF 2.0, binary (GLB) or JSON.
    Gltf,
    /// Heights in the cells of a grid, as ESRI writes them in ASCII.
    Raster,
}

/// A format that networks are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NetworkFormat {
    /// The documented schema `lineament-network/2`.
    Json,
    /// Wavefront lines.
    Obj,
    /// Vertices and edges, binary.
    Ply,
    /// Lines, arcs, circles, ellipses and splines, release 2000.
    Dxf,
    /// A wireframe of lines, circles and splines (ISO 10303-21).
    Step,
    /// A drawing in millimetres.
    Svg,
    /// Lines and points in the frame of the input.
    GeoJson,
    /// The same as a database of two layers.
    GeoPackage,
    /// Binary glTF lines.
    Glb,
    /// VTK polygonal data.
    Vtp,
    /// A row for each point.
    Csv,
    /// A page for browsers; without the points, which `write_report` adds.
    Html,
}

/// A format that classified points are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PointFormat {
    /// The classes as an array of bytes.
    Npy,
    /// Positions, class, score and the attributes of the input, an array each.
    Npz,
    /// The same as columns of Apache Parquet.
    Parquet,
    /// Positions, class, score and the attributes of the input, binary.
    Ply,
    /// The same as PCD, binary.
    Pcd,
    /// The same as text with blanks.
    Xyz,
    /// The same as text with commas.
    Csv,
    /// The same as LAS 1.4.
    Las,
    /// The same as LAZ 1.4.
    Laz,
    /// Positions and classes as a page for browsers.
    Html,
}

/// A format that patches are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PatchFormat {
    /// The schema `lineament-network/2` with loops, sides and surfaces.
    Json,
    /// The loops as lines, arcs, circles, ellipses and splines, a layer for each patch.
    Dxf,
    /// The patches as trimmed faces, sewn where they share edges (ISO 10303-21).
    Step,
    /// The points with the patch of each.
    Points(PointFormat),
    /// A page for browsers.
    Html,
}

/// A format that sections are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SectionFormat {
    /// The documented schema `lineament-section/1`.
    Json,
    /// Wavefront lines, a group for each slice.
    Obj,
    /// Vertices and edges, binary.
    Ply,
    /// Polylines of lines and arcs, circles, ellipses and splines, release 2000, a layer for each slice; names of the runs as texts.
    Dxf,
    /// A wireframe of true curves, a set for each contour, a layer for each slice.
    Step,
    /// A sheet with all slices side by side, in millimetres.
    Svg,
    /// Polygons with their holes, and lines.
    GeoJson,
    /// The same as a database of two layers.
    GeoPackage,
    /// A page for browsers; without the points, which `write_report` adds.
    Html,
}

/// A format that neighbour graphs are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum GraphFormat {
    /// The documented schema `lineament-graph/1`.
    Json,
    /// Points with their attributes, and edges, binary.
    Ply,
    /// A row for each edge.
    Csv,
    /// Positions and edges, an array each.
    Npz,
}

/// A format that meshes are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MeshFormat {
    /// Vertices with their kind, and faces, binary.
    Ply,
    /// Wavefront faces.
    Obj,
    /// Triangles, binary, single precision.
    Stl,
    /// Geomview's object file format.
    Off,
    /// Binary glTF triangles.
    Glb,
}
