//! Lesson 1: from a scan to its feature lines. `cargo run --example 01_extract` writes `bracket.obj` and `bracket.json`.
//!
//! Each lesson takes a generated scan, so that it runs anywhere and its answer is known. For a scan of your own replace
//! the first statement by `let cloud = lineament_io::read("part.ply".as_ref(), &Default::default())?.cloud;`.

use lineament::shapes::{Sampling, Scan, bracket};
use lineament::{NodeKind, Params, StripKind, extract};
use lineament_io::{NetworkContext, write_network};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Points on an L-shaped bracket: 20,000 of them, with noise of a twentieth of their spacing. The unit is free.
    let cloud = bracket().sample(&Scan::new(Sampling::BlueNoise { count: 20_000 }).noise(0.05).seed(1)).cloud;

    // The whole pipeline. The defaults suit most scans: parameters count in spacings, not in units of the input.
    let found = extract(&cloud, &Params::default())?;
    println!("spacing {:.4}, noise {:.4}", found.report.spacing, found.report.noise);

    // A strip is an ordered curve. A closed one is a loop; any other runs from one node to another.
    for strip in &found.network.strips {
        let ends =
            if strip.closed { "a loop".into() } else { format!("{:?} to {:?}", strip.start, strip.end) };
        println!("{} of length {:.2}, {ends}", strip.kind.name(), strip.length());
    }

    // A solid has creases and no borders, and nearly all of its lines run from corner to corner or around a bore.
    let creases = found.network.strips.iter().filter(|strip| strip.kind == StripKind::Crease).count();
    assert_eq!(creases, found.network.strips.len());
    assert!(found.network.count(NodeKind::Junction) > 10);

    // The extension chooses the format. The second argument lists the inputs, none of which may be overwritten.
    for name in ["bracket.obj", "bracket.json"] {
        write_network(name.as_ref(), &[], &found.network, &NetworkContext::default())?;
    }
    Ok(())
}
