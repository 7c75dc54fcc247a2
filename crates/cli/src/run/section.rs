//! `lineament section` and `lineament slices`.

use std::path::{Path, PathBuf};
use std::time::Instant;

use lineament::section::{self, SectionParams, Sections, Stack};
use lineament_io::{ReadOptions, SectionContext, section_format, write_sections, write_slice_picture};

use crate::failure::{Code, Failure};
use crate::section_args::{Section, Slices, Slicing};
use crate::source::{self, Input};
use crate::{args, config, outputs, summary};

/// Reads, slices, writes, and says what came of it.
pub fn run(args: &Section) -> Result<(), Failure> {
    if source::is_list(&args.source) {
        return source::print_list();
    }
    let start = Instant::now();
    config::threads(&args.running)?;
    let params = checked(&args.slicing)?;
    outputs::check(&args.output, &source::files(&args.source), section_format)?;
    let (input, sections) = cut(&args.source, &params)?;
    let stack = if params.fit {
        section::stack(&input.cloud, &sections).map_err(|e| Failure::from(e).at(&input.name))?
    } else {
        Stack::default()
    };
    let context = SectionContext {
        program_version: env!("CARGO_PKG_VERSION").into(),
        input_name: input.name.clone(),
        input_sha256: input.sha256.clone(),
        input_points: input.cloud.len() as u64,
        stack,
    };
    for path in &args.output {
        outputs::write(path, || write_sections(path, &input.files, &sections, &context))?;
    }
    if !args.running.quiet {
        report(&args.running, &input, &sections, &context.stack);
        eprintln!("{:.2} s\n{}", start.elapsed().as_secs_f64(), summary::written(&args.output));
    }
    Ok(())
}

/// Writes a picture a slice.
pub fn slices(args: &Slices) -> Result<(), Failure> {
    if source::is_list(&args.source) {
        return source::print_list();
    }
    config::threads(&args.running)?;
    let params = SectionParams { fit: false, ..checked(&args.slicing)? };
    std::fs::create_dir_all(&args.output)
        .map_err(|e| Failure::new(Code::Output, format!("{}: {e}", args.output.display())))?;
    let (input, sections) = cut(&args.source, &params)?;
    let pictures: Vec<PathBuf> = (0..sections.sections.len()).map(|k| picture(&args.output, k)).collect();
    for (plane, path) in pictures.iter().enumerate() {
        outputs::write(path, || write_slice_picture(path, &input.files, &sections, plane))?;
    }
    if !args.running.quiet {
        report(&args.running, &input, &sections, &Stack::default());
        eprintln!("wrote {} to {}", summary::plural(pictures.len(), "picture"), args.output.display());
    }
    Ok(())
}

fn picture(folder: &Path, plane: usize) -> PathBuf {
    folder.join(format!("slice_{plane:04}.svg"))
}

fn checked(slicing: &Slicing) -> Result<SectionParams, Failure> {
    let params = slicing.params();
    params.check()?;
    Ok(params)
}

fn cut(source: &args::Source, params: &SectionParams) -> Result<(Input, Sections), Failure> {
    let input = source::load(source, &ReadOptions { attributes: false, hash: true, ..Default::default() })?;
    let sections = section::section(&input.cloud, params).map_err(|e| Failure::from(e).at(&input.name))?;
    Ok((input, sections))
}

fn report(running: &args::Running, input: &Input, sections: &Sections, stack: &Stack) {
    let contours = sections.contours().count();
    let closed = sections.contours().filter(|(_, c)| c.closed).count();
    eprintln!(
        "{}: {} points, spacing {}, noise {:.2} spacings",
        input.name,
        summary::grouped(input.cloud.len()),
        summary::figure(sections.spacing),
        sections.noise
    );
    let slices = summary::plural(sections.sections.len(), "slice");
    eprintln!("{slices}, {}, {closed} closed", summary::plural(contours, "contour"));
    for section in &sections.sections {
        if let Some(missing) = section.missing {
            eprintln!("slice {} at {}: {}", section.plane, summary::figure(section.height), missing.reason());
        }
    }
    let verbose = running.verbose || stack.runs.len() <= 20;
    for run in stack.runs.iter().filter(|_| verbose) {
        let hole = if run.hole { " hole" } else { "" };
        let (from, to) = (summary::figure(run.from), summary::figure(run.to));
        eprintln!("{}{hole} from {from} to {to}: {} slices", run.feature.name(), run.contours.len());
    }
}
