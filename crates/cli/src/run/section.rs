//! `lineament section`.

use std::path::PathBuf;
use std::time::Instant;

use lineament::Cloud;
use lineament::section::{SectionParams, Sections, Zero, steps};
use lineament_io::{
    Report, SectionContext, section_format, write_report, write_section_stages, write_sections,
};

use super::slicing::{HEADER, cut, row, said};
use super::{page, stages};
use crate::args::Section;
use crate::batch::{self, Done};
use crate::failure::{Code, Failure};
use crate::source::{self, Origin};
use crate::{config, outputs, progress, summary};

/// Suffixes of the files that a folder gets.
const SUFFIXES: [&str; 2] = ["sections.json", "sections.dxf"];

/// Reads, slices, writes, and reports.
pub fn run(args: &Section) -> Result<(), Failure> {
    if source::is_list(&args.source) {
        return source::print_list();
    }
    if args.output.is_empty() {
        let failure = Failure::new(Code::Usage, "section: there is no default output");
        return Err(failure.advise("name at least one with -o, such as `-o sections.dxf`"));
    }
    config::threads(&args.running)?;
    let params = config::section(&args.slicing)?;
    let origins = source::origins(&args.source)?;
    let inputs = [source::files(&origins), args.slicing.settings.params.iter().cloned().collect()].concat();
    let plan = outputs::plan(&origins, &args.output, &SUFFIXES)?;
    outputs::check(&plan, &inputs, section_format)?;
    let several = origins.len() > 1;
    batch::run(&HEADER, &origins, &args.running, |i, origin| {
        one(args, origin, &inputs, &plan[i], &params, several)
    })
}

fn one(
    args: &Section,
    origin: &Origin,
    inputs: &[PathBuf],
    outputs: &[PathBuf],
    params: &SectionParams,
    several: bool,
) -> Result<Done, Failure> {
    let start = Instant::now();
    let hash = page::states_hash(outputs);
    let (input, sections, stack) = cut(&args.source, origin, params, hash, args.running.quiet)?;
    let context = SectionContext {
        program_version: env!("CARGO_PKG_VERSION").into(),
        input_name: input.name.clone(),
        input_sha256: input.sha256.clone(),
        input_points: input.cloud.len() as u64,
        crs: input.reference(),
        crs_wkt: input.wkt.clone(),
        millimetres: args.millimetres,
        unit: args.cad.stated.unit.or(input.unit),
        step: args.cad.step_protocol,
        stack,
    };
    for path in outputs {
        let inputs = [inputs, &input.beside].concat();
        outputs::write(path, || match page::is_page(path) {
            true => {
                let (provenance, sections) = (page::provenance(&input), Some((&sections, &context.stack)));
                let (cloud, up) = (Some(&input.cloud), input.up());
                write_report(path, &inputs, &Report { cloud, sections, up, ..Report::new(&provenance) })
            }
            false => write_sections(path, &inputs, &sections, &context),
        })?;
    }
    let staged = staged(args, origin, inputs, several, &input.cloud, &sections, params)?;
    let mut lines = said(&args.running, &input, &sections, &context.stack);
    if params.from == Zero::Floor && sections.zero.0 != Zero::Floor {
        lines.push("warning: no floor: no large level face with little of the surface below it".into());
    }
    lines.extend(summary::unplaced(&input, outputs));
    lines.extend(summary::unmeasured(context.known_unit(), outputs));
    lines.push(format!("{:.2} s", start.elapsed().as_secs_f64()));
    lines.push(summary::written(&[outputs, &staged].concat()));
    Ok(Done { lines, row: row(&input, &sections, start) })
}

/// The files of the steps to the sections, where they are asked for.
fn staged(
    args: &Section,
    origin: &Origin,
    inputs: &[PathBuf],
    several: bool,
    cloud: &Cloud,
    sections: &Sections,
    params: &SectionParams,
) -> Result<Vec<PathBuf>, Failure> {
    let Some(folder) = &args.stages else { return Ok(Vec::new()) };
    let named = progress::named("stages", args.running.quiet, || steps(cloud, params));
    let steps = named.map_err(|e| Failure::from(e).at(origin.shown()))?;
    let folder = stages::folder(folder, several, origin)?;
    outputs::write(&folder, || write_section_stages(&folder, inputs, cloud, (sections, &steps), params))
}
