//! Lesson 3: the smooth patches between the lines, and the surface of each. `cargo run --example 03_patches` writes
//! `flange.json`.

use lineament::params::Auto;
use lineament::patch::Surface;
use lineament::shapes::{Sampling, Scan, flange};
use lineament::{Method, Params, extract};
use lineament_io::{NetworkContext, write_network};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cloud = flange().sample(&Scan::new(Sampling::BlueNoise { count: 30_000 }).seed(2)).cloud;

    // The method `segments` (Demarsin 2007) closes its lines, so that they bound patches.
    let mut params = Params { method: Method::Segments, ..Params::default() };
    params.patches.find = Auto::Given(true);
    let found = extract(&cloud, &params)?;
    let patches = found.patches.as_ref().ok_or("no patches, although they were asked for")?;

    // Each patch has an area, loops of strips around it, neighbours, and the surface that fits it best.
    for (id, patch) in patches.patches.iter().enumerate() {
        let (kind, residual) = (patch.fit.surface.name(), patch.fit.residual);
        println!(
            "patch {id}: {kind}, area {:.2}, {} loops, residual {residual:.4}",
            patch.area,
            patch.loops.len()
        );
    }
    let cylinders =
        patches.patches.iter().filter(|p| matches!(p.fit.surface, Surface::Cylinder { .. })).count();
    assert!(cylinders >= 2, "a flange has a bore and a rim");

    // Labels of the points: the index of a patch, or `patch::NO_PATCH` beside the lines.
    assert_eq!(found.patch_labels().len(), cloud.len());

    let context = NetworkContext { patches: found.patches.clone(), ..NetworkContext::default() };
    write_network("flange.json".as_ref(), &[], &found.network, &context)?;
    Ok(())
}
