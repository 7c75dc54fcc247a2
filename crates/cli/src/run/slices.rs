//! `lineament slices`.

use std::path::{Path, PathBuf};
use std::time::Instant;

use lineament::section::{SectionParams, Stack};
use lineament_io::write_slice_picture;

use super::slicing::{HEADER, cut, row, said};
use crate::args::Slices;
use crate::batch::{self, Done};
use crate::failure::Failure;
use crate::source::{self, Origin};
use crate::{config, outputs, summary};

/// Writes a picture of each slice. Of several inputs each gets a folder of its own, named after it.
pub fn run(args: &Slices) -> Result<(), Failure> {
    if source::is_list(&args.source) {
        return source::print_list();
    }
    config::threads(&args.running)?;
    let params = SectionParams { fit: false, ..config::section(&args.slicing)? };
    let origins = source::origins(&args.source)?;
    let inputs = [source::files(&origins), args.slicing.settings.params.iter().cloned().collect()].concat();
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
    outputs::make(folder)?;
    for plane in 0..sections.sections.len() {
        let path = folder.join(format!("slice_{plane:04}.svg"));
        outputs::write(&path, || write_slice_picture(&path, inputs, &sections, plane, args.millimetres))?;
    }
    let mut lines = said(&args.running, &input, &sections, &Stack::default());
    let count = summary::plural(sections.sections.len(), "picture");
    lines.push(format!("wrote {count} to {}", folder.display()));
    Ok(Done { lines, row: row(&input, &sections, start) })
}
