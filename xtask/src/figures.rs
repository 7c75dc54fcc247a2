//! Figures such as those of Gumhold 2001, of generated scans, so that everyone can make them again.
//!
//! Not made: figures 3 and 4, which show the Delaunay filter on scans of a torso and of a bunny, the brain of figure 13, and the frog of
//! figure 14, as these models are not ours; figures 5 to 7 and 9, which are sketches of the method, except for the score that 6
//! and 7 explain.

use std::path::Path;

use crate::workspace::{cargo, root, succeed};

/// A figure: its name, and the arguments of the program that draws it, `{out}` standing for the folder.
type Figure = (&'static str, &'static [&'static str]);

/// Pictures of 800 by 600 pixels.
const SMALL: [&str; 3] = ["--size", "800x600", "--quiet"];

#[rustfmt::skip]
const FIGURES: [Figure; 15] = [
    ("figure-1", &["--sample", "brick", "--style", "lines"]),
    ("figure-2-a-points", &["--sample", "star-prism", "--network", "none"]),
    ("figure-2-c-score", &["--sample", "star-prism", "--point-color", "score", "--hidden", "none"]),
    ("figure-2-f-splines", &["--sample", "star-prism", "--style", "lines"]),
    ("figure-6-score", &["--sample", "random-cube", "--method", "penalty", "--point-color", "score", "--hidden", "none"]),
    ("figure-8-a-zigzag", &["--sample", "sheet", "--method", "penalty", "--set", "spline.smoothing=0.000001", "--set", "spline.span_spacings=0.5", "--style", "lines"]),
    ("figure-8-d-smoothed", &["--sample", "sheet", "--method", "penalty", "--style", "lines"]),
    ("figure-10-b-splines", &["--sample", "wedge", "--method", "penalty", "--set", "recover.wedge=none", "--style", "lines"]),
    ("figure-10-d-recovered", &["--sample", "wedge", "--method", "penalty", "--set", "recover.wedge=paper", "--style", "lines"]),
    ("figure-11-d-splines", &["--sample", "random-cube", "--method", "penalty", "--set", "recover.wedge=none", "--surface", "none", "--style", "lines"]),
    ("figure-11-f-corners", &["--sample", "random-cube", "--method", "penalty", "--set", "recover.wedge=paper", "--surface", "none", "--style", "lines"]),
    ("figure-12-b-plain", &["--sample", "cylinders", "--surface", "{out}/plain.ply", "--network", "none"]),
    ("figure-12-c-enriched", &["--sample", "cylinders", "--surface", "{out}/enriched.ply", "--network", "none"]),
    ("figure-13", &["--sample", "pipe-cross", "--point-color", "patch"]),
    ("figure-14", &["--sample", "stepped-shaft", "--style", "lines", "--color", "ink", "--hidden", "none"]),
];

/// Meshes that figures show: the file, and what `mesh` is told.
const MESHES: [(&str, &[&str]); 2] = [("plain.ply", &["--no-enrich"]), ("enriched.ply", &[])];

/// Draws the figures whose names begin with `name` into `out/figures`, by a program of this profile of cargo, `release` unless named.
///
/// # Errors
/// A folder that cannot be made, and a command that fails.
pub fn run(name: &str, profile: Option<&str>) -> Result<(), String> {
    let folder = root().join("out").join("figures");
    std::fs::create_dir_all(&folder).map_err(|e| format!("cannot make {}: {e}", folder.display()))?;
    let chosen: Vec<&Figure> = FIGURES.iter().filter(|(figure, _)| figure.starts_with(name)).collect();
    if chosen.is_empty() {
        let names: Vec<&str> = FIGURES.iter().map(|(figure, _)| *figure).collect();
        return Err(format!("no figure is named `{name}`: there are {}", names.join(", ")));
    }
    for (file, options) in MESHES {
        let shown = |(_, args): &&Figure| args.iter().any(|arg| arg.ends_with(file));
        if chosen.iter().any(shown) {
            let output = folder.join(file);
            let args = [&["mesh", "--sample", "cylinders", "--quiet"], options].concat();
            program(&args, &output, &folder, profile)?;
        }
    }
    for (figure, args) in chosen {
        let args = [&["render"], *args, &SMALL].concat();
        program(&args, &folder.join(format!("{figure}.png")), &folder, profile)?;
        println!("{figure}.png: lineament {}", args.join(" ").replace("{out}", "out/figures"));
    }
    Ok(())
}

/// Runs the program from these sources.
fn program(args: &[&str], output: &Path, folder: &Path, profile: Option<&str>) -> Result<(), String> {
    let mut command = cargo();
    command.args([
        "run",
        "--quiet",
        "--locked",
        "--profile",
        profile.unwrap_or("release"),
        "--package",
        "lineament-cli",
        "--",
    ]);
    command.args(args.iter().map(|arg| arg.replace("{out}", &folder.display().to_string())));
    succeed(command.arg("-o").arg(output))
}
