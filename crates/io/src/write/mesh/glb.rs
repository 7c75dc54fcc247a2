//! A mesh as binary glTF 2.0. Single precision holds what is near the origin best, so the vertices are written about their middle,
//! which a node puts back.

use lineament::apply::SurfaceMesh;
use std::io::{self, Write};

/// Numbers of glTF: single precision, 32-bit integers, vertices, indices, triangles.
const FLOAT: u32 = 5126;
const UNSIGNED: u32 = 5125;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;
const TRIANGLES: u32 = 4;

/// Writes one mesh; z points up, as in the lines' files.
pub(super) fn write(out: &mut dyn Write, mesh: &SurfaceMesh) -> io::Result<()> {
    let middle = middle(&mesh.vertices);
    let local = |v: &[f64; 3]| [0, 1, 2].map(|a| (v[a] - middle[a]) as f32);
    let local: Vec<[f32; 3]> = mesh.vertices.iter().map(local).collect();
    let mut json = json(&local, mesh.triangles.len(), middle);
    while !json.len().is_multiple_of(4) {
        json.push(' ');
    }
    let binary = 12 * (local.len() + mesh.triangles.len());
    let chunk =
        |length: usize| u32::try_from(length).map_err(|_| io::Error::other("a GLB file holds at most 4 GiB"));
    out.write_all(b"glTF")?;
    for number in [2, chunk(12 + 8 + json.len() + 8 + binary)?, chunk(json.len())?] {
        out.write_all(&number.to_le_bytes())?;
    }
    out.write_all(b"JSON")?;
    out.write_all(json.as_bytes())?;
    out.write_all(&chunk(binary)?.to_le_bytes())?;
    out.write_all(b"BIN\0")?;
    for coordinate in local.iter().flatten() {
        out.write_all(&coordinate.to_le_bytes())?;
    }
    for corner in mesh.triangles.iter().flatten() {
        out.write_all(&corner.to_le_bytes())?;
    }
    Ok(())
}

/// Least and greatest coordinates; zero if there are none.
fn bounds<T: Copy + PartialOrd + Default>(points: &[[T; 3]]) -> [[T; 3]; 2] {
    let first = points.first().copied().unwrap_or_default();
    points.iter().fold([first; 2], |[low, high], p| {
        let pick = |a: T, b: T, less: bool| if (b < a) == less && b != a { b } else { a };
        [[0, 1, 2].map(|i| pick(low[i], p[i], true)), [0, 1, 2].map(|i| pick(high[i], p[i], false))]
    })
}

fn middle(vertices: &[[f64; 3]]) -> [f64; 3] {
    let [low, high] = bounds(vertices);
    [0, 1, 2].map(|a| low[a] + 0.5 * (high[a] - low[a]))
}

/// The JSON part; a mesh without triangles is left out, as glTF has none.
fn json(local: &[[f32; 3]], triangles: usize, middle: [f64; 3]) -> String {
    let head = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"lineament\"},\"scene\":0";
    if triangles == 0 {
        return format!("{head},\"scenes\":[{{\"nodes\":[0]}}],\"nodes\":[{{\"name\":\"mesh\"}}]}}");
    }
    let [low, high] = bounds(local);
    let (vertices, corners) = (local.len(), 3 * triangles);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    format!(
        "{head},\"scenes\":[{{\"nodes\":[1]}}],\"nodes\":[{{\"name\":\"mesh\",\"mesh\":0,\"translation\":{middle:?}}},\
         {{\"name\":\"z up\",\"rotation\":[{:?},0.0,0.0,{half:?}],\"children\":[0]}}],\
         \"meshes\":[{{\"name\":\"mesh\",\"primitives\":[{{\"attributes\":{{\"POSITION\":0}},\"indices\":1,\"mode\":{TRIANGLES}}}]}}],\
         \"accessors\":[{{\"bufferView\":0,\"componentType\":{FLOAT},\"count\":{vertices},\"type\":\"VEC3\",\"min\":{low:?},\"max\":{high:?}}},\
         {{\"bufferView\":1,\"componentType\":{UNSIGNED},\"count\":{corners},\"type\":\"SCALAR\"}}],\
         \"bufferViews\":[{{\"buffer\":0,\"byteOffset\":0,\"byteLength\":{},\"target\":{VERTICES}}},\
         {{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{},\"target\":{INDICES}}}],\
         \"buffers\":[{{\"byteLength\":{}}}]}}",
        -half,
        12 * vertices,
        12 * vertices,
        4 * corners,
        12 * vertices + 4 * corners,
    )
}
