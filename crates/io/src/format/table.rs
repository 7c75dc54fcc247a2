//! The table of formats. A new format is a row here, a variant of an enum in `format/kinds.rs`, and a file in `read/` or `write/`.

use super::kinds::{
    FileFormat, Format, GraphFormat, MeshFormat, NetworkFormat, PatchFormat, PointFormat, SectionFormat,
};

/// Help lines of the formats that hold points.
const POINTS: &str = "the points and their attributes, with class and score";
const LABELS: &str = "the points and their attributes, with the patch of each; -1 for none";

/// The help line of the formats of vertices and faces alone.
const FACES: &str = "vertices and faces";

/// A format without a use.
const fn named(name: &'static str, extensions: &'static [&'static str]) -> FileFormat {
    FileFormat {
        name,
        extensions,
        read: None,
        network: None,
        points: None,
        patches: None,
        section: None,
        graph: None,
        mesh: None,
    }
}

/// A format of points, classified or labelled by patch.
const fn of_points(
    name: &'static str,
    extensions: &'static [&'static str],
    format: PointFormat,
) -> FileFormat {
    FileFormat {
        points: Some((format, POINTS)),
        patches: Some((PatchFormat::Points(format), LABELS)),
        ..named(name, extensions)
    }
}

/// All formats. Lists in messages and help texts have this order; of several rows that are read alike the first gives the
/// name.
pub const FORMATS: &[FileFormat] = &[
    FileFormat {
        network: Some((NetworkFormat::Json, "everything found (schema lineament-network/2)")),
        patches: Some((
            PatchFormat::Json,
            "loops, neighbours, areas and surfaces (schema lineament-network/2)",
        )),
        section: Some((SectionFormat::Json, "everything found (schema lineament-section/1)")),
        graph: Some((GraphFormat::Json, "the edges with their provenance (schema lineament-graph/1)")),
        ..named("JSON", &["json"])
    },
    FileFormat {
        read: Some(Format::Ply),
        network: Some((NetworkFormat::Ply, "vertices and edges")),
        section: Some((SectionFormat::Ply, "vertices and edges")),
        graph: Some((GraphFormat::Ply, "the points with their attributes, and the edges")),
        mesh: Some((
            MeshFormat::Ply,
            "vertices with their kind (0 smooth, 1 crease, 2 border, 3 corner), faces",
        )),
        ..of_points("PLY", &["ply"], PointFormat::Ply)
    },
    FileFormat {
        read: Some(Format::Obj),
        network: Some((NetworkFormat::Obj, "lines")),
        section: Some((SectionFormat::Obj, "lines, a group for each slice")),
        mesh: Some((MeshFormat::Obj, FACES)),
        ..named("OBJ", &["obj"])
    },
    FileFormat {
        network: Some((
            NetworkFormat::Dxf,
            "lines, arcs, circles, ellipses, splines and points, a layer for each kind",
        )),
        patches: Some((PatchFormat::Dxf, "the loops as curves, a layer for each patch")),
        section: Some((
            SectionFormat::Dxf,
            "contours of lines and arcs, a layer for each slice, and the names of features",
        )),
        ..named("DXF", &["dxf"])
    },
    FileFormat {
        network: Some((
            NetworkFormat::Step,
            "a wireframe of lines, circles and splines, a layer for each kind",
        )),
        patches: Some((PatchFormat::Step, "faces, sewn to solids where they close")),
        section: Some((SectionFormat::Step, "a wireframe of the contours, a layer for each slice")),
        ..named("STEP", &["step", "stp"])
    },
    FileFormat {
        network: Some((NetworkFormat::Svg, "a drawing in millimetres, seen from --view")),
        section: Some((SectionFormat::Svg, "a sheet with all slices, in millimetres")),
        ..named("SVG", &["svg"])
    },
    FileFormat {
        network: Some((
            NetworkFormat::GeoJson,
            "line strings and points, with the reference system of the input",
        )),
        section: Some((SectionFormat::GeoJson, "polygons with their holes")),
        ..named("GeoJSON", &["geojson"])
    },
    FileFormat {
        network: Some((
            NetworkFormat::GeoPackage,
            "GeoPackage, layers of lines and nodes with their properties",
        )),
        section: Some((SectionFormat::GeoPackage, "GeoPackage, layers of areas and open lines")),
        ..named("GeoPackage", &["gpkg"])
    },
    FileFormat {
        network: Some((
            NetworkFormat::Html,
            "a report for browsers: points and lines to turn, filter and measure",
        )),
        points: Some((PointFormat::Html, "a report for browsers: the points by class")),
        patches: Some((PatchFormat::Html, "a report for browsers: points by patch, lines, surfaces")),
        section: Some((SectionFormat::Html, "a report for browsers: points, slices and features")),
        ..named("HTML", &["html", "htm"])
    },
    FileFormat { read: Some(Format::Gltf), ..named("glTF", &["gltf"]) },
    FileFormat {
        read: Some(Format::Gltf),
        network: Some((NetworkFormat::Glb, "binary glTF lines")),
        mesh: Some((MeshFormat::Glb, "binary glTF triangles, single precision about their middle")),
        ..named("GLB", &["glb"])
    },
    FileFormat { network: Some((NetworkFormat::Vtp, "VTK polygonal data")), ..named("VTP", &["vtp"]) },
    FileFormat {
        read: Some(Format::Table),
        ..named("table", &["txt", "asc", "tsv", "dat", "pts", "xyzn", "xyzrgb", "pwn", "neu"])
    },
    FileFormat { read: Some(Format::Table), ..of_points("XYZ", &["xyz"], PointFormat::Xyz) },
    FileFormat {
        read: Some(Format::Table),
        network: Some((NetworkFormat::Csv, "a row for each point of each line")),
        graph: Some((GraphFormat::Csv, "a row for each edge: the rows of its points, its length")),
        ..of_points("CSV", &["csv"], PointFormat::Csv)
    },
    FileFormat { read: Some(Format::Las), ..of_points("LAS", &["las"], PointFormat::Las) },
    FileFormat { read: Some(Format::Las), ..of_points("LAZ", &["laz"], PointFormat::Laz) },
    FileFormat { read: Some(Format::E57), ..named("E57", &["e57"]) },
    FileFormat { read: Some(Format::Raster), ..named("ESRI grid", &["agr"]) },
    FileFormat { read: Some(Format::Pcd), ..of_points("PCD", &["pcd"], PointFormat::Pcd) },
    FileFormat { read: Some(Format::Ptx), ..named("PTX", &["ptx"]) },
    FileFormat {
        read: Some(Format::Stl),
        mesh: Some((MeshFormat::Stl, "binary triangles, single precision")),
        ..named("STL", &["stl"])
    },
    FileFormat { read: Some(Format::Off), mesh: Some((MeshFormat::Off, FACES)), ..named("OFF", &["off"]) },
    FileFormat {
        read: Some(Format::Npy),
        points: Some((PointFormat::Npy, "the classes alone, a byte for each point")),
        ..named("NPY", &["npy"])
    },
    FileFormat {
        read: Some(Format::Npz),
        graph: Some((GraphFormat::Npz, "arrays `xyz`, `edges`, `length`")),
        ..of_points("NPZ", &["npz"], PointFormat::Npz)
    },
    FileFormat {
        read: Some(Format::Parquet),
        ..of_points("Parquet", &["parquet", "pq"], PointFormat::Parquet)
    },
    FileFormat { read: Some(Format::Expe), ..named("Expe point set", &[]) },
];
