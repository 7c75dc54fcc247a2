//! `lineament evaluate`.

mod json;
mod picture;
mod table;

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use lineament::evaluate::{Lines, MarkScore, Score, Scoring, Stretch, marks, score, stretches};
use lineament_io::{LineFile, ReadOptions, read_lines, read_marks};

use crate::args::{Evaluate, Reading};
use crate::failure::{Code, Failure, say};
use crate::source::{Input, Origin, print};
use crate::{config, outputs, summary};

/// Greatest number of spacings that lines may be long: they are cut into pieces of a fifth, some hundred bytes each.
const LONGEST: f64 = 2e6;
/// Spacings from a line within which a point is taken as marked by it.
const MARKED: f64 = 1.0;

/// All that is told of a comparison.
struct Comparison<'a> {
    result: (&'a Path, LineFile),
    truth: (&'a Path, LineFile),
    spacing: f64,
    /// Where the spacing is from.
    stated: &'static str,
    /// The tolerance of `stretches`, in spacings.
    tolerance: f64,
    score: Score,
    stretches: Vec<Stretch>,
    marks: Vec<MarkScore>,
}

/// Reads both sides, scores, prints the table and writes what was asked for.
pub fn run(args: &Evaluate) -> Result<(), Failure> {
    config::threads(&args.running)?;
    picture::check(args)?;
    let inputs: Vec<PathBuf> =
        [Some(&args.result), args.truth.as_ref(), args.points.as_ref(), args.labels.as_ref()]
            .into_iter()
            .flatten()
            .cloned()
            .collect();
    outputs::check(std::slice::from_ref(&args.output), &inputs, known)?;
    let Some(truth) = &args.truth else { return of_marks(args, &inputs) };
    let scan = args.points.as_ref().map(|path| load(path)).transpose()?;
    let labels = args.labels.as_ref().map(|path| labels_of(path)).transpose()?;
    let compared = compare(args, truth, scan.as_ref(), labels.as_deref()).map_err(|e| of_points(args, e))?;
    print(&table::of(&compared))?;
    for path in &args.output {
        outputs::write(path, || match extension(path).as_str() {
            "json" => json::write(path, &inputs, &json::of(&compared)),
            _ => picture::write(path, &inputs, args, &compared, scan.as_ref()),
        })?;
    }
    tell_written(args);
    Ok(())
}

/// A failure with the advice that marks of points need, if the result holds some in place of lines.
fn of_points(args: &Evaluate, failure: Failure) -> Failure {
    match read_marks(&args.result) {
        Ok(_) => {
            failure.advise("it holds marks of points: compare them by --labels FILE in place of --truth")
        }
        Err(_) => failure,
    }
}

/// Names the files that were written, as all commands do.
fn tell_written(args: &Evaluate) {
    if !args.output.is_empty() && !args.running.quiet {
        say(&summary::written(&args.output));
    }
}

fn extension(path: &Path) -> String {
    path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase()).unwrap_or_default()
}

/// Accepts names that end in `.json`, `.png` or `.svg`.
fn known(path: &Path) -> Result<(), Failure> {
    if ["json", "png", "svg"].contains(&extension(path).as_str()) {
        return Ok(());
    }
    let message = format!("{}: end the name in `.json`, `.png` or `.svg`", path.display());
    Err(Failure::new(Code::Usage, message))
}

fn load(path: &Path) -> Result<Input, Failure> {
    Origin::File { path: path.into(), stem: OsString::new() }
        .load(&Reading::default(), &ReadOptions { attributes: false, ..Default::default() })
}

/// Labels as whole numbers; those beyond a byte are none.
fn labels_of(path: &Path) -> Result<Vec<u8>, Failure> {
    Ok(read_marks(path)?.into_iter().map(|label| label as u8).collect())
}

/// Marks of points against labels.
fn of_marks(args: &Evaluate, inputs: &[PathBuf]) -> Result<(), Failure> {
    let labels = args.labels.as_ref().map(|path| labels_of(path)).transpose()?.unwrap_or_default();
    let found: Vec<bool> = read_marks(&args.result)?.into_iter().map(|mark| mark > 0.0).collect();
    if found.len() != labels.len() {
        let message = format!("{}: {} marks for {} labels", args.result.display(), found.len(), labels.len());
        return Err(
            Failure::new(Code::Input, message).advise("give one mark for each label; for lines give --truth")
        );
    }
    let scores = marks(&found, &labels);
    print(&table::of_marks(&scores))?;
    for path in &args.output {
        if extension(path) != "json" {
            let message = format!("{}: marks have no picture", path.display());
            return Err(Failure::new(Code::Usage, message).advise("write JSON"));
        }
        outputs::write(path, || json::write(path, inputs, &json::of_marks(&scores)))?;
    }
    tell_written(args);
    Ok(())
}

fn compare<'a>(
    args: &'a Evaluate,
    truth_path: &'a Path,
    scan: Option<&Input>,
    labels: Option<&[u8]>,
) -> Result<Comparison<'a>, Failure> {
    let (result, truth) = (read_lines(&args.result, args.angle)?, read_lines(truth_path, args.angle)?);
    let (spacing, stated) = spacing(args, &result, &truth, scan)?;
    for (path, file) in [(args.result.as_path(), &result), (truth_path, &truth)] {
        refuse_long(path, &file.lines, spacing)?;
    }
    let positions = scan.map_or(&[][..], |scan| &scan.cloud.positions);
    if let Some(labels) = labels.filter(|labels| labels.len() != positions.len()) {
        let message = format!("--labels: {} labels for {} points", labels.len(), positions.len());
        return Err(Failure::new(Code::Input, message).advise("--points names the scan that they belong to"));
    }
    let labels = labels.unwrap_or(&[]);
    let aside =
        positions.iter().zip(labels).filter(|(p, label)| **label == 3 && p.iter().all(|x| x.is_finite()));
    let ignored: Vec<[f64; 3]> = aside.map(|(p, _)| *p).collect();
    let scoring = Scoring { spacing, tolerances: &args.tolerance, ignored: &ignored };
    let tolerance = args.tolerance.first().copied().unwrap_or(1.0);
    Ok(Comparison {
        spacing,
        stated,
        tolerance,
        score: score(&result.lines, &truth.lines, &scoring),
        stretches: stretches(&result.lines, &truth.lines, &scoring, tolerance),
        marks: if labels.is_empty() {
            Vec::new()
        } else {
            marks(&near(&result.lines, positions, spacing), labels)
        },
        result: (&args.result, result),
        truth: (truth_path, truth),
    })
}

/// The spacing, and where it is from.
fn spacing(
    args: &Evaluate,
    result: &LineFile,
    truth: &LineFile,
    scan: Option<&Input>,
) -> Result<(f64, &'static str), Failure> {
    if let Some(spacing) = args.spacing {
        return Ok((spacing, "--spacing"));
    }
    if let Some(spacing) = truth.spacing {
        return Ok((spacing, "of the truth"));
    }
    if let Some(scan) = scan {
        let surfels = lineament::apply::render::surfels(&scan.cloud);
        let (_, spacing) = surfels.map_err(|e| Failure::from(e).at(&scan.name))?;
        return Ok((spacing, "of the points"));
    }
    let stated = result.spacing.map(|spacing| (spacing, "of the result"));
    stated.ok_or_else(|| {
        Failure::new(
            Code::Usage,
            "neither file states the spacing of the points, which distances are measured in",
        )
        .advise("give --spacing, or the scan by --points")
    })
}

fn refuse_long(path: &Path, lines: &Lines, spacing: f64) -> Result<(), Failure> {
    let apart = |w: &[[f64; 3]]| lineament::math::vec3::distance(w[0], w[1]);
    let length: f64 = lines.lines.iter().map(|l| l.points.windows(2).map(apart).sum::<f64>()).sum();
    if length <= LONGEST * spacing {
        return Ok(());
    }
    let message = format!("{}: lines of {length} for a spacing of {spacing}", path.display());
    Err(Failure::new(Code::Refused, message)
        .advise(format!("lines of up to {LONGEST:e} spacings are compared: give a greater --spacing")))
}

/// Whether each point lies within a spacing of a line.
fn near(lines: &Lines, positions: &[[f64; 3]], spacing: f64) -> Vec<bool> {
    let index = lines.index(spacing / 5.0);
    positions
        .iter()
        .map(|&p| p.iter().all(|x| x.is_finite()) && index.distance(p) <= MARKED * spacing)
        .collect()
}
