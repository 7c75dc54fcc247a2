//! The area of each point: its Voronoi cell in its tangent plane among the points of its patch, cut off at the strips beside it.

use super::beside::Beside;
use super::ground::{Ground, NO_PATCH};
use super::stations::Stations;
use crate::math::vec3::{cross, distance, dot, perpendicular, sub, unit};
use crate::parallel;

/// The polygon from which a cell is clipped: cosine and sine of multiples of 30 degrees.
const AROUND: [[f64; 2]; 12] = {
    const C: f64 = 0.866_025_403_784_438_6;
    [
        [1.0, 0.0],
        [C, 0.5],
        [0.5, C],
        [0.0, 1.0],
        [-0.5, C],
        [-C, 0.5],
        [-1.0, 0.0],
        [-C, -0.5],
        [-0.5, -C],
        [0.0, -1.0],
        [0.5, -C],
        [C, -0.5],
    ]
};
/// Greatest reach of a cell into empty space, in units of the mean distance to the direct neighbours.
const OPEN: f64 = 0.95;

/// `(M)` area of each point, squared unit of the local frame; zero for points without a patch.
pub fn areas(ground: &Ground, label: &[u32], stations: &Stations, beside: &Beside) -> Vec<f64> {
    parallel::map_with(label.len(), parallel::QUICK, |buffers, i| match label[i] {
        NO_PATCH => 0.0,
        _ => cell(ground, label, stations, beside, i, buffers),
    })
}

fn cell(
    ground: &Ground,
    label: &[u32],
    stations: &Stations,
    beside: &Beside,
    i: usize,
    [corners, next]: &mut [Vec<[f64; 2]>; 2],
) -> f64 {
    let normal = ground.normals[i].map(f64::from);
    let u = unit(perpendicular(normal));
    let v = cross(normal, u);
    let flat = |d: [f64; 3]| [dot(d, u), dot(d, v)];
    let near = ground.graph.of(i);
    let mean = near.iter().map(|&j| distance(ground.points[i], ground.points[j as usize])).sum::<f64>()
        / near.len().max(1) as f64;
    corners.clear();
    corners.extend(AROUND.map(|c| c.map(|x| x * OPEN * mean)));
    for &j in near.iter().filter(|&&j| label[j as usize] == label[i]) {
        let q = flat(sub(ground.points[j as usize], ground.points[i]));
        clip(corners, next, q, 0.5 * (q[0] * q[0] + q[1] * q[1]));
    }
    for entry in beside.of(i) {
        let station = &stations.all[entry.station as usize];
        let (d, t) = (flat(sub(station.position, ground.points[i])), flat(station.tangent));
        // The line of the strip in the plane, at right angles to the direction towards it.
        let length2 = t[0] * t[0] + t[1] * t[1];
        if length2 > 0.25 {
            let along = (d[0] * t[0] + d[1] * t[1]) / length2;
            let q = [d[0] - along * t[0], d[1] - along * t[1]];
            clip(corners, next, q, q[0] * q[0] + q[1] * q[1]);
        }
    }
    area(corners)
}

/// Clips the polygon to the half-plane `x . q <= offset`.
fn clip(corners: &mut Vec<[f64; 2]>, next: &mut Vec<[f64; 2]>, q: [f64; 2], offset: f64) {
    let beyond = |c: [f64; 2]| c[0] * q[0] + c[1] * q[1] - offset;
    if corners.iter().all(|&c| beyond(c) <= 0.0) {
        return;
    }
    next.clear();
    for n in 0..corners.len() {
        let (a, b) = (corners[n], corners[(n + 1) % corners.len()]);
        let (over_a, over_b) = (beyond(a), beyond(b));
        if over_a <= 0.0 {
            next.push(a);
        }
        if (over_a <= 0.0) != (over_b <= 0.0) {
            let t = over_a / (over_a - over_b);
            next.push([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]);
        }
    }
    std::mem::swap(corners, next);
}

fn area(corners: &[[f64; 2]]) -> f64 {
    let twice = |n: usize| {
        let (a, b) = (corners[n], corners[(n + 1) % corners.len()]);
        a[0] * b[1] - a[1] * b[0]
    };
    0.5 * (0..corners.len()).map(twice).sum::<f64>()
}
