//! The list of holes, other round features and straight edges, as text for people and as CSV.
//!
//! Tolerances are the half widths of intervals of 95 %, from the standard deviations of the fits.

use super::encode::json::Number;
use crate::error::Error;
use crate::output::Output;
use lineament::inspect::{Inspection, RoundFeature, RoundKind, StraightEdge};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Standard deviations of an interval of 95 %.
const U95: f64 = 1.959_963_985;
/// Decimals of directions and of angles in text.
const OF_AXES: usize = 5;
const OF_ANGLES: usize = 3;
/// Most decimals of lengths in text.
const MOST: f64 = 9.0;

/// The form of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ListFormat {
    /// Aligned columns.
    Text,
    /// A row for each feature.
    Csv,
}

/// The form by the extension: `.txt` or `.csv`; `-`, standard output, is text.
///
/// # Errors
/// [`Error::UnknownOutput`] with the extensions that are known.
pub fn list_format(path: &Path) -> Result<ListFormat, Error> {
    let extension = path.extension().map(|e| e.to_ascii_lowercase());
    match extension.as_ref().and_then(|e| e.to_str()) {
        _ if path.as_os_str() == "-" => Ok(ListFormat::Text),
        Some("txt") => Ok(ListFormat::Text),
        Some("csv") => Ok(ListFormat::Csv),
        _ => Err(Error::UnknownOutput {
            name: path.display().to_string(),
            kind: "lists",
            known: ".txt, .csv".into(),
        }),
    }
}

/// Writes a list to a file, whole or not at all, in the form of the extension. `name` is that of the input. `path` must be none of `inputs`.
///
/// # Errors
/// Those of [`list_format`] and [`Output::create`], and a failed write.
pub fn write_list(path: &Path, inputs: &[PathBuf], name: &str, found: &Inspection) -> Result<(), Error> {
    let format = list_format(path)?;
    Output::whole(path, inputs, |out| match format {
        ListFormat::Text => text(out, name, found),
        ListFormat::Csv => csv(out, found),
    })
}

/// The tolerance of a standard deviation; NaN where it is not known.
fn tolerance(sigma: Option<f64>) -> f64 {
    sigma.map_or(f64::NAN, |sigma| U95 * sigma)
}

fn csv(out: &mut dyn Write, found: &Inspection) -> io::Result<()> {
    write!(
        out,
        "feature,strips,x,y,z,to_x,to_y,to_z,axis_x,axis_y,axis_z,diameter,length,sweep_deg,fold_deg,"
    )?;
    writeln!(out, "u95_x,u95_y,u95_z,u95_axis_deg,u95_diameter,u95_offset")?;
    for round in &found.rounds {
        let strips: Vec<String> = round.strips.iter().map(usize::to_string).collect();
        write!(out, "{},{}", round.kind.name(), strips.join(" "))?;
        let last = round.centres.get(1).copied().unwrap_or([f64::NAN; 3]);
        let centre = round.sigma.map_or([f64::NAN; 3], |s| s.centre.map(|x| U95 * x));
        let figures = [round.diameter, round.depth().unwrap_or(f64::NAN), round.sweep_deg, f64::NAN];
        let known = [
            tolerance(round.sigma.map(|s| s.axis_deg)),
            tolerance(round.sigma.map(|s| s.diameter)),
            f64::NAN,
        ];
        cells(out, &[&round.centres[0], &last, &round.axis, &figures, &centre, &known])?;
    }
    for edge in &found.edges {
        write!(out, "{},{}", edge_name(edge), edge.strip)?;
        let figures = [f64::NAN, edge.length, f64::NAN, edge.fold_deg.unwrap_or(f64::NAN)];
        let [offset, direction] = [0, 1].map(|i| tolerance(edge.sigma.map(|s| s[i])));
        let [from, to] = &edge.ends;
        cells(out, &[from, to, &edge.direction, &figures, &[f64::NAN; 3], &[direction, f64::NAN, offset]])?;
    }
    Ok(())
}

fn edge_name(edge: &StraightEdge) -> String {
    format!("straight {}", edge.kind.name())
}

/// Numbers behind commas, and the end of the row; a number that is not known is empty.
fn cells(out: &mut dyn Write, rows: &[&[f64]]) -> io::Result<()> {
    for &value in rows.iter().copied().flatten() {
        match value.is_finite() {
            true => write!(out, ",{}", Number(value))?,
            false => write!(out, ",")?,
        }
    }
    writeln!(out)
}

fn text(out: &mut dyn Write, name: &str, found: &Inspection) -> io::Result<()> {
    writeln!(out, "{}", crate::error::printable(name))?;
    writeln!(out, "lengths in the unit of the input; tolerances are those of 95 %")?;
    let decimals = decimals(found);
    let groups: [(&str, &[RoundKind]); 3] = [
        ("holes and bosses", &[RoundKind::Hole, RoundKind::Boss]),
        ("other circles", &[RoundKind::Circle]),
        ("arcs", &[RoundKind::Arc]),
    ];
    for (title, kinds) in groups {
        let some: Vec<&RoundFeature> = found.rounds.iter().filter(|r| kinds.contains(&r.kind)).collect();
        let head = [
            "kind",
            "diameter",
            "+-",
            "depth",
            "x",
            "y",
            "z",
            "+-",
            "along x",
            "y",
            "z",
            "+- deg",
            "sweep deg",
            "strips",
        ];
        table(out, title, &head, some.iter().map(|r| round_cells(r, decimals)).collect())?;
    }
    let head = [
        "kind", "length", "x", "y", "z", "to x", "y", "z", "+-", "along x", "y", "z", "+- deg", "fold deg",
        "strip",
    ];
    table(out, "straight edges", &head, found.edges.iter().map(|e| edge_cells(e, decimals)).collect())
}

/// Decimals that show two digits of the least tolerance of a length; without one, those of a thousandth of the greatest figure.
fn decimals(found: &Inspection) -> usize {
    let rounds = found.rounds.iter().filter_map(|r| Some(r.sigma?.diameter));
    let edges = found.edges.iter().filter_map(|e| Some(e.sigma?[0]));
    let least = rounds.chain(edges).filter(|s| *s > 0.0).fold(f64::INFINITY, f64::min) * U95;
    let sizes = found.rounds.iter().map(|r| r.diameter).chain(found.edges.iter().map(|e| e.length));
    let unit = if least.is_finite() { least } else { sizes.fold(0.0, f64::max) / 1000.0 };
    if unit > 0.0 { (1.0 - unit.log10().floor()).clamp(0.0, MOST) as usize } else { 3 }
}

/// A number with so many decimals; `-` where it is not known.
fn shown(value: f64, decimals: usize) -> String {
    if !value.is_finite() {
        return "-".into();
    }
    let text = format!("{value:.decimals$}");
    // Without the sign of what rounds to nothing.
    let nothing = text.strip_prefix('-').filter(|rest| rest.bytes().all(|b| b == b'0' || b == b'.'));
    nothing.map_or(text.clone(), String::from)
}

fn round_cells(round: &RoundFeature, decimals: usize) -> Vec<String> {
    let sigma = round.sigma;
    let centre = sigma.map(|s| s.centre.iter().copied().fold(0.0, f64::max));
    let mut cells = vec![round.kind.name().to_string(), shown(round.diameter, decimals)];
    cells.push(shown(tolerance(sigma.map(|s| s.diameter)), decimals));
    cells.push(shown(round.depth().unwrap_or(f64::NAN), decimals));
    cells.extend(round.centres[0].map(|x| shown(x, decimals)));
    cells.push(shown(tolerance(centre), decimals));
    cells.extend(round.axis.map(|x| shown(x, OF_AXES)));
    cells.push(shown(tolerance(sigma.map(|s| s.axis_deg)), OF_ANGLES));
    cells.push(shown(round.sweep_deg, OF_ANGLES));
    cells.push(round.strips.iter().map(usize::to_string).collect::<Vec<_>>().join(" "));
    cells
}

fn edge_cells(edge: &StraightEdge, decimals: usize) -> Vec<String> {
    let mut cells = vec![edge.kind.name().to_string(), shown(edge.length, decimals)];
    cells.extend(edge.ends.as_flattened().iter().map(|&x| shown(x, decimals)));
    cells.push(shown(tolerance(edge.sigma.map(|s| s[0])), decimals));
    cells.extend(edge.direction.map(|x| shown(x, OF_AXES)));
    cells.push(shown(tolerance(edge.sigma.map(|s| s[1])), OF_ANGLES));
    cells.push(shown(edge.fold_deg.unwrap_or(f64::NAN), OF_ANGLES));
    cells.push(edge.strip.to_string());
    cells
}

/// Rows under a title, columns aligned to the right; nothing without rows.
fn table(out: &mut dyn Write, title: &str, head: &[&str], rows: Vec<Vec<String>>) -> io::Result<()> {
    if rows.is_empty() {
        return Ok(());
    }
    writeln!(out, "\n{title}: {}", rows.len())?;
    let head: Vec<String> = head.iter().map(|cell| cell.to_string()).collect();
    let width = |column: usize| {
        let cells = rows.iter().chain([&head]).filter_map(|row| row.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    for row in [&head].into_iter().chain(&rows) {
        let cells =
            row.iter().enumerate().map(|(column, cell)| format!("{cell:>width$}", width = width(column)));
        writeln!(out, "{}", cells.collect::<Vec<String>>().join("  "))?;
    }
    Ok(())
}
