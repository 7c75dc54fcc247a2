//! Writes the seeds of every target: `seeds FOLDER` makes `FOLDER/TARGET/NAME`.

#[path = "../../crates/io/tests/suite/common/copc.rs"]
mod copc;
#[path = "../../crates/io/tests/suite/common/e57.rs"]
mod e57;
#[path = "../../crates/io/tests/suite/common/gps.rs"]
mod gps;
#[path = "../../crates/io/tests/suite/common/las.rs"]
mod las;
#[path = "../../crates/io/tests/suite/common/parquet.rs"]
mod parquet;
#[path = "../../crates/io/tests/suite/common/seeds.rs"]
mod seeds;

use std::path::Path;

/// Targets that take an extension, beside `read_any` and `round_trip`, which take all.
fn target(name: &str) -> &'static str {
    match name.rsplit('.').next().unwrap_or_default() {
        "ply" => "read_ply",
        "obj" => "read_obj",
        "pcd" => "read_pcd",
        "las" => "read_las",
        "laz" => "read_laz",
        "e57" => "read_e57",
        "ptx" => "read_ptx",
        "stl" => "read_stl",
        "off" => "read_off",
        "npy" => "read_npy",
        "npz" => "read_npz",
        "parquet" => "read_parquet",
        "glb" | "gltf" => "read_glb",
        "expe" => "read_expe",
        _ => "read_table",
    }
}

fn main() -> std::io::Result<()> {
    let folder = std::env::args().nth(1).unwrap_or_else(|| "corpus".into());
    for (name, bytes) in seeds::seeds() {
        for target in [target(&name), "read_any", "round_trip"] {
            let folder = Path::new(&folder).join(target);
            std::fs::create_dir_all(&folder)?;
            std::fs::write(folder.join(&name), &bytes)?;
        }
    }
    Ok(())
}
