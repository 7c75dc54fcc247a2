//! A crease candidate: its direction, its foot, and the evidence of its cross-section.

use super::fold::CrossSection;
use super::sharpness::sharpness;
use super::sides::Sides;
use super::surroundings::{Surroundings, shift};
use crate::math::vec3::{add, norm, scale};
use crate::measure::{Evidence, Row};

/// Evidence at which a single point lies on a round for certain, whatever the evidence along its line.
const CLEARLY_SMOOTH: f32 = -4.0;

/// The candidate at point `i` with a scalar `penalty`; `None` if its cross-section is clearly smooth. `wide` are the points
/// from which the cross-section is taken; `section` is scratch.
///
/// Its direction is the least axis of the tensor of the normals. At a corner the least eigenvalue is large too, so that no
/// direction is preferred and there is no single cross-section.
pub(crate) fn crease(
    surroundings: &Surroundings,
    i: usize,
    sides: &Sides,
    penalty: f64,
    wide: &[u32],
    section: &mut CrossSection,
) -> Option<Row> {
    let Surroundings { points, least_fold, .. } = surroundings;
    let resolution = surroundings.scales.at(i);
    let Sides { tensor, pull, pair } = sides;
    let [least, middle, _] = tensor.values.map(|x| x.max(0.0));
    let corner = least.sqrt() > *least_fold;
    let shift = shift(tensor, *pull, if corner { 0 } else { 1 });
    let reach = 2.0 * resolution.unit() + 2.0 * resolution.noise;
    let foot = if norm(shift) <= reach { add(points[i], shift) } else { points[i] };
    let certainty = if middle > 0.0 { 1.0 - (least / middle).sqrt() } else { 0.0 };
    let seen = |&j: &usize| pair.is_none_or(|s| s.holds(points[j], surroundings.normal(j)));
    let near = wide.iter().map(|&j| j as usize).filter(seen).chain([i]).map(|j| points[j]);
    let sharp = if corner { None } else { sharpness(near, tensor, foot, resolution, section) };
    let row = Row {
        scalar: penalty as f32,
        vector: scale(tensor.vectors[0], certainty).map(|x| x as f32),
        corner: (1.0 - (least.sqrt() / least_fold).min(1.0)) as f32,
        foot,
        evidence: sharp.map(|s| Evidence {
            sharp: s.evidence as f32,
            expected: s.expected as f32,
            fold: s.angle.abs() as f32,
        }),
    };
    row.evidence.is_none_or(|e| e.sharp > CLEARLY_SMOOTH).then_some(row)
}
