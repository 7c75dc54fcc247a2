//! The groups of the points beside strips and around nodes, and the places recovered (Gumhold 2001, sections 4.1 and 4.2).

use crate::write::encode::ply;
use lineament::{Cloud, Extraction, Grouped, RecoveredPlace};
use std::io::{self, Write};

/// The points of the groups, with the row of the input, the strip or node (`of`) and the face of each.
pub(super) fn groups(
    out: &mut dyn Write,
    cloud: &Cloud,
    found: &Extraction,
    of: &str,
    groups: &[Grouped],
) -> io::Result<()> {
    let columns = [("int", "point"), ("int", of), ("int", "face")];
    ply::header(out, &[], &[ply::vertices(groups.len(), &columns)])?;
    let number = |i: u32| ply::index(i as usize).map(i32::to_le_bytes);
    for g in groups {
        let row = found.source[g.point as usize];
        let more = [number(row)?, number(g.of)?, number(g.face)?].concat();
        ply::vertex(out, cloud.positions[row as usize], &more)?;
    }
    Ok(())
}

/// The places with their strip or node (-1 for none), the fold of the faces (not a number at a corner) and standard deviations.
pub(super) fn recovered(
    out: &mut dyn Write,
    found: &Extraction,
    places: &[RecoveredPlace],
) -> io::Result<()> {
    let columns = [
        ("int", "strip"),
        ("int", "node"),
        ("float", "fold_deg"),
        ("float", "sigma_x"),
        ("float", "sigma_y"),
        ("float", "sigma_z"),
    ];
    ply::header(out, &[], &[ply::vertices(places.len(), &columns)])?;
    let unit = found.frame.length_to_world(1.0);
    let number = |i: Option<u32>| i.map_or(Ok(-1), |i| ply::index(i as usize)).map(i32::to_le_bytes);
    for place in places {
        let fold = place.fold_deg.unwrap_or(f64::NAN);
        let [x, y, z] = place.sigma.map(|s| unit * s);
        let values = [fold, x, y, z].map(|v| (v as f32).to_le_bytes()).concat();
        let more = [&number(place.strip)?[..], &number(place.node)?, &values].concat();
        ply::vertex(out, found.frame.to_world(place.at), &more)?;
    }
    Ok(())
}
