//! Cutting an input, and messages about its slices: shared by `section` and `slices`.

use std::time::Instant;

use lineament::math::vec3::dot;
use lineament::section::{Feature, SectionParams, Sections, Stack, Zero};
use lineament_io::ReadOptions;

use crate::args::{Running, Source};
use crate::failure::Failure;
use crate::source::{Input, Origin};
use crate::{progress, summary};

/// Heads of the table of many inputs.
pub const HEADER: [&str; 6] = ["input", "points", "slices", "contours", "closed", "seconds"];

pub fn cut(
    source: &Source,
    origin: &Origin,
    params: &SectionParams,
    hash: bool,
    quiet: bool,
) -> Result<(Input, Sections, Stack), Failure> {
    let options = ReadOptions { attributes: false, without_noise: true, hash, ..Default::default() };
    let input = progress::named("read", quiet, || origin.load(&source.reading, &options))?;
    let found = progress::sectioned(&input.cloud, params, quiet);
    let (sections, stack) = found.map_err(|e| Failure::from(e).at(origin.shown()))?;
    Ok((input, sections, stack))
}

fn closed(sections: &Sections) -> usize {
    sections.contours().filter(|(_, contour)| contour.closed).count()
}

pub fn row(input: &Input, sections: &Sections, start: Instant) -> Vec<String> {
    let counts = [input.cloud.len(), sections.sections.len(), sections.contours().count(), closed(sections)];
    let seconds = format!("{:.2}", start.elapsed().as_secs_f64());
    counts.map(summary::grouped).into_iter().chain([seconds]).collect()
}

pub fn said(running: &Running, input: &Input, sections: &Sections, stack: &Stack) -> Vec<String> {
    let points = summary::read(input, [input.cloud.len(), sections.dropped, sections.merged]);
    let spacing = summary::figure(sections.spacing);
    let mut lines = vec![points];
    lines.extend(summary::noise(input));
    if sections.clutter > 0 {
        lines.push(format!("not used: {} on no surface", summary::grouped(sections.clutter)));
    }
    lines.push(format!("spacing {spacing}, noise {:.2} spacings", sections.noise));
    lines.extend(summary::warnings(input));
    lines.extend(counted_from(sections));
    lines.extend(beside(input, sections));
    let position = |at: f64| summary::position(at, sections.spacing);
    let slices = summary::plural(sections.sections.len(), "slice");
    let contours = summary::plural(sections.contours().count(), "contour");
    lines.push(format!("{slices}, {contours}, {} closed", summary::grouped(closed(sections))));
    lines.extend(sections.sections.iter().filter_map(|section| {
        Some(format!(
            "slice {} at {}: {}",
            section.plane,
            position(section.height),
            section.missing?.reason()
        ))
    }));
    let shows_runs = running.verbose || stack.runs.len() <= 20;
    lines.extend(stack.runs.iter().filter(|_| shows_runs).map(|run| {
        let hole = if run.hole { " hole" } else { "" };
        let (from, to) = (position(run.from), position(run.to));
        let round = round(&run.feature).unwrap_or_default();
        format!("{}{hole}{round} from {from} to {to}: {} slices", run.feature.name(), run.contours.len())
    }));
    lines
}

/// The place that positions were counted from, where that is not the origin.
fn counted_from(sections: &Sections) -> Option<String> {
    let (zero, place) = sections.zero;
    let what = match zero {
        Zero::Origin => return None,
        Zero::Lowest => "lowest point",
        Zero::Floor => "floor",
    };
    Some(format!("positions count from the {what} at {}", summary::position(place, sections.spacing)))
}

/// A warning where no slice has a contour, with the extent of the scan along the axis as positions are counted.
fn beside(input: &Input, sections: &Sections) -> Option<String> {
    if sections.contours().next().is_some() || sections.heights.is_empty() {
        return None;
    }
    let (axis, zero) = (sections.frame.axes[2], sections.zero.1);
    let finite = input.cloud.positions.iter().filter(|p| p.iter().all(|c| c.is_finite()));
    let [low, high] = range(finite.map(|&p| dot(p, axis) - zero));
    let [first, last] = range(sections.heights.iter().map(|height| height - zero));
    let [low, high, first, last] = [low, high, first, last].map(|at| summary::position(at, sections.spacing));
    let slices = if first == last { format!("at {first}") } else { format!("from {first} to {last}") };
    Some(format!(
        "warning: no contour: the slices lie {slices}, and the scan extends from {low} to {high} along the axis"
    ))
}

/// The least and the greatest of some numbers.
fn range(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

/// The radius of a round feature, or the least and the greatest.
fn round(feature: &Feature) -> Option<String> {
    match *feature {
        Feature::Extrusion { radius } | Feature::Taper { radius, .. } => {
            radius.map(|r| format!(" r {}", summary::figure(r)))
        }
        Feature::Revolution { least, most } => {
            Some(format!(" r {} to {}", summary::figure(least), summary::figure(most)))
        }
    }
}
