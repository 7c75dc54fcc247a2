//! The points beside each strip, and the side of it on which they lie.
//!
//! In the cross-section of a strip the surface leaves it in two directions: two half-lines, at any angle to each other. They
//! are found where the directions of the points in a short window of the strip gather, by kernel density and then 2-means on
//! the circle; points near the strip have less weight, as their directions are less certain. A point is on the side whose
//! half-line is nearer. A border, or a strip with points on one side only, has one half-line.

use super::ground::Ground;
use super::near::{Near, NearStrip};
use super::stations::{Station, Stations};
use crate::math::vec3::{add_scaled, distance, dot, norm, sub};
use crate::parallel;
use crate::resolution::Resolution;
use crate::surface::Scales;

/// Greatest distance of points beside a strip, spacings; or the length of the point's longest edge if that is more, so that no
/// edge can cross a strip unnoticed.
const BESIDE: f64 = 3.0;
/// Distance from the strip up to which the side of a point is uncertain, spacings; plus twice the noise.
const SEAM: f64 = 0.4;
/// Greatest distance of points beside a strip beyond its end, spacings: no edge may pass between two strips.
const BEYOND: f64 = 1.0;
/// Number of stations on either side of a station from which it takes points.
const WINDOW: usize = 6;
/// Greatest number of points from which the directions at a station are found.
const DIRECTION_POINTS: usize = 96;
/// Half the angle of the kernel, and the least angle between the two sides.
const KERNEL_DEG: f64 = 25.0;
/// Least density of a side that counts, as a share of that of the other.
const SIDE_SHARE: f64 = 0.12;

/// A point beside a strip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// The strip.
    pub strip: u32,
    /// The nearest station.
    pub station: u32,
    /// Offset from the strip in the station's `across` coordinates.
    pub offset: [f64; 2],
    /// Distance from the strip.
    pub distance: f64,
    /// Whether no other strip is nearer.
    pub nearest: bool,
    /// Whether the point lies so near to the strip that its side is uncertain.
    pub seam: bool,
    /// 0 or 1: the half-line that is nearer, an index into the station's `leaves`.
    pub side: u8,
}

/// The strips beside each point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Beside {
    first: Vec<u32>,
    entries: Vec<Entry>,
}

impl Beside {
    /// The strips beside point `i`, in ascending order.
    pub fn of(&self, i: usize) -> &[Entry] {
        &self.entries[self.first[i] as usize..self.first[i + 1] as usize]
    }

    /// Puts the point's entry of this number on another side.
    pub fn set_side(&mut self, i: usize, at: usize, side: u8) {
        self.entries[self.first[i] as usize + at].side = side;
    }

    /// Distance from the nearest strip beside the point; infinite if there is none.
    pub fn clearance(&self, i: usize) -> f64 {
        self.of(i).iter().map(|e| e.distance).fold(f64::INFINITY, f64::min)
    }

    /// Whether the point lies on a strip rather than beside it.
    pub fn on_seam(&self, i: usize) -> bool {
        self.of(i).iter().any(|e| e.seam)
    }
}

/// Finds the points beside all strips and fills in the directions at the stations.
pub fn beside(ground: &Ground, mut stations: Stations) -> (Stations, Beside) {
    let near = Near::new(&stations);
    let lists = parallel::map_with(ground.points.len(), parallel::QUICK, |found, i| {
        let p = ground.points[i];
        let edges = ground.graph.of(i).iter().map(|&j| distance(p, ground.points[j as usize]));
        let strips = near.of(p, edges.fold(BESIDE * ground.scales.unit(i as u32), f64::max), found);
        entries(&stations.all, p, &strips, ground.scales.at(i))
    });
    let mut beside = Beside { first: vec![0], ..Default::default() };
    for list in lists {
        beside.entries.extend(list);
        beside.first.push(beside.entries.len() as u32);
    }
    directions(&mut stations, &beside, ground.scales);
    for entry in &mut beside.entries {
        entry.side = side(&stations.all[entry.station as usize], entry.offset);
    }
    (stations, beside)
}

/// The entries of a point, given the nearest station of each strip.
fn entries(all: &[Station], p: [f64; 3], near: &[NearStrip], scale: Resolution) -> Vec<Entry> {
    let beyond = BEYOND * scale.spacing;
    let seam = (SEAM * scale.spacing + 2.0 * scale.noise).min(scale.spacing);
    let mut entries: Vec<Entry> = near
        .iter()
        .filter_map(|&NearStrip { strip, station, .. }| {
            let at = &all[station as usize];
            let d = sub(p, at.position);
            let along = dot(d, at.tangent);
            let u = add_scaled(d, at.tangent, -along);
            (along * at.end <= beyond).then(|| Entry {
                strip,
                station,
                offset: at.across.map(|e| dot(u, e)),
                // Beyond an end the strip itself is farther away than its tangent.
                distance: if along * at.end > 0.0 { norm(d) } else { norm(u) },
                nearest: false,
                seam: false,
                side: 0,
            })
        })
        .collect();
    let least = entries.iter().map(|e| e.distance).fold(f64::INFINITY, f64::min);
    entries.iter_mut().for_each(|e| (e.nearest, e.seam) = (e.distance == least, e.distance < seam));
    entries
}

/// Fills in `leaves` at all stations. Offsets shorter than half a spacing have less weight, as noise turns them.
fn directions(stations: &mut Stations, beside: &Beside, scales: Scales) {
    let mut at: Vec<Vec<([f64; 2], f64)>> = vec![Vec::new(); stations.all.len()];
    let points = (0..beside.first.len() - 1).flat_map(|i| beside.of(i).iter().map(move |e| (i, e)));
    for (i, entry) in points.filter(|(_, e)| e.nearest && e.distance > 0.0) {
        let short = 0.5 * scales.at(i).spacing;
        let length = (entry.offset[0].powi(2) + entry.offset[1].powi(2)).sqrt();
        if length > 0.0 {
            let direction = entry.offset.map(|x| x / length);
            at[entry.station as usize].push((direction, (length / short).min(1.0).powi(2)));
        }
    }
    let border = &stations.border;
    let first = &stations.first;
    let found = parallel::flat_map(border.len(), parallel::TASK, |strip, found| {
        let range = first[strip]..first[strip + 1];
        let mut before: [Option<[f64; 2]>; 2] = [None; 2];
        for s in range.clone() {
            let from = s.saturating_sub(WINDOW).max(range.start);
            let window: Vec<([f64; 2], f64)> =
                at[from..range.end.min(s + WINDOW + 1)].iter().flatten().copied().collect();
            before = ordered(two(&window, border[strip]), before);
            found.push(before);
        }
    });
    for (station, leaves) in stations.all.iter_mut().zip(found) {
        station.leaves = leaves;
    }
}

/// The one or two directions in which most of the points lie.
fn two(window: &[([f64; 2], f64)], border: bool) -> [Option<[f64; 2]>; 2] {
    let step = window.len().div_ceil(DIRECTION_POINTS).max(1);
    let some: Vec<([f64; 2], f64)> = window.iter().copied().step_by(step).collect();
    let cosine = KERNEL_DEG.to_radians().cos();
    let inner = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let density = |a: [f64; 2]| some.iter().map(|(b, w)| w * (inner(a, *b) - cosine).max(0.0)).sum::<f64>();
    let dense: Vec<f64> = some.iter().map(|s| density(s.0)).collect();
    let best = |allowed: &dyn Fn([f64; 2]) -> bool| {
        (0..some.len()).filter(|&i| allowed(some[i].0)).fold(None, |best: Option<usize>, i| match best {
            Some(b) if dense[b] >= dense[i] => best,
            _ => Some(i),
        })
    };
    let Some(a) = best(&|_| true) else { return [None; 2] };
    let first = some[a].0;
    let second =
        best(&|d| inner(d, first) < cosine).filter(|&b| !border && dense[b] >= SIDE_SHARE * dense[a]);
    let Some(b) = second else { return [Some(first), None] };
    let mut sides = [first, some[b].0];
    for _ in 0..4 {
        let mut sums = [[0.0; 2]; 2];
        for (d, w) in &some {
            let [p, q] = sides.map(|s| inner(s, *d));
            // Points far from both, such as those of another sheet, are left out.
            if p.max(q) > 0.5 {
                let sum = &mut sums[usize::from(q > p)];
                *sum = [sum[0] + w * d[0], sum[1] + w * d[1]];
            }
        }
        for (side, sum) in sides.iter_mut().zip(sums) {
            let length = inner(sum, sum).sqrt();
            if length > 0.0 {
                *side = sum.map(|x| x / length);
            }
        }
    }
    sides.map(Some)
}

/// The directions in the order of the previous ones; a missing one is taken from them.
fn ordered(found: [Option<[f64; 2]>; 2], before: [Option<[f64; 2]>; 2]) -> [Option<[f64; 2]>; 2] {
    let agree = |a: Option<[f64; 2]>, b: Option<[f64; 2]>| match (a, b) {
        (Some(a), Some(b)) => a[0] * b[0] + a[1] * b[1],
        _ => 0.0,
    };
    if found[1].is_none() && before[1].is_none() {
        return [found[0].or(before[0]), None];
    }
    let straight = agree(found[0], before[0]) + agree(found[1], before[1]);
    let swapped = agree(found[1], before[0]) + agree(found[0], before[1]);
    let [a, b] = if swapped > straight { [found[1], found[0]] } else { found };
    [a.or(before[0]), b.or(before[1])]
}

/// The nearer half-line.
fn side(at: &Station, offset: [f64; 2]) -> u8 {
    let along = |leaves: Option<[f64; 2]>| leaves.map(|l| l[0] * offset[0] + l[1] * offset[1]);
    match at.leaves.map(along) {
        [Some(a), Some(b)] => u8::from(b > a),
        [None, Some(_)] => 1,
        _ => 0,
    }
}
