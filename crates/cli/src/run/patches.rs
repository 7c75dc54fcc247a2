//! `lineament patches`.

use std::path::PathBuf;
use std::time::Instant;

use lineament::params::Auto;
use lineament::patch::{NO_PATCH, brep};
use lineament::{Attribute, Column, Extraction, Method, Params, Patches};
use lineament_io::{NetworkContext, PatchFormat, PointTable, ReadOptions, patch_format, write_patches};

use super::context::context;
use super::{page, stages};
use crate::args;
use crate::batch::Done;
use crate::failure::Failure;
use crate::source::{self, Origin};
use crate::summary::plural;
use crate::work::{self, Work};
use crate::{outputs, summary};

/// Suffixes of the files that a folder gets.
const SUFFIXES: [&str; 2] = ["patches.json", "patches.ply"];

/// Reads, extracts, finds the patches, and writes them as points, loops or both.
pub fn run(args: &args::Patches) -> Result<(), Failure> {
    if source::is_list(&args.work.source) {
        return source::print_list();
    }
    let params = Params { method: Method::Segments, ..Params::default() };
    let mut work = work::prepare_from(params, &args.work, &args.output, &SUFFIXES, patch_format)?;
    work.params.patches.find = Auto::Given(true);
    stages::keep(&mut work, args.stages.as_deref())?;
    work.each(|origin, outputs| one(&work, args, origin, outputs))
}

fn one(work: &Work, args: &args::Patches, origin: &Origin, outputs: &[PathBuf]) -> Result<Done, Failure> {
    let start = Instant::now();
    let is =
        |wanted: fn(PatchFormat) -> bool| outputs.iter().any(|path| patch_format(path).is_ok_and(wanted));
    let attributes = is(|f| matches!(f, PatchFormat::Points(_)));
    let hash = page::states_hash(outputs);
    let mut input =
        work.load(origin, &ReadOptions { attributes, without_noise: true, hash, ..Default::default() })?;
    let found = work.extract(origin, &input)?;
    let context = NetworkContext {
        unit: args.cad.stated.unit.or(input.unit),
        step: args.cad.step_protocol,
        ..context(&input, &work.params, &found)
    };
    let labels = found.patch_labels();
    input.cloud.attributes.insert(0, Attribute { name: "patch".into(), values: labels_column(&labels) });
    let classes: Vec<u8> = found.classes().into_iter().map(|class| class as u8).collect();
    let frame = input.frame();
    let table = PointTable { cloud: &input.cloud, classes: &classes, scores: &[], las: frame.as_deref() };
    let writing = Instant::now();
    let inputs = work.inputs_with(&input);
    for path in outputs {
        outputs::write(path, || match page::is_page(path) {
            true => page::extracted(path, &inputs, &input, &found, &context),
            false => write_patches(path, &inputs, &found.network, &context, &table),
        })?;
    }
    let staged = stages::write(work, args.stages.as_deref(), origin, &input.cloud, &found)?;
    let [wrote, total] = [writing, start].map(|t| t.elapsed().as_secs_f64());
    let mut lines = summary::of(&input, &found, work.args.running.verbose);
    lines.extend(found.patches.as_ref().map(|p| counts(p, &found)));
    lines.extend(summary::unplaced(&input, outputs));
    lines.extend(summary::other_version(&table, outputs));
    lines.extend(summary::unmeasured(context.known_unit(), outputs));
    lines.extend(found.patches.as_ref().filter(|_| is(|f| f == PatchFormat::Step)).map(|p| faces(p, &found)));
    lines.push(summary::times(&input, &found.report, wrote, total));
    lines.push(summary::written(&[outputs, &staged].concat()));
    Ok(Done { lines, row: summary::row(found.report.read, Some(&found.network), total) })
}

/// Labels as they are written: -1 for none.
fn labels_column(labels: &[u32]) -> Column {
    Column::I32(labels.iter().map(|&l| if l == NO_PATCH { -1 } else { l as i32 }).collect())
}

/// What became of the patches as faces.
fn faces(patches: &Patches, found: &Extraction) -> String {
    let brep = brep(&found.network, patches);
    let solids = brep.shells.iter().filter(|shell| shell.closed).count();
    let mut text =
        format!("STEP: {} in {}", plural(brep.faces.len(), "face"), plural(brep.shells.len(), "shell"));
    text += &format!(", {solids} closed; gaps up to {}", summary::figure(brep.gap));
    if !brep.omitted.is_empty() {
        let why = brep.omitted.iter().map(|(patch, why)| format!("{patch} ({})", why.reason()));
        text += &format!("; left out: {}", why.collect::<Vec<String>>().join(", "));
    }
    text
}

fn counts(patches: &Patches, found: &Extraction) -> String {
    let all = &patches.patches;
    let mut parts =
        vec![format!("{} patch{}", summary::grouped(all.len()), if all.len() == 1 { "" } else { "es" })];
    for kind in ["plane", "cylinder", "cone", "sphere", "torus"] {
        let count = all.iter().filter(|p| !p.fit.free && p.fit.surface.name() == kind).count();
        if count > 0 {
            parts.push(plural(count, kind));
        }
    }
    let open = all.iter().flat_map(|p| &p.loops).filter(|l| !l.closed).count();
    parts.push(plural(open, "open loop"));
    let creases = found.network.strips.iter().filter(|s| s.kind == lineament::StripKind::Crease).count();
    parts.push(format!("{} of {creases} creases lie between two patches", patches.separating()));
    parts.join(", ")
}
