//! The list of holes and straight edges of a result: in the summary, and as a file by `--report`.

use std::path::{Path, PathBuf};

use lineament::curve::pieces::Shape;
use lineament::inspect::{Inspection, RoundFeature, RoundKind, inspect};
use lineament::{Class, Cloud, Extraction};
use lineament_io::{list_format, write_list};

use crate::failure::{Code, Failure};
use crate::outputs;
use crate::source::Origin;
use crate::summary::{figure, grouped};
use crate::work::Work;

/// Circles up to which the summary tells what they are, as that takes a look at all points for each.
const MOST: usize = 100;
/// Holes and bosses that the summary tells one by one.
const TOLD: usize = 6;
/// Standard deviations of an interval of 95 %.
const U95: f64 = 1.96;

/// Refuses a list without a form, or one file for several inputs.
pub fn check(work: &Work, path: Option<&Path>) -> Result<(), Failure> {
    let Some(path) = path else { return Ok(()) };
    list_format(path).map_err(|e| Failure { code: Code::Usage, ..e.into() })?;
    if work.count() > 1 && !path.to_string_lossy().contains("{stem}") {
        let message = format!("--report {}: one file for {} inputs", path.display(), work.count());
        return Err(Failure::new(Code::Usage, message).advise("write {stem} for the name of the input"));
    }
    outputs::check_place(path, &work.inputs)
}

/// The list of a result; `None` where nothing asks for it and it would take long.
pub fn of(cloud: &Cloud, found: &Extraction, asked: bool) -> Option<Inspection> {
    let pieces = found.network.strips.iter().flat_map(|s| &s.curves);
    let rounds = pieces.filter(|p| matches!(p.shape, Shape::Circle(_) | Shape::Arc { .. })).count();
    if !asked && (rounds == 0 || rounds > MOST) {
        return None;
    }
    let classes = found.classes();
    let on_surface = |(i, p): &(usize, &[f64; 3])| {
        classes.get(*i) != Some(&Class::Clutter) && p.iter().all(|x| x.is_finite())
    };
    let points: Vec<[f64; 3]> =
        cloud.positions.iter().enumerate().filter(on_surface).map(|(_, p)| *p).collect();
    Some(inspect(&found.network, &points, found.report.spacing))
}

/// Holes and bosses for the summary.
pub fn told(found: &Inspection) -> Vec<String> {
    let named = |r: &&RoundFeature| matches!(r.kind, RoundKind::Hole | RoundKind::Boss);
    let all: Vec<&RoundFeature> = found.rounds.iter().filter(named).collect();
    let mut lines: Vec<String> = all.iter().take(TOLD).map(|r| line(r)).collect();
    if all.len() > TOLD {
        lines.push(format!("{} more holes and bosses: --report lists them", grouped(all.len() - TOLD)));
    }
    lines
}

fn line(round: &RoundFeature) -> String {
    let depth = round.depth().map_or(String::new(), |depth| {
        format!(", {} {}", figure(depth), if round.kind == RoundKind::Hole { "deep" } else { "high" })
    });
    let place = round.centres[0].map(figure).join(" ");
    // Without the sign of what rounds to nothing.
    let axis = round.axis.map(|x| format!("{:.3}", if x.abs() < 5e-4 { 0.0 } else { x })).join(" ");
    format!("{} of diameter {}{depth}, at {place} along {axis}", round.kind.name(), diameter(round))
}

/// The diameter with its tolerance, of which two digits are shown.
fn diameter(round: &RoundFeature) -> String {
    let tolerance = round.sigma.map(|s| U95 * s.diameter).filter(|t| *t > 0.0 && *t < round.diameter);
    let Some(tolerance) = tolerance else { return figure(round.diameter) };
    let decimals = (1.0 - tolerance.log10().floor()).clamp(0.0, 9.0) as usize;
    format!("{:.decimals$} ± {tolerance:.decimals$}", round.diameter)
}

/// Writes the list of an input; gives the name of the file.
pub fn write(
    path: Option<&Path>,
    others: &[PathBuf],
    inputs: &[PathBuf],
    origin: &Origin,
    name: &str,
    found: Option<&Inspection>,
) -> Result<Option<PathBuf>, Failure> {
    let (Some(path), Some(found)) = (path, found) else { return Ok(None) };
    let path = outputs::filled(path, origin);
    if others.contains(&path) {
        let message = format!("{}: named by -o and by --report", path.display());
        return Err(Failure::new(Code::Usage, message));
    }
    outputs::write(&path, || write_list(&path, inputs, name, found))?;
    Ok(Some(path))
}
