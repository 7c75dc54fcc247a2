//! Orients normals outwards.
//!
//! Within a patch signs are passed over the edges of the neighbour graph, the most parallel normals first (H. Hoppe et al.,
//! "Surface reconstruction from unorganized points", SIGGRAPH 1992, section 3.3); this is safe, as a patch has no folds. Across
//! a strip the two half-planes decide: normals on the same side of the surface have the other face both below their own plane
//! (convex) or both above it (concave). Each connected part is then turned so that it encloses a positive volume; normals of
//! an open sheet point away from its centre.

use super::beside::Beside;
use super::ground::{Ground, NO_PATCH};
use super::stations::{Station, Stations};
use crate::math::vec3::{add_scaled, dot, scale, sub};

/// Sets with a sign relative to their root.
struct Signed {
    parent: Vec<u32>,
    odd: Vec<bool>,
}

impl Signed {
    fn new(count: usize) -> Self {
        Self { parent: (0..count as u32).collect(), odd: vec![false; count] }
    }

    /// The root, and whether the sign differs from the root's.
    fn find(&mut self, mut x: u32) -> (u32, bool) {
        let mut odd = false;
        while self.parent[x as usize] != x {
            let up = self.parent[x as usize];
            // Path halving: the grandparent becomes the parent.
            self.odd[x as usize] ^= self.odd[up as usize];
            self.parent[x as usize] = self.parent[up as usize];
            odd ^= self.odd[x as usize];
            x = self.parent[x as usize];
        }
        (x, odd)
    }

    fn union(&mut self, a: u32, b: u32, differ: bool) {
        let ((a, odd_a), (b, odd_b)) = (self.find(a), self.find(b));
        if a != b {
            let (low, high) = (a.min(b), a.max(b));
            self.parent[high as usize] = low;
            self.odd[high as usize] = odd_a ^ odd_b ^ differ;
        }
    }
}

/// `(M, 3)` outward normals; zero for points without a patch.
pub fn outward(
    ground: &Ground,
    label: &[u32],
    count: usize,
    stations: &Stations,
    beside: &Beside,
    area: &[f64],
) -> Vec<[f64; 3]> {
    let mut normals = within(ground, label);
    let mut patches = Signed::new(count);
    let mut links = links(label, &normals, stations, beside);
    links.sort_by(|x, y| y.0.abs().total_cmp(&x.0.abs()).then((x.1, x.2).cmp(&(y.1, y.2))));
    for (evidence, a, b) in links {
        patches.union(a, b, evidence < 0.0);
    }
    let parts: Vec<(u32, bool)> = (0..count as u32).map(|p| patches.find(p)).collect();
    let inward = inward(ground, label, &normals, &parts, area);
    for (i, normal) in normals.iter_mut().enumerate().filter(|(i, _)| label[*i] != NO_PATCH) {
        let (root, odd) = parts[label[i] as usize];
        if odd ^ inward[root as usize] {
            *normal = scale(*normal, -1.0);
        }
    }
    normals
}

/// The normals, with consistent signs within each patch.
fn within(ground: &Ground, label: &[u32]) -> Vec<[f64; 3]> {
    let normal = |i: usize| ground.normals[i].map(f64::from);
    let mut edges: Vec<(u16, u32, u32)> = Vec::new();
    for i in (0..label.len()).filter(|&i| label[i] != NO_PATCH) {
        for &j in ground.graph.of(i).iter().filter(|&&j| j as usize > i && label[j as usize] == label[i]) {
            let bend = 1.0 - dot(normal(i), normal(j as usize)).abs();
            edges.push(((bend.clamp(0.0, 1.0) * 1000.0) as u16, i as u32, j));
        }
    }
    edges.sort_unstable();
    let mut signs = Signed::new(label.len());
    for (_, i, j) in edges {
        signs.union(i, j, dot(normal(i as usize), normal(j as usize)) < 0.0);
    }
    let signed = |i: usize| match label[i] {
        NO_PATCH => [0.0; 3],
        _ => scale(normal(i), if signs.find(i as u32).1 { -1.0 } else { 1.0 }),
    };
    (0..label.len()).map(signed).collect()
}

/// For each strip between two patches, the certainty that their normals agree in sign (positive) or differ (negative).
fn links(label: &[u32], normals: &[[f64; 3]], stations: &Stations, beside: &Beside) -> Vec<(f64, u32, u32)> {
    let sums = sums(label, normals, stations, beside);
    let mut links: Vec<(f64, u32, u32)> = Vec::new();
    for (station, sides) in stations.all.iter().zip(&sums) {
        let [(Some(a), n), (Some(b), m)] = *sides else { continue };
        if a == b {
            continue;
        }
        let [Some(p), Some(q)] = station.leaves.map(|l| l.map(|l| in_space(station, l))) else { continue };
        // At a fold each face's position relative to the plane of the other decides, at a flat strip the normals themselves.
        let fold = dot(n, q) * dot(m, p);
        let flat = dot(n, m) * dot(p, q).min(0.0).powi(2);
        links.push((fold + 0.25 * flat, a.min(b), a.max(b)));
    }
    links.sort_by_key(|l| (l.1, l.2));
    links
        .chunk_by(|x, y| (x.1, x.2) == (y.1, y.2))
        .map(|c| (c.iter().map(|l| l.0).sum(), c[0].1, c[0].2))
        .collect()
}

/// The patch of a point beside a strip, the point, and its weight.
type Vote = (u32, u32, f64);

/// A patch beside a station, and its mean normal there.
pub type Side = (Option<u32>, [f64; 3]);

/// The patch of most points at each station and side, with their mean normal.
pub fn sums(label: &[u32], normals: &[[f64; 3]], stations: &Stations, beside: &Beside) -> Vec<[Side; 2]> {
    let mut votes: Vec<[Vec<Vote>; 2]> = vec![Default::default(); stations.all.len()];
    for i in (0..label.len()).filter(|&i| label[i] != NO_PATCH) {
        for entry in beside.of(i).iter().filter(|e| !e.seam) {
            // Normals close to a fold lean over it; points nearer to another strip count only where there are no others.
            let weight = entry.distance.powi(2) * if entry.nearest { 1.0 } else { 1e-6 };
            votes[entry.station as usize][usize::from(entry.side)].push((label[i], i as u32, weight));
        }
    }
    votes
        .into_iter()
        .map(|sides| {
            sides.map(|mut points| {
                points.sort_unstable_by_key(|p| (p.0, p.1));
                let most = points
                    .chunk_by(|x, y| x.0 == y.0)
                    .map(|c| (c.iter().map(|p| p.2).sum::<f64>(), c))
                    .fold(None, |best: Option<(f64, &[Vote])>, c| match best {
                        Some(b) if b.0 >= c.0 => best,
                        _ => Some(c),
                    });
                let Some((total, chunk)) = most else { return (None, [0.0; 3]) };
                let add = |sum, &(_, i, w): &Vote| add_scaled(sum, normals[i as usize], w / total);
                (Some(chunk[0].0), chunk.iter().fold([0.0; 3], add))
            })
        })
        .collect()
}

/// A direction across a strip in space.
pub fn in_space(station: &Station, leave: [f64; 2]) -> [f64; 3] {
    add_scaled(scale(station.across[0], leave[0]), station.across[1], leave[1])
}

/// Whether each part, at the index of its root, encloses a negative volume.
fn inward(
    ground: &Ground,
    label: &[u32],
    normals: &[[f64; 3]],
    parts: &[(u32, bool)],
    area: &[f64],
) -> Vec<bool> {
    let mut centre = vec![([0.0; 3], 0.0); parts.len()];
    let members = || (0..label.len()).filter(|&i| label[i] != NO_PATCH);
    for i in members() {
        let (sum, total) = &mut centre[parts[label[i] as usize].0 as usize];
        *sum = add_scaled(*sum, ground.points[i], area[i]);
        *total += area[i];
    }
    let mut volume = vec![0.0; parts.len()];
    for i in members() {
        let (root, odd) = parts[label[i] as usize];
        let (sum, total) = centre[root as usize];
        let arm = sub(ground.points[i], scale(sum, 1.0 / f64::max(total, f64::MIN_POSITIVE)));
        volume[root as usize] += area[i] * dot(normals[i], arm) * if odd { -1.0 } else { 1.0 };
    }
    volume.into_iter().map(|v| v < 0.0).collect()
}
