//! Edgelets: short pieces of crease, from cross-sections of the surface. Ours.
//!
//! Along a crease the surface does not change. `field` finds this direction at every point near a fold from the structure tensor
//! of the normals, and fits the normals anew to points in tubes along it, so that they keep to their face however narrow it is. At
//! seeds spread over the folds, `section` follows the field some spacings to either side and pools the points beside it in one
//! plane across. There `links` and `pieces` cut them to smooth pieces, and `corners` takes the places where two pieces meet at an
//! angle, `gaps` those that one of the two does not reach, `steps` the ends of parallel ones that face each other; `flat` tells
//! the sections of a face alone, `round` those of a pipe. `distinct` keeps the places that several cross-sections agree on.

mod blends;
mod corners;
mod distinct;
mod field;
mod flat;
mod gaps;
mod links;
mod moments;
mod pieces;
mod round;
mod section;
mod steps;

use crate::measure::Edgelet;
use crate::neighbors::Index;
use crate::parallel;
use crate::params::EdgeletParams;
use crate::surface::Scales;
use field::Field;
use links::Links;
use pieces::Pieces;
use section::Section;

/// Least certainty of the field at a seed.
const CERTAIN: f64 = 0.7;
/// Least number of seeds that a thread takes at a time: a cross-section takes half a millisecond.
const SEEDS: usize = 8;

/// An edgelet of one cross-section, with its weight in means.
#[derive(Clone, Copy, Debug)]
struct Weighted {
    edgelet: Edgelet,
    weight: f64,
}

/// What a cross-section shows: a corner, or no crease at its seed.
enum Seen {
    Corner(Weighted),
    Flat([f64; 3]),
}

/// What cross-sections show, local frame.
#[derive(Debug, Default)]
pub(crate) struct Found {
    /// Pieces of creases.
    pub(crate) edgelets: Vec<Edgelet>,
    /// The points at which a cross-section shows no crease.
    pub(crate) flat: Vec<[f64; 3]>,
    /// Pieces of the design edges of blends.
    pub(crate) blends: Vec<Edgelet>,
}

#[derive(Default)]
struct Scratch {
    corners: Vec<Weighted>,
    section: Section,
    links: Links,
    pieces: Pieces,
}

/// The edgelets of a cloud, local frame, and the points at which a cross-section shows no crease. `normals` are unit vectors of
/// either sign, a row for each point; none where they are absent, and none where the noise exceeds the limit.
pub(crate) fn edgelets(
    points: &[[f64; 3]],
    normals: &[[f32; 3]],
    scales: Scales,
    params: &EdgeletParams,
) -> Found {
    let noisy = scales.mean.noise > params.noise_spacings * scales.mean.spacing;
    if noisy || normals.len() != points.len() {
        return Default::default();
    }
    let index = Index::build(points);
    let field = Field::new(points, normals, &index, scales);
    let seeds = seeds(&field, params.apart_spacings);
    let seen = parallel::flat_map_with(seeds.len(), SEEDS, |scratch: &mut Scratch, i, out| {
        let Scratch { corners, section, links, pieces } = scratch;
        if section.take(&field, seeds[i]) {
            links.find(&section.points, section.noise);
            pieces.cut(section, links, params.evidence);
            corners::corners(section, links, pieces, params.turn_deg.to_radians(), corners);
            steps::steps(section, pieces, corners);
            if flat::is_flat(section, pieces, corners) || round::is_round(section, pieces, corners) {
                out.push(Seen::Flat(points[seeds[i]]));
            }
            out.extend(corners.drain(..).map(Seen::Corner));
        }
    });
    let (mut corners, mut flat) = (Vec::new(), Vec::new());
    for seen in seen {
        match seen {
            Seen::Corner(corner) => corners.push(corner),
            Seen::Flat(place) => flat.push(place),
        }
    }
    let edgelets = distinct::distinct(&corners, &index, params.agree);
    Found { edgelets, flat, blends: blends::blends(&field) }
}

/// Points at folds, in canonical order, none near an earlier one.
fn seeds(field: &Field, apart: f64) -> Vec<usize> {
    let mut gone = vec![false; field.points.len()];
    let mut seeds = Vec::new();
    for i in field.near.iter().map(|&i| i as usize) {
        let certain = field.along(i).is_some_and(|(_, grade)| grade >= CERTAIN);
        if certain && !gone[i] && field.changes(i) {
            let h = field.scales.at(i).spacing;
            field.around(field.points[i], apart, h, |f| gone[f.index as usize] = true);
            seeds.push(i);
        }
    }
    seeds
}

#[cfg(test)]
mod tests;
