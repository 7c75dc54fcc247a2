//! Lesson 4: cross-sections, and the features that a stack of them shows. `cargo run --example 04_section` writes
//! `shaft.svg` and `shaft.dxf`.

use lineament::section::{Axis, Feature, Planes, SectionParams, section, stack};
use lineament::shapes::{Sampling, Scan, stepped_shaft};
use lineament_io::{SectionContext, write_sections};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cloud = stepped_shaft().sample(&Scan::new(Sampling::BlueNoise { count: 40_000 }).seed(1)).cloud;

    // Forty slices along z. With `fit` each contour is described by lines, arcs, circles and splines.
    let params = SectionParams {
        axis: Axis::Coordinate(2),
        planes: Planes::Count(40),
        fit: true,
        ..SectionParams::default()
    };
    let sections = section(&cloud, &params)?;
    for (plane, contour) in sections.contours().take(3) {
        let shapes: Vec<&str> = contour.pieces.iter().map(|piece| piece.shape.name()).collect();
        println!("slice {plane}: closed {}, area {:.3}, {shapes:?}", contour.closed, contour.area);
    }

    // Contours of one shape in neighbouring slices form a run: an extrusion, a taper or a revolution.
    let stack = stack(&cloud, &sections, &params)?;
    for run in &stack.runs {
        println!("{} from {:.3} to {:.3}: {:?}", run.feature.name(), run.from, run.to, run.feature);
    }
    let round = |feature: &Feature| matches!(feature, Feature::Extrusion { radius: Some(_) });
    assert!(stack.runs.iter().filter(|run| round(&run.feature)).count() >= 3, "the steps of the shaft");

    let context = SectionContext { stack, ..SectionContext::default() };
    for name in ["shaft.svg", "shaft.dxf"] {
        write_sections(name.as_ref(), &[], &sections, &context)?;
    }
    Ok(())
}
