//! `lineament section` and `lineament slices`.

use std::path::{Path, PathBuf};
use std::time::Instant;

use lineament::section::{Feature, SectionParams, Sections, Stack};
use lineament_io::{
    ReadOptions, SectionContext, SectionFormat, section_format, write_sections, write_slice_picture,
};

use crate::args::Running;
use crate::batch::{self, Done};
use crate::failure::{Code, Failure};
use crate::section_args::{Section, Slices, Slicing};
use crate::source::{self, Input, Origin};
use crate::{args, config, outputs, progress, summary};

/// What a folder gets.
const SUFFIXES: [&str; 2] = ["sections.json", "sections.dxf"];
/// Heads of the table of many inputs.
const HEADER: [&str; 6] = ["input", "points", "slices", "contours", "closed", "seconds"];

/// Reads, slices, writes, and says what came of it.
pub fn run(args: &Section) -> Result<(), Failure> {
    if source::is_list(&args.source) {
        return source::print_list();
    }
    config::threads(&args.running)?;
    let params = checked(&args.slicing)?;
    let origins = source::origins(&args.source)?;
    let inputs = source::files(&origins);
    let plan = outputs::plan(&origins, &args.output, &SUFFIXES)?;
    outputs::check(&plan, &inputs, section_format)?;
    batch::run(&HEADER, &origins, &args.running, |i, origin| one(args, origin, &inputs, &plan[i], &params))
}

fn one(
    args: &Section,
    origin: &Origin,
    inputs: &[PathBuf],
    outputs: &[PathBuf],
    params: &SectionParams,
) -> Result<Done, Failure> {
    let start = Instant::now();
    let hash = outputs.iter().any(|path| matches!(section_format(path), Ok(SectionFormat::Json)));
    let (input, sections, stack) = cut(&args.source, origin, params, hash, args.running.quiet)?;
    let context = SectionContext {
        program_version: env!("CARGO_PKG_VERSION").into(),
        input_name: input.name.clone(),
        input_sha256: input.sha256.clone(),
        input_points: input.cloud.len() as u64,
        stack,
    };
    for path in outputs {
        outputs::write(path, || write_sections(path, inputs, &sections, &context))?;
    }
    let mut lines = said(&args.running, &input, &sections, &context.stack);
    lines.push(format!("{:.2} s", start.elapsed().as_secs_f64()));
    lines.push(summary::written(outputs));
    Ok(Done { lines, row: row(&input, &sections, start) })
}

/// Writes a picture a slice. Of several inputs each gets a folder of its own, named after it.
pub fn slices(args: &Slices) -> Result<(), Failure> {
    if source::is_list(&args.source) {
        return source::print_list();
    }
    config::threads(&args.running)?;
    let params = SectionParams { fit: false, ..checked(&args.slicing)? };
    let origins = source::origins(&args.source)?;
    let inputs = source::files(&origins);
    batch::run(&HEADER, &origins, &args.running, |_, origin| {
        let folder = if origins.len() > 1 { args.output.join(origin.stem()) } else { args.output.clone() };
        pictures(args, origin, &inputs, &folder, &params)
    })
}

fn pictures(
    args: &Slices,
    origin: &Origin,
    inputs: &[PathBuf],
    folder: &Path,
    params: &SectionParams,
) -> Result<Done, Failure> {
    let start = Instant::now();
    let (input, sections, _) = cut(&args.source, origin, params, false, args.running.quiet)?;
    std::fs::create_dir_all(folder).map_err(|e| {
        Failure::new(Code::Output, format!("{}: cannot make the folder: {e}", folder.display()))
    })?;
    for plane in 0..sections.sections.len() {
        let path = folder.join(format!("slice_{plane:04}.svg"));
        outputs::write(&path, || write_slice_picture(&path, inputs, &sections, plane))?;
    }
    let mut lines = said(&args.running, &input, &sections, &Stack::default());
    let count = summary::plural(sections.sections.len(), "picture");
    lines.push(format!("wrote {count} to {}", folder.display()));
    Ok(Done { lines, row: row(&input, &sections, start) })
}

fn checked(slicing: &Slicing) -> Result<SectionParams, Failure> {
    let params = slicing.params();
    params.check()?;
    Ok(params)
}

fn cut(
    source: &args::Source,
    origin: &Origin,
    params: &SectionParams,
    hash: bool,
    quiet: bool,
) -> Result<(Input, Sections, Stack), Failure> {
    let input =
        origin.load(&source.reading, &ReadOptions { attributes: false, hash, ..Default::default() })?;
    let found = progress::sectioned(&input.cloud, params, quiet);
    let (sections, stack) = found.map_err(|e| Failure::from(e).at(origin.shown()))?;
    Ok((input, sections, stack))
}

fn closed(sections: &Sections) -> usize {
    sections.contours().filter(|(_, contour)| contour.closed).count()
}

fn row(input: &Input, sections: &Sections, start: Instant) -> Vec<String> {
    let counts = [input.cloud.len(), sections.sections.len(), sections.contours().count(), closed(sections)];
    let seconds = format!("{:.2}", start.elapsed().as_secs_f64());
    counts.map(summary::grouped).into_iter().chain([seconds]).collect()
}

fn said(running: &Running, input: &Input, sections: &Sections, stack: &Stack) -> Vec<String> {
    let points = summary::read(input, [input.cloud.len(), sections.dropped, sections.merged]);
    let spacing = summary::figure(sections.spacing);
    let mut lines = vec![points, format!("spacing {spacing}, noise {:.2} spacings", sections.noise)];
    lines.extend(input.missing.iter().map(|missing| format!("warning: {missing}")));
    let slices = summary::plural(sections.sections.len(), "slice");
    let contours = summary::plural(sections.contours().count(), "contour");
    lines.push(format!("{slices}, {contours}, {} closed", summary::grouped(closed(sections))));
    lines.extend(sections.sections.iter().filter_map(|section| {
        let height = summary::figure(section.height);
        Some(format!("slice {} at {height}: {}", section.plane, section.missing?.reason()))
    }));
    let shows_runs = running.verbose || stack.runs.len() <= 20;
    lines.extend(stack.runs.iter().filter(|_| shows_runs).map(|run| {
        let hole = if run.hole { " hole" } else { "" };
        let (from, to) = (summary::figure(run.from), summary::figure(run.to));
        let round = round(&run.feature).unwrap_or_default();
        format!("{}{hole}{round} from {from} to {to}: {} slices", run.feature.name(), run.contours.len())
    }));
    lines
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
