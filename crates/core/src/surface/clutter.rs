//! Clutter: the points that lie on no surface.
//!
//! Leaves, rain, stray returns and veils of returns between two surfaces make links through the air, and a chain of them looks
//! like a crease, as both of its sides are empty. A single point without support in a plane proves little: edges, wires and
//! faces a few spacings wide have many such points. So clutter is decided for whole pieces: a crowd of points that mostly lack
//! support is clutter if many of them lie deep in it, or if it touches no surface. A lone point without support is clutter too,
//! such as a stray return or a point in the thread of a veil. Finally points among clutter join it, and so do islands in it
//! that are too small to be surface.

use super::islands::PIECE;
use super::support::{Demand, Plane, supported};
use crate::math::union_find::UnionFind;
use crate::math::vec3::distance;
use crate::neighbors::Neighbors;
use crate::parallel;
use crate::resolution::Resolution;

/// Points with fewer others in one plane with them than this have no support.
const SUPPORT: usize = 8;
/// Mean distance of a point from its nearest neighbours, relative to the spacing around it, above which its support must be more
/// than chance: an upright plane through one point above a noisy face cuts many points of that face.
const OFF: f32 = 2.0;
/// The same above which half of the counted neighbours must lie in one plane with it: a plane laid through one point above a face
/// and a few points of that face has enough for [`SUPPORT`] by chance.
const FAR: f32 = 3.0;
const FAR_SUPPORT: usize = 12;
/// Share of neighbours without support above which a point is in a crowd, and share of neighbours in a crowd above which it
/// lies deep in it.
const CROWD: (f64, f64) = (0.5, 0.75);
/// Least share of a crowd's points that lie deep in it if it is clutter, besides at least [`ISLAND`] points: a crowd along a
/// coarsely sampled edge is mostly rim.
const MOSTLY_DEEP: f64 = 0.5;
/// Greatest length of a link, spacings at its denser end: the point's own or the smoothed one, whichever is greater, as the
/// smoothed spacing of the first points beside a denser surface is too small.
const LINK: f32 = 3.0;
/// Mean distance of a point from its nearest neighbours above which it stands alone, relative to the spacing around it.
const ALONE: f32 = 1.5;
/// Share of neighbours in clutter above which a point joins it: without support, and with it.
const DRAWN: (f64, f64) = (0.2, 0.5);
/// Rounds in which points join clutter; it grows by one neighbour in each.
pub(super) const ROUNDS: usize = 3;
/// Fewest points of a piece of surface.
const ISLAND: u32 = PIECE as u32;

/// What is known of every point before crowds are judged as wholes.
pub(crate) struct Marks {
    /// Points without support.
    pub(super) bare: Vec<bool>,
    /// Points that are clutter by themselves.
    pub(super) alone: Vec<bool>,
    /// Points in a crowd, and those deep in it.
    pub(crate) crowd: Vec<bool>,
    pub(crate) deep: Vec<bool>,
    /// Greatest length of a link from each point.
    pub(crate) reach: Vec<f32>,
}

impl Marks {
    /// `nearest` are the lists of nearest neighbours in order of distance, `raw` the mean distance of the first of them, `spacing`
    /// the same smoothed, `gaps` the distances of rows, zero outside of rows. Points in rows never count as alone, as at the end of
    /// a row the neighbours are farther than within it.
    pub(super) fn new(
        points: &[[f64; 3]],
        nearest: &Neighbors,
        planes: &[Plane],
        (raw, spacing, gaps): (&[f32], &[f32], &[f32]),
        mean: Resolution,
    ) -> Marks {
        let held = |demand: &(dyn Fn(usize) -> Demand + Sync)| {
            supported(points, nearest, planes, raw, spacing, mean, demand)
        };
        let bare: Vec<bool> = held(&|_| Demand::Least(SUPPORT)).iter().map(|s| !s).collect();
        let beyond = |i: usize, times: f32| gaps[i] == 0.0 && raw[i] > times * spacing[i];
        let steady = held(&|i| match i {
            _ if beyond(i, FAR) => Demand::BeyondChance(FAR_SUPPORT),
            _ if beyond(i, OFF) => Demand::BeyondChance(SUPPORT),
            _ => Demand::None,
        });
        let crowd = where_share(nearest, &bare, CROWD.0);
        let deep = where_share(nearest, &crowd, CROWD.1);
        let reach = raw.iter().zip(spacing).map(|(&r, &s)| LINK * r.max(s)).collect();
        let alone = (0..points.len()).map(|i| bare[i] && beyond(i, ALONE) || !steady[i]).collect();
        Marks { bare, alone, crowd, deep, reach }
    }
}

/// Whether a crowd is clutter, by the points in it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Crowd {
    size: u64,
    deep: u64,
    touches: bool,
}

impl Crowd {
    /// Adds a point, deep in the crowd or not, that touches points outside of all crowds or not.
    pub(crate) fn add(&mut self, deep: bool, touches: bool) {
        self.size += 1;
        self.deep += u64::from(deep);
        self.touches |= touches;
    }

    /// Whether it is clutter.
    pub(crate) fn is_clutter(&self) -> bool {
        let deep = self.deep >= u64::from(ISLAND) && self.deep as f64 >= MOSTLY_DEEP * self.size as f64;
        deep || !self.touches
    }
}

/// `(N)` whether each point is clutter, by the crowds that are and apart from islands in it.
pub(super) fn grown(nearest: &Neighbors, marks: &Marks, crowds: &[bool]) -> Vec<bool> {
    let Marks { bare, alone, .. } = marks;
    let mut clutter: Vec<bool> = crowds.iter().zip(alone).map(|(crowd, alone)| *crowd || *alone).collect();
    for _ in 0..ROUNDS {
        let [little, most] = [DRAWN.0, DRAWN.1].map(|share| where_share(nearest, &clutter, share));
        let drawn = |i: usize| clutter[i] || most[i] || (bare[i] && little[i]);
        clutter = parallel::map(bare.len(), parallel::QUICK, drawn);
    }
    clutter
}

/// `(N)` whether more than the given share of the neighbours of each point are marked.
fn where_share(nearest: &Neighbors, marked: &[bool], share: f64) -> Vec<bool> {
    let over = |i: usize| {
        let near = nearest.of(i);
        near.iter().filter(|&&j| marked[j as usize]).count() as f64 > share * near.len() as f64
    };
    parallel::map(marked.len(), parallel::QUICK, over)
}

/// The points of its crowd that point `i` of a crowd is linked to, and whether it touches other points.
///
/// A link has an end deep in the crowd: the strays of a whole cloud are one crowd otherwise, and whether most of it is deep is
/// decided by those just above the surface.
pub(crate) fn links(points: &[[f64; 3]], nearest: &Neighbors, marks: &Marks, i: usize) -> (Vec<u32>, bool) {
    let Marks { crowd, deep, reach, .. } = marks;
    let linked = |&j: &u32| {
        let bound = f64::from(reach[i].min(reach[j as usize]));
        distance(points[i], points[j as usize]) <= bound
    };
    let (others, outside): (Vec<u32>, Vec<u32>) = nearest
        .of(i)
        .iter()
        .copied()
        .filter(linked)
        .partition(|&j| crowd[j as usize] && (deep[i] || deep[j as usize]));
    (others, !outside.is_empty())
}

/// `(N)` whether each point belongs to a crowd that is clutter.
pub(super) fn crowds(points: &[[f64; 3]], nearest: &Neighbors, marks: &Marks) -> Vec<bool> {
    let Marks { crowd, deep, .. } = marks;
    let mut sets = UnionFind::new(points.len());
    let mut touching = vec![false; points.len()];
    for i in (0..points.len()).filter(|&i| crowd[i]) {
        let (others, touches) = links(points, nearest, marks, i);
        others.into_iter().for_each(|j| {
            sets.union(i as u32, j);
        });
        touching[i] = touches;
    }
    let mut pieces = vec![Crowd::default(); points.len()];
    for i in (0..points.len()).filter(|&i| crowd[i]) {
        pieces[sets.find(i as u32) as usize].add(deep[i], touching[i]);
    }
    (0..points.len()).map(|i| crowd[i] && pieces[sets.find(i as u32) as usize].is_clutter()).collect()
}

#[cfg(test)]
mod tests {
    use crate::neighbors::{all_nearest, riemannian};
    use crate::resolution::Resolution;
    use crate::surface::{CLUTTER, sort};

    /// Numbers from 0 to 1, the same each time.
    fn random(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (*seed >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Whether each point is clutter.
    fn clutter(points: &[[f64; 3]]) -> Vec<bool> {
        let nearest = all_nearest(points, 12);
        let mean = Resolution::estimate(points, &nearest, &riemannian::graph(points, &nearest));
        let stands = sort(points, &nearest, mean).stands;
        (0..points.len()).map(|i| stands.get(i) == Some(&CLUTTER)).collect()
    }

    /// Two walls of a room, with one point for each square spacing and 2 % noise.
    fn room(seed: &mut u64) -> Vec<[f64; 3]> {
        let mut at = |i: f64| i + 0.8 * random(seed);
        let cells = |n: u32| (0..n * n).map(move |k| [f64::from(k % n), f64::from(k / n)]);
        let floor: Vec<[f64; 3]> = cells(60).map(|[i, j]| [at(i), at(j), 0.0]).collect();
        floor.into_iter().chain(cells(60).map(|[i, j]| [0.0, at(i), at(j)])).collect()
    }

    #[test]
    fn stray_points_and_leaves_are_clutter_and_walls_are_not() {
        let mut seed = 3;
        let mut points = room(&mut seed);
        let walls = points.len();
        for _ in 0..60 {
            points.push([0; 3].map(|_: i32| 4.0 + 50.0 * random(&mut seed)));
        }
        let strays = points.len();
        for _ in 0..3000 {
            points.push([30.0, 30.0, 30.0].map(|c| c + 9.0 * (random(&mut seed) + random(&mut seed) - 1.0)));
        }
        let found = clutter(&points);
        let share = |some: &[bool]| some.iter().filter(|&&c| c).count() as f64 / some.len() as f64;
        assert!(share(&found[..walls]) < 0.002, "{} of the walls", share(&found[..walls]));
        assert!(share(&found[walls..strays]) > 0.95, "{} of the strays", share(&found[walls..strays]));
        assert!(share(&found[strays..]) > 0.95, "{} of the leaves", share(&found[strays..]));
    }

    #[test]
    fn lone_points_above_a_face_are_clutter() {
        let mut seed = 11;
        let mut points = room(&mut seed);
        let walls = points.len();
        for k in 0..400 {
            let [x, y] = [f64::from(k % 20), f64::from(k / 20)].map(|c| 8.0 + 2.6 * c + random(&mut seed));
            points.push([x, y, 3.0 + 5.0 * random(&mut seed)]);
        }
        let found = clutter(&points);
        let left = found[walls..].iter().filter(|&&c| !c).count();
        assert!(left <= 2, "{left} of 400");
    }

    #[test]
    fn strays_off_a_noisy_face_are_clutter_though_upright_planes_cut_it() {
        let mut seed = 17;
        let bell = |seed: &mut u64| (0..12).map(|_| random(seed)).sum::<f64>() - 6.0;
        let mut points: Vec<[f64; 3]> = (0..80 * 80)
            .map(|_| [80.0 * random(&mut seed), 80.0 * random(&mut seed), 0.25 * bell(&mut seed)])
            .collect();
        let face = points.len();
        for _ in 0..300 {
            points.push([80.0 * random(&mut seed), 80.0 * random(&mut seed), 3.0 + 5.0 * random(&mut seed)]);
        }
        let found = clutter(&points);
        let count = |some: &[bool], clutter: bool| some.iter().filter(|&&c| c == clutter).count();
        let (lost, left) = (count(&found[..face], true), count(&found[face..], false));
        assert!(lost < face / 200 && left < 30, "{lost} of {face} lost, {left} of 300 left");
    }

    #[test]
    fn three_points_far_away_are_clutter() {
        let mut points = room(&mut 5);
        points.extend([[1e5, 0.0, 0.0], [0.0, 1e5, 3.0], [1e5, 1e5, 1e5]]);
        let found = clutter(&points);
        assert_eq!(found.iter().filter(|&&c| c).count(), 3);
        assert!(found[points.len() - 3..].iter().all(|&c| c));
    }

    #[test]
    fn a_rod_and_a_sheet_two_spacings_wide_stay() {
        let mut seed = 7;
        let mut points = room(&mut seed);
        let walls = points.len();
        for k in 0..200 {
            points.push([20.0, 20.0, 5.0 + 0.2 * f64::from(k)]);
            points.push([30.0 + 0.7 * f64::from(k % 3), 30.0, 5.0 + 0.2 * f64::from(k)]);
        }
        let found = clutter(&points);
        let lost = found[walls..].iter().filter(|&&c| c).count();
        assert!(lost < 12, "{lost} of 400");
    }

    #[test]
    fn both_sides_of_a_thin_sheet_stay() {
        let mut seed = 13;
        let mut points = room(&mut seed);
        let walls = points.len();
        for k in 0..1200 {
            let side = 0.5 * f64::from(k % 2) + 0.04 * (random(&mut seed) - 0.5);
            points.push([20.0 + 12.0 * random(&mut seed), 20.0 + side, 5.0 + 50.0 * random(&mut seed)]);
        }
        let found = clutter(&points);
        let lost = found[walls..].iter().filter(|&&c| c).count();
        assert!(lost < 24, "{lost} of 1200");
    }
}
