//! Point cloud enrichment (Gumhold 2001, section 5.2): "to improve the resolution of feature lines by resampling the initial point
//! set so that standard algorithms can now handle the features". Points are added along the creases and borders at the density
//! of the cloud there, and at the nodes in which they meet.

use super::ground::Terrain;
use crate::cloud::{Cloud, Column};
use crate::extract::Extraction;
use crate::math::vec3::{add_scaled, distance, sub};
use crate::measure::Class;
use crate::neighbors::{Found, Index};
use crate::network::{Network, NodeKind, Strip, StripKind};
use crate::params::Params;
use crate::surface::Scales;

/// A point on the lines of a result.
#[derive(Clone, Debug, PartialEq)]
pub struct LinePoint {
    /// World frame.
    pub position: [f64; 3],
    /// [`Class::Crease`], [`Class::Border`] or, at a node in which lines meet or turn, [`Class::Corner`].
    pub kind: Class,
    /// The point of the input that stands for it: the nearest of those that the line was found along, as an index.
    pub source: u32,
    /// The strips that it lies on: one, or all that meet in its node.
    pub strips: Vec<u32>,
}

/// Points on the lines of `found`, `step` spacings of the cloud apart: first those at the nodes, then along the strips in their
/// order. A strip between nodes has its ends there. `world` is the `(N, 3)` positions that `found` was extracted from by
/// `params`. Nothing for a step that is not above 0.
///
/// ```
/// use lineament::{Params, apply::line_points, extract, shapes};
///
/// let cloud = shapes::cube_386().cloud;
/// let params = Params::default();
/// let points = line_points(&cloud, &extract(&cloud, &params)?, &params, 0.5);
/// assert_eq!(points.iter().filter(|p| p.kind == lineament::Class::Corner).count(), 8);
/// # Ok::<(), lineament::Error>(())
/// ```
pub fn line_points(
    world: &(impl AsRef<[[f64; 3]]> + ?Sized),
    found: &Extraction,
    params: &Params,
    step: f64,
) -> Vec<LinePoint> {
    let terrain = Terrain::new(world.as_ref(), found, params);
    along_lines(&terrain, found, step)
}

/// As [`line_points`], over a terrain that is there already.
pub(super) fn along_lines(terrain: &Terrain, found: &Extraction, step: f64) -> Vec<LinePoint> {
    if !(step > 0.0) {
        return Vec::new();
    }
    let mut points = nodes(&found.network);
    for (s, local) in terrain.network.strips.iter().enumerate() {
        let strip = &found.network.strips[s];
        let kind = match strip.kind {
            StripKind::Crease => Class::Crease,
            StripKind::Border => Class::Border,
            StripKind::Rounded => continue,
        };
        let nearest = nearest_sources(local, terrain);
        let places = places(local, &arcs(local, &nearest, terrain.scales()), step);
        let all = |points: &[[f64; 3]]| -> Vec<[f64; 3]> { places.iter().map(|&p| at(points, p)).collect() };
        // Sought at the places themselves: a straight line may have two vertices.
        let nearest = nearest_of(local, &all(&local.points), terrain);
        points.extend(all(&strip.points).into_iter().zip(nearest).map(|(position, nearest)| LinePoint {
            position,
            kind,
            source: nearest.and_then(|c| found.source.get(c as usize).copied()).unwrap_or_default(),
            strips: vec![s as u32],
        }));
    }
    points
}

/// A point at each node.
fn nodes(network: &Network) -> Vec<LinePoint> {
    let mut at: Vec<Vec<u32>> = vec![Vec::new(); network.nodes.len()];
    for (s, strip) in network.strips.iter().enumerate() {
        for node in [strip.start, strip.end].into_iter().flatten() {
            at[node as usize].push(s as u32);
        }
    }
    let mut points = Vec::with_capacity(at.len());
    for (node, mut strips) in network.nodes.iter().zip(at) {
        strips.dedup();
        let of_strip = |kind| strips.iter().all(|&s| network.strips[s as usize].kind == kind);
        let kind = match node.kind {
            NodeKind::End if of_strip(StripKind::Border) => Class::Border,
            NodeKind::End => Class::Crease,
            _ => Class::Corner,
        };
        points.push(LinePoint { position: node.position, kind, source: node.source, strips });
    }
    points
}

/// The place at a share of a segment of a line through `points`.
fn at(points: &[[f64; 3]], (segment, share): (usize, f64)) -> [f64; 3] {
    let (from, to) = (points[segment], points[(segment + 1) % points.len()]);
    add_scaled(from, sub(to, from), share)
}

/// For each of some places, the nearest of the sources of a strip; nothing for a strip without.
fn nearest_of(strip: &Strip, places: &[[f64; 3]], terrain: &Terrain) -> Vec<Option<u32>> {
    let sources: Vec<[f64; 3]> = strip.sources.iter().map(|&c| terrain.positions[c as usize]).collect();
    let (index, mut found) = (Index::build(&sources), Vec::new());
    let nearest = |&place: &[f64; 3]| {
        index.nearest(place, 1, &mut found);
        found.first().map(|f: &Found| strip.sources[f.index as usize])
    };
    places.iter().map(nearest).collect()
}

/// For each point of a strip, the nearest of its sources. Both run along the strip, so that each source is looked at about once.
fn nearest_sources(strip: &Strip, terrain: &Terrain) -> Vec<Option<u32>> {
    let away = |p: [f64; 3], k: usize| distance(p, terrain.positions[strip.sources[k] as usize]);
    let count = strip.sources.len();
    let mut at = 0;
    let step = |p: &[f64; 3]| {
        if count == 0 {
            return None;
        }
        while at + 1 < count && away(*p, at + 1) <= away(*p, at) {
            at += 1;
        }
        Some(strip.sources[at])
    };
    strip.points.iter().map(step).collect()
}

/// `(M + 1)` for a loop, else `(M)`: length along the strip up to each point in local spacings.
fn arcs(strip: &Strip, nearest: &[Option<u32>], scales: Scales) -> Vec<f64> {
    let count = strip.points.len();
    let segments = if strip.closed { count } else { count.saturating_sub(1) };
    let spacing = |k: usize| nearest[k].map_or(scales.mean.spacing, |c| scales.at(c as usize).spacing);
    let mut arcs = vec![0.0];
    for k in 0..segments {
        let next = (k + 1) % count;
        let length = distance(strip.points[k], strip.points[next]);
        arcs.push(arcs[k] + length * 2.0 / (spacing(k) + spacing(next)));
    }
    arcs
}

/// Places `step` apart, or as little less as it takes to be equally far apart: a segment of the strip and the share of it. The
/// ends of an open strip are left out, as they are nodes.
fn places(strip: &Strip, arcs: &[f64], step: f64) -> Vec<(usize, f64)> {
    let total = arcs.last().copied().unwrap_or_default();
    let intervals = (total / step).ceil().clamp(if strip.closed { 3.0 } else { 1.0 }, MOST_POINTS);
    let first = usize::from(!strip.closed);
    let mut segment = 0;
    let mut places = Vec::new();
    for k in first..intervals as usize {
        let arc = total * k as f64 / intervals;
        while segment + 2 < arcs.len() && arcs[segment + 1] <= arc {
            segment += 1;
        }
        let length = arcs[segment + 1] - arcs[segment];
        places.push((segment, if length > 0.0 { ((arc - arcs[segment]) / length).min(1.0) } else { 0.0 }));
    }
    if arcs.len() < 2 { Vec::new() } else { places }
}

/// Greatest number of points on one strip, whatever the step.
const MOST_POINTS: f64 = 1e6;

/// The cloud followed by points of its lines, which get the attributes of the points that stand for them; and `(N + K)` the class
/// of each point, of those of the cloud as in `classes`.
pub fn enriched(cloud: &Cloud, classes: &[Class], points: &[LinePoint]) -> (Cloud, Vec<Class>) {
    let count = cloud.len() as u32;
    let rows: Vec<u32> =
        (0..count).chain(points.iter().map(|p| p.source.min(count.saturating_sub(1)))).collect();
    let mut all = cloud.select(&rows);
    for (place, point) in all.positions.iter_mut().skip(cloud.len()).zip(points) {
        *place = point.position;
    }
    for name in ["nx", "ny", "nz"] {
        // A normal of one face is none of a crease.
        if let Some(column) = all.attributes.iter_mut().find(|a| a.name == name) {
            match &mut column.values {
                Column::F32(values) => values[cloud.len()..].fill(f32::NAN),
                Column::F64(values) => values[cloud.len()..].fill(f64::NAN),
                _ => {}
            }
        }
    }
    let classes = classes.iter().copied().chain(points.iter().map(|p| p.kind)).collect();
    (all, classes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::extract::extract;
    use crate::shapes::{Sampling, Scan, cylinders, sheet_with_hole};

    #[test]
    fn a_point_on_a_straight_line_stands_beside_its_own_point_of_the_cloud() {
        let cloud = crate::shapes::cube_386().cloud;
        let params = Params::default();
        let found = extract(&cloud, &params).unwrap();
        for point in line_points(&cloud, &found, &params, 0.5) {
            let away = distance(point.position, cloud.positions[point.source as usize]);
            assert!(away < found.report.spacing, "{point:?}: {away}");
        }
    }

    #[test]
    fn points_lie_on_the_lines_at_the_density_of_the_cloud() {
        let shape = sheet_with_hole();
        let mut cloud = shape.sample(&Scan::new(Sampling::BlueNoise { count: 2500 }).seed(4)).cloud;
        let rows = Column::U32((0..cloud.len() as u32).collect());
        cloud.attributes.push(crate::cloud::Attribute { name: "row".into(), values: rows });
        let params = Params::default();
        let found = extract(&cloud, &params).unwrap();
        let points = line_points(&cloud, &found, &params, 1.0);
        let length: f64 = found.network.strips.iter().map(Strip::length).sum();
        let spacing = found.report.spacing;
        let expected = length / spacing;
        assert!((0.85..=1.2).contains(&(points.len() as f64 / expected)), "{} of {expected}", points.len());
        let truth = shape.network.index(0.25 * spacing);
        for point in &points {
            assert!(truth.distance(point.position) < 0.75 * spacing, "{point:?}");
            assert!(distance(point.position, cloud.positions[point.source as usize]) < 4.0 * spacing);
        }
        assert!(
            points.iter().all(|p| p.kind != Class::Crease) && points.iter().any(|p| p.kind == Class::Border)
        );
        let (all, classes) = enriched(&cloud, &found.classes(), &points);
        assert_eq!((all.len(), classes.len()), (cloud.len() + points.len(), all.len()));
        assert_eq!(all.positions[..cloud.len()], cloud.positions);
        let Column::U32(rows) = &all.attributes[0].values else { panic!("another type") };
        assert_eq!(rows[cloud.len()], points[0].source);
    }

    #[test]
    fn a_denser_step_gives_more_points_and_none_gives_none() {
        let cloud = cylinders(1.0, 0.6).sample(&Scan::new(Sampling::BlueNoise { count: 3000 }).seed(3)).cloud;
        let params = Params::default();
        let found = extract(&cloud, &params).unwrap();
        let count = |step| line_points(&cloud, &found, &params, step).len() as f64;
        let (one, half) = (count(1.0), count(0.5));
        assert!(one > 30.0 && (1.8..2.1).contains(&(half / one)), "{one} {half}");
        assert_eq!((count(0.0), count(f64::NAN)), (0.0, 0.0));
    }
}
