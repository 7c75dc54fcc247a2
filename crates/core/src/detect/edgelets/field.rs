//! The field: at every point the direction in which the surface does not change, and its normal fitted to points along it.

use crate::math::eigen3::{Eigen3, Symmetric3, eigen3};
use crate::math::tensor::{add_product, apply, centred};
use crate::math::vec3::{add, add_scaled, dot, norm, scale, sub, unit};
use crate::neighbors::{Found, Index};
use crate::parallel;
use crate::surface::Scales;

/// Rounds in which normals are fitted along the directions of the last round.
const ROUNDS: usize = 3;
/// Scale of the weights of normals in the structure tensor, in spacings, and the distance at which they end.
const TENSOR: (f64, f64) = (3.5, 4.7);
/// Weight of the plane through all points around beside that of all their normals: it leans at a step between two parallel faces,
/// whose normals show nothing.
const TILT: f64 = 1.0;
/// Least mean square of the normals across the direction of least change at a fold.
const BEND: f64 = 0.03;
/// The same at a place that is looked at closely, together with its surroundings.
const WORTH: f64 = 0.01;
/// Distance of the places at which folds are looked for first, in spacings, and the reach around those that show one.
const LOOK: (f64, f64) = (2.0, 3.0);
/// Distance from a seed within which normals must turn, in spacings, and the greatest cosine of such a turn.
const CHANGE: (f64, f64) = (3.2, 0.966);
/// Height of a step beyond what a bend explains, in spacings, and what a spacing of noise adds.
const JUMP: (f64, f64) = (0.4, 3.0);
/// Slope of the plane through all points from which steps are looked for, for a least height of one spacing.
const LEAN: f64 = 0.08;
/// Least share of such points around a point at a step.
const ASIDE: f64 = 0.08;
/// Scale of a tube across, in spacings.
const ACROSS: f64 = 1.3;
/// Scale of a tube along without noise, in spacings, what a spacing of noise adds, and the greatest.
const ALONG: (f64, f64, f64) = (3.0, 14.0, 7.0);
/// A place is crowded where a reach holds so many times the points of an even plane: sampling is too uneven there for reaches in
/// its spacing, which would hold a good part of the cloud.
const CROWDED: f64 = 8.0;
/// Exponent at which the weights of a tube end.
const END: f64 = 6.9;
/// Exponent at which the weight of a point of another face is nothing.
const NOTHING: f64 = 12.0;
/// Standard deviation of normals of one face, radians: in the first round and later.
const SPREAD: [f64; 2] = [0.45, 0.3];
/// Standard deviation of points of one face in noise, and the least in spacings.
const THICK: ([f64; 3], f64) = ([2.0, 2.0, 1.5], 0.05);

/// The field of a cloud: a row for each point near a fold.
#[derive(Clone, Debug)]
pub(super) struct Field<'a> {
    pub(super) points: &'a [[f64; 3]],
    pub(super) index: &'a Index,
    pub(super) scales: Scales<'a>,
    /// Normals away from folds.
    flat: &'a [[f32; 3]],
    /// The points near folds, ascending, and the row of every point; `FAR` for the others.
    pub(super) near: Vec<u32>,
    row: Vec<u32>,
    rows: Vec<Row>,
}

/// What the field says of a point.
#[derive(Clone, Copy, Debug)]
struct Row {
    /// Unit normal, of either sign.
    normal: [f64; 3],
    /// Place on the fitted plane.
    place: [f64; 3],
    tensor: Tensor,
}

const FAR: u32 = u32::MAX;

/// The structure tensor of the normals around a point.
#[derive(Clone, Copy, Debug)]
struct Tensor {
    /// Unit direction of least change, of either sign.
    along: [f64; 3],
    bend: f64,
    /// How certain the direction is, 0 to 1.
    grade: f64,
}

impl Tensor {
    /// The tensor with the entries `m` of normals that weigh `sum` together.
    fn of(m: &Symmetric3, sum: f64) -> Tensor {
        let Eigen3 { values: [least, middle, _], vectors } = eigen3(m);
        Tensor { along: vectors[0], bend: middle / sum, grade: (middle - least) / middle.max(1e-12) }
    }
}

/// Moments of the points around one of them.
#[derive(Default)]
struct Face {
    sum: f64,
    first: [f64; 3],
    second: Symmetric3,
}

impl Face {
    /// Adds a point at offset `d` with weight `w`.
    fn add(&mut self, d: [f64; 3], w: f64) {
        self.sum += w;
        self.first = add_scaled(self.first, d, w);
        add_product(&mut self.second, d, w);
    }

    /// The normal of the plane through all points.
    fn normal(&self) -> [f64; 3] {
        eigen3(&self.tensor()).vectors[0]
    }

    /// Slope of the plane through all points over the plane with unit normal `n`.
    fn lean(&self, n: [f64; 3]) -> f64 {
        let t = self.tensor();
        let tilted = apply(&t, n);
        let thick = dot(tilted, n);
        2.0 * norm(add_scaled(tilted, n, -thick)) / (t[0] + t[3] + t[5] - thick).max(f64::MIN_POSITIVE)
    }

    fn tensor(&self) -> Symmetric3 {
        centred(self.first, self.second, self.sum).1
    }
}

/// A point in a tube: its index, offset from the tube's centre and weight.
type InTube = (u32, [f64; 3], f64);

impl<'a> Field<'a> {
    /// The field of points with unit normals of either sign.
    pub(super) fn new(
        points: &'a [[f64; 3]],
        flat: &'a [[f32; 3]],
        index: &'a Index,
        scales: Scales<'a>,
    ) -> Field<'a> {
        let (near, row) = (Vec::new(), vec![FAR; points.len()]);
        let mut field = Field { points, index, scales, flat, near, row, rows: Vec::new() };
        field.look();
        for round in 0..ROUNDS {
            let spread = SPREAD[round.min(1)];
            let fitted = parallel::map_with(field.near.len(), parallel::SLOW, |tube: &mut Vec<InTube>, r| {
                let row = &field.rows[r];
                let fit = (row.tensor.bend > BEND)
                    .then(|| field.fit(field.near[r] as usize, row.tensor.along, spread, tube));
                fit.flatten().unwrap_or((row.normal, row.place))
            });
            field.rows.iter_mut().zip(fitted).for_each(|(row, fit)| (row.normal, row.place) = fit);
            let tensors =
                parallel::map(field.near.len(), parallel::SLOW, |r| field.tensor(field.near[r] as usize));
            let tensors = field.rows.iter_mut().zip(tensors);
            tensors.for_each(|(row, tensor)| row.tensor = tensor.unwrap_or(row.tensor));
        }
        field
    }

    /// Unit normal of point `i`, of either sign.
    pub(super) fn normal(&self, i: usize) -> [f64; 3] {
        self.rows.get(self.row[i] as usize).map_or_else(|| self.flat[i].map(f64::from), |row| row.normal)
    }

    /// The place of point `i` on the surface.
    pub(super) fn place(&self, i: usize) -> [f64; 3] {
        self.rows.get(self.row[i] as usize).map_or(self.points[i], |row| row.place)
    }

    /// The direction of least change at point `i`, of either sign, and how certain it is, 0 to 1; `None` away from folds.
    pub(super) fn along(&self, i: usize) -> Option<([f64; 3], f64)> {
        let tensor = &self.rows.get(self.row[i] as usize)?.tensor;
        (tensor.bend > BEND).then_some((tensor.along, tensor.grade))
    }

    /// Whether the normals around point `i` turn, or the surface steps aside, within the reach of a cross-section's middle.
    pub(super) fn changes(&self, i: usize) -> bool {
        let (reach, cosine) = CHANGE;
        let own = self.normal(i);
        let mut turns = 0;
        self.around(self.points[i], reach, self.scales.at(i).spacing, |f| {
            let j = f.index as usize;
            turns += u32::from(dot(self.normal(j), own).abs() < cosine || self.steps_aside(i, j));
        }) && turns > 1
    }

    /// Whether points `i` and `j` lie on parallel faces at different heights.
    fn steps_aside(&self, i: usize, j: usize) -> bool {
        let [n, m] = [i, j].map(|k| self.normal(k));
        let step = sub(self.place(j), self.place(i));
        dot(n, m).abs() >= CHANGE.1 && dot(n, step).abs().min(dot(m, step).abs()) > self.jump(i)
    }

    /// Least height of a step at point `i`.
    fn jump(&self, i: usize) -> f64 {
        let resolution = self.scales.at(i);
        JUMP.0 * resolution.spacing + JUMP.1 * resolution.noise
    }

    /// Passes the points within `reach` spacings `h` of a place to `take`; false, and not all of them, where it is crowded.
    pub(super) fn around(&self, place: [f64; 3], reach: f64, h: f64, take: impl FnMut(Found)) -> bool {
        let most = (CROWDED * std::f64::consts::PI * reach * reach) as usize;
        self.index.around_at_most(place, reach * h, most, take)
    }

    /// Finds the points near folds, from places spread over the cloud.
    fn look(&mut self) {
        let (apart, reach) = LOOK;
        let mut passed = vec![false; self.points.len()];
        let mut places: Vec<usize> = Vec::new();
        for i in 0..self.points.len() {
            let h = self.scales.at(i).spacing;
            if !passed[i] && self.around(self.points[i], apart, h, |f| passed[f.index as usize] = true) {
                places.push(i);
            }
        }
        let bends = |k: usize| self.tensor(places[k]).is_some_and(|t| t.bend > WORTH);
        let bends = parallel::map(places.len(), parallel::SLOW, bends);
        let mut near = vec![false; self.points.len()];
        for (&i, _) in places.iter().zip(bends).filter(|(_, bends)| *bends) {
            let h = self.scales.at(i).spacing;
            self.around(self.points[i], reach, h, |f| near[f.index as usize] = true);
        }
        let row = |i: u32| {
            let (i, own) = (i as usize, self.points[i as usize]);
            Some(Row { normal: unit(self.flat[i].map(f64::from)), place: own, tensor: self.tensor(i)? })
        };
        let near: Vec<u32> = (0..self.points.len() as u32).filter(|&i| near[i as usize]).collect();
        let rows = parallel::map(near.len(), parallel::SLOW, |k| row(near[k]));
        (self.near, self.rows) = near.into_iter().zip(rows).filter_map(|(i, row)| Some((i, row?))).unzip();
        self.near.iter().zip(0..).for_each(|(&i, r)| self.row[i as usize] = r);
    }

    /// The tensor at point `i`; `None` where it is crowded.
    fn tensor(&self, i: usize) -> Option<Tensor> {
        let h = self.scales.at(i).spacing;
        let (mut m, mut sum) = ([0.0; 6], 0.0);
        let mut face = Face::default();
        let (own, facing) = (self.points[i], self.normal(i));
        let (wide, reach) = TENSOR;
        let scale = -1.0 / (wide * h * wide * h);
        let all = self.around(own, reach, h, |f| {
            let w = (f.distance2 * scale).exp();
            let normal = self.normal(f.index as usize);
            add_product(&mut m, normal, w);
            sum += w;
            if dot(normal, facing).abs() >= CHANGE.1 {
                face.add(sub(self.points[f.index as usize], own), w * w);
            }
        });
        let mut tensor = Tensor::of(&m, sum);
        let leans = tensor.bend <= BEND && face.lean(facing) > LEAN * self.jump(i) / h;
        if leans && self.share_aside(i, &face) > ASIDE {
            add_product(&mut m, face.normal(), TILT * sum);
            tensor = Tensor::of(&m, sum);
        }
        all.then_some(tensor)
    }

    /// Weight of the points at another height among the points around point `i` whose normals are like its own.
    fn share_aside(&self, i: usize, face: &Face) -> f64 {
        let h = self.scales.at(i).spacing;
        let (wide, reach) = TENSOR;
        let scale = -2.0 / (wide * h * wide * h);
        let mut aside = 0.0;
        self.around(self.points[i], reach, h, |f| {
            if self.steps_aside(i, f.index as usize) {
                aside += (f.distance2 * scale).exp();
            }
        });
        aside / face.sum
    }

    /// The points in the tube around point `i`; false where it is crowded.
    fn tube(&self, i: usize, along: [f64; 3], tube: &mut Vec<InTube>) -> bool {
        let resolution = self.scales.at(i);
        let h = resolution.spacing;
        let (least, noisy, most) = ALONG;
        let reach = (least + noisy * resolution.noise / h).min(most);
        let long = reach * h;
        let own = self.points[i];
        tube.clear();
        self.around(own, 1.5 * reach, h, |f| {
            let d = sub(self.points[f.index as usize], own);
            let a = dot(d, along);
            let across2 = (f.distance2 - a * a).max(0.0);
            let e = 2.0 * (a / long).powi(2) + 2.0 * across2 / (ACROSS * h).powi(2);
            if e < END {
                tube.push((f.index, d, (-e).exp()));
            }
        })
    }

    /// Normal and place of point `i`: the plane of the points of its own face in its tube, by weights that are taken anew from each
    /// plane. `None` where it is crowded.
    fn fit(
        &self,
        i: usize,
        along: [f64; 3],
        spread: f64,
        tube: &mut Vec<InTube>,
    ) -> Option<([f64; 3], [f64; 3])> {
        if !self.tube(i, along, tube) {
            return None;
        }
        let resolution = self.scales.at(i);
        let (thick, least) = THICK;
        let own = self.points[i];
        let (mut n, mut foot) = (self.normal(i), sub(self.place(i), own));
        for thick in thick {
            let s = thick * resolution.noise.max(least * resolution.spacing);
            let (mut sum, mut centre, mut m) = (0.0, [0.0; 3], [0.0; 6]);
            for &(j, d, w) in tube.iter() {
                let off = dot(sub(d, foot), n) / s;
                let cosine = dot(self.normal(j as usize), n);
                let e = 0.5 * off * off + (1.0 - cosine * cosine) / (2.0 * spread * spread);
                if e < NOTHING {
                    let w = w * (-e).exp();
                    sum += w;
                    centre = add_scaled(centre, d, w);
                    add_product(&mut m, d, w);
                }
            }
            if sum < 1e-6 {
                break;
            }
            centre = scale(centre, 1.0 / sum);
            add_product(&mut m, centre, -sum);
            n = eigen3(&m).vectors[0];
            foot = scale(n, dot(centre, n));
        }
        Some((n, add(own, foot)))
    }
}
