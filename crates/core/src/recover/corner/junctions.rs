//! Junctions as printed: k planes through the k groups around each, and the points that are strange to each strip.

use super::faces::{End, ends};
use super::group::{Arm, Grouping, group};
use super::quadric_error::{Corner, Facet, corner};
use crate::math::vec3::distance;
use crate::network::Network;
use crate::parallel;
use crate::params::WedgeParams;
use crate::patch::Ground;
use crate::recover::wedge::{Plane, Scratch, Station, floor};

/// Fewest creases of a junction.
const CREASES: usize = 3;
/// Distance along a strip from the junction at which its direction is looked at, units of the place.
const BESIDE: f64 = 3.0;

/// `(N)` the corners, and the groups around the nodes that have some. `stations` are the crease points of all strips.
pub(in crate::recover) fn junctions(
    network: &Network,
    stations: &[Vec<Station>],
    ground: &Ground,
    params: &WedgeParams,
) -> (Vec<Option<Corner>>, Vec<(usize, Grouping)>) {
    let ends = ends(network);
    let found = parallel::map_with(ends.len(), parallel::TASK, |scratch: &mut Scratch, n| {
        (ends[n].len() >= CREASES)
            .then(|| junction(network, n, &ends[n], stations, ground, params, scratch))
            .flatten()
    });
    let (mut corners, mut around) = (Vec::new(), Vec::new());
    for (n, found) in found.into_iter().enumerate() {
        let (corner, grouping) = found.unzip();
        corners.push(corner.flatten());
        around.extend(grouping.map(|g| (n, g)));
    }
    (corners, around)
}

/// `(S)` the ascending points around the ends of each strip that lie on neither of its faces.
pub(in crate::recover) fn strange(strips: usize, around: &[(usize, Grouping)]) -> Vec<Vec<u32>> {
    let mut strange = vec![Vec::new(); strips];
    for (_, grouping) in around {
        for &s in &grouping.strips {
            strange[s].extend(grouping.strange_to(s));
        }
    }
    for list in &mut strange {
        list.sort_unstable();
        list.dedup();
    }
    strange
}

fn junction(
    network: &Network,
    n: usize,
    ends: &[End],
    stations: &[Vec<Station>],
    ground: &Ground,
    params: &WedgeParams,
    scratch: &mut Scratch,
) -> Option<(Option<Corner>, Grouping)> {
    let node = &network.nodes[n];
    let (at, unit) = (node.position, ground.scales.unit(node.source));
    let arm = |end: &End| {
        let mut stations = stations[end.strip].clone();
        if end.last {
            stations.reverse();
        }
        let far = stations.iter().position(|s| distance(s.at, at) >= BESIDE * unit);
        let beside = stations.get(far.unwrap_or(stations.len().saturating_sub(1)))?.at;
        Some(Arm { strip: end.strip, stations, beside })
    };
    let arms: Vec<Arm> = ends.iter().map(arm).collect::<Option<_>>()?;
    scratch.around(node.source, ground, params);
    let mut near = scratch.near.clone();
    near.sort_unstable();
    let grouping = group(at, near, arms, ground.points, unit, |station, list| {
        scratch.around(station.source, ground, params);
        list.extend_from_slice(&scratch.near);
    })?;
    let floor = floor(node.source, ground);
    let facet = |g: usize| {
        let of = grouping.points.iter().zip(&grouping.group).filter(|&(_, &k)| k == g);
        let plane = Plane::fit(of.map(|(&i, _)| ground.points[i as usize]), floor)?;
        Some(Facet { normal: plane.normal, offset: plane.offset(at), variance: plane.variance_at(at) })
    };
    let facets: Vec<Facet> = (0..grouping.strips.len()).filter_map(facet).collect();
    Some((corner(at, &facets, 1.0, unit), grouping))
}
