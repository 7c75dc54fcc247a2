//! Nodes from the faces of all creases that meet in them, in our form: each face is a surface as at a crease point, fitted without the points
//! nearest the edges; the paper's planes of groups are in `group`.

use super::quadric_error::{Corner, Facet, corner};
use crate::math::vec3::{add_scaled, norm, scale, sub, unit};
use crate::network::{Network, Strip, StripKind};
use crate::parallel;
use crate::params::WedgeParams;
use crate::patch::Ground;
use crate::recover::wedge::{Beside, SPREAD, Scratch, Station, face};

/// Distance along a strip from the node over which its direction there is taken, units of the place.
const CHORD: f64 = 2.0;
/// Weight of a face: each is met from the two strips that bound it at the node.
const SHARE: f64 = 0.5;

/// A strip at a node.
#[derive(Clone, Copy, Debug)]
pub(in crate::recover) struct End {
    /// Number of the strip.
    pub strip: usize,
    /// Whether it ends there rather than starts.
    pub last: bool,
}

/// `(N)` the ends of strips at each node; none where a border meets it, whose nodes stay.
pub(in crate::recover) fn ends(network: &Network) -> Vec<Vec<End>> {
    let mut ends: Vec<Vec<End>> = vec![Vec::new(); network.nodes.len()];
    let mut border = vec![false; network.nodes.len()];
    for (s, strip) in network.strips.iter().enumerate() {
        for (node, last) in [(strip.start, false), (strip.end, true)] {
            if let Some(n) = node {
                ends[n as usize].push(End { strip: s, last });
                border[n as usize] |= strip.kind == StripKind::Border;
            }
        }
    }
    ends.iter_mut().zip(border).filter(|(_, b)| *b).for_each(|(e, _)| e.clear());
    ends
}

/// `(N)` the nodes where the faces of their creases meet.
pub(in crate::recover) fn corners(
    network: &Network,
    ground: &Ground,
    beside: &[Beside],
    params: &WedgeParams,
) -> Vec<Option<Corner>> {
    let ends = ends(network);
    let nodes = &network.nodes;
    parallel::map_with(nodes.len(), parallel::TASK, |scratch: &mut Scratch, n| {
        let at = nodes[n].position;
        let facets = ends[n].iter().flat_map(|&end| {
            let strip = &network.strips[end.strip];
            let Some(station) = station(at, strip, end.last, ground) else { return Vec::new() };
            scratch.around(station.source, ground, params);
            let mut facet = |side| facet(&station, end.strip, side, ground, beside, scratch);
            [facet(0), facet(1)].into_iter().flatten().collect()
        });
        corner(at, &facets.collect::<Vec<Facet>>(), SHARE, ground.scales.unit(nodes[n].source))
    })
}

/// The node as a crease point of a strip that it ends, with the strip's direction beside it.
fn station(at: [f64; 3], strip: &Strip, last: bool, ground: &Ground) -> Option<Station> {
    let source = *if last { strip.sources.last() } else { strip.sources.first() }?;
    let far = CHORD * ground.scales.unit(source);
    let beyond = |p: &&[f64; 3]| norm(sub(**p, at)) >= far;
    let points = &strip.points;
    let on = if last {
        points.iter().rev().find(beyond).or(points.first())
    } else {
        points.iter().find(beyond).or(points.last())
    };
    Some(Station { at, direction: unit(sub(*on?, at)), source })
}

/// The tangent plane of one face of a strip at the node.
fn facet(
    station: &Station,
    strip: usize,
    side: usize,
    ground: &Ground,
    beside: &[Beside],
    scratch: &mut Scratch,
) -> Option<Facet> {
    let (axes, fit) = face(station, strip, side, ground, beside, scratch)?;
    let [b, c] = fit.slopes(0.0);
    let tilted = add_scaled(add_scaled(axes.normal, axes.away, -b), axes.along, -c);
    let lean = 1.0 / norm(tilted);
    let variance = fit.variance_at(0.0) * lean * lean;
    let known = variance.sqrt() <= SPREAD * ground.scales.unit(station.source);
    known.then(|| Facet { normal: scale(tilted, lean), offset: -fit.height(0.0) * lean, variance })
}
