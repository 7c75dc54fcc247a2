//! Feature recovery (Gumhold 2001, section 4): junctions first, then the crease strips up to them.

use super::corner::{Corner, corners as faces, junctions, strange};
use super::recovery::{Pass, deviations};
use super::spline::{self, Place};
use super::wedge::{self, FAR, Recovered, Scratch, Side, Station, beside, stations};
use crate::math::vec3::distance;
use crate::network::{Network, StripKind};
use crate::parallel;
use crate::params::{SplineParams, WedgeForm, WedgeParams};
use crate::patch::Ground;

/// Share of the crease points of a strip that must be recovered.
const RECOVERED: f64 = 0.5;
/// Mean height of the points nearest the edge over the faces, units of the place, outside which there is no edge where these meet: below, the
/// crease is a round, a chamfer or one side of a narrow face. Noise alone lifts the points by half its standard deviation.
const FILLED: std::ops::RangeInclusive<f64> = -0.1..=0.45;
/// Passes of our own form: the first brings the crease near enough to the edge for the second to leave the right points out.
const PASSES: usize = 2;

/// Lays creases and the nodes between them where their faces meet; local frame, sources as canonical indices.
/// Returns what the last pass found; `None` where nothing is to be recovered.
pub(crate) fn sharpen(
    network: &mut Network,
    ground: &Ground,
    params: &WedgeParams,
    spline: &SplineParams,
) -> Option<Pass> {
    let form = params.wedge;
    let passes = match form {
        WedgeForm::None => 0,
        WedgeForm::Paper => 1,
        WedgeForm::Quadric => PASSES,
    };
    (0..passes).map(|_| pass(network, ground, form, params, spline)).last()
}

fn pass(
    network: &mut Network,
    ground: &Ground,
    form: WedgeForm,
    params: &WedgeParams,
    spline: &SplineParams,
) -> Pass {
    let strips = &network.strips;
    let crease = |s: usize| strips[s].kind == StripKind::Crease;
    let stations: Vec<Vec<Station>> = parallel::map(strips.len(), parallel::TASK, |s| {
        if crease(s) { stations(&strips[s], ground.points, ground.scales) } else { Vec::new() }
    });
    let (mut corners, around) = match form {
        WedgeForm::Paper => junctions(network, &stations, ground, params),
        _ => Default::default(),
    };
    let strange = strange(strips.len(), &around);
    let sides: Vec<Vec<Side>> =
        parallel::map_with(strips.len(), parallel::TASK, |scratch: &mut Scratch, s| {
            wedge::group(&strips[s], &stations[s], &strange[s], ground, params, scratch)
        });
    let found: Vec<Vec<Recovered>>;
    if form == WedgeForm::Quadric {
        let beside = beside(network, &sides, ground);
        corners = faces(network, ground, &beside, params);
        found = recovered(network, &stations, ground, params, |s, station, scratch| {
            wedge::quadric(station, s, ground, &beside, scratch)
        });
    } else {
        found = recovered(network, &stations, ground, params, |s, station, scratch| {
            scratch.near.retain(|i| strange[s].binary_search(i).is_err());
            wedge::printed(station, &scratch.near, &sides[s], ground)
        });
    }
    lay(network, &corners, &found, ground, spline);
    Pass { sides, around, found, corners }
}

/// `(S)` the recovered crease points of each strip in order; none where too few can be.
fn recovered(
    network: &Network,
    stations: &[Vec<Station>],
    ground: &Ground,
    params: &WedgeParams,
    one: impl Fn(usize, &Station, &mut Scratch) -> Option<Recovered> + Sync,
) -> Vec<Vec<Recovered>> {
    parallel::map_with(stations.len(), parallel::TASK, |scratch: &mut Scratch, s| {
        let far = FAR * ground.scales.finest(&network.strips[s].sources).unit();
        let mut found = Vec::new();
        for station in &stations[s] {
            scratch.around(station.source, ground, params);
            let place = one(s, station, scratch);
            found.extend(place.filter(|p| distance(p.at, station.at) <= far));
        }
        let enough = found.len() as f64 >= RECOVERED * stations[s].len() as f64;
        let filled = found.iter().map(|p| p.filled).sum::<f64>() / found.len().max(1) as f64;
        let sharp = FILLED.contains(&(filled / ground.scales.finest(&network.strips[s].sources).unit()));
        if enough && sharp { found } else { Vec::new() }
    })
}

/// Moves the nodes, and lays the strips through their crease points.
fn lay(
    network: &mut Network,
    corners: &[Option<Corner>],
    found: &[Vec<Recovered>],
    ground: &Ground,
    spline: &SplineParams,
) {
    for (node, corner) in network.nodes.iter_mut().zip(corners) {
        if let Some(corner) = corner {
            (node.position, node.sigma) = (corner.at, Some(deviations(&corner.covariance)));
        }
    }
    let nodes = &network.nodes;
    for (strip, found) in network.strips.iter_mut().zip(found).filter(|(s, _)| s.kind == StripKind::Crease) {
        let ends = [strip.start, strip.end].map(|n| n.map(|n| &nodes[n as usize]));
        let ends =
            ends.map(|n| n.map(|n| Place { at: n.position, sigma: n.sigma.filter(|_| !found.is_empty()) }));
        let places: Vec<Place> = if found.is_empty() {
            // The strip stays, between nodes that may have moved.
            let inner =
                if strip.closed { &strip.points[..] } else { &strip.points[1..strip.points.len() - 1] };
            inner.iter().map(|&at| Place { at, sigma: None }).collect()
        } else {
            let fold: f64 = found.iter().map(|p| p.fold).sum::<f64>() / found.len() as f64;
            strip.fold_deg = Some(fold.to_degrees());
            found.iter().map(|p| Place { at: p.at, sigma: Some(deviations(&p.covariance)) }).collect()
        };
        spline::relay(strip, &places, ends, ground.scales, spline);
    }
}
