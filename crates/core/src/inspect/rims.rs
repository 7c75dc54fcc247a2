//! The rims of holes and bosses among the circles of a network, told by the points about them, so that they have a name where no
//! patches were looked for.
//!
//! At such a rim a face and a round wall meet: the points show the face on one side of the circle alone and the wall on one side of
//! its plane alone. Whether the wall goes into the solid is told by the faces that a ray along the axis meets on its way out: their
//! number is even in the open and odd inside (the point in polyhedron test by crossings, for points). Where one of these is unclear,
//! as beside a chamfer or on a scan of one side alone, the circle stays without a name.

use crate::curve::Round;
use crate::curve::pieces::{Piece, Shape};
use crate::math::vec3::{add_scaled, cross, dot, norm, perpendicular, scale, sub};
use crate::network::{Strip, StripKind};
use rayon::prelude::*;

/// The part of a solid or sheet that a circle is the rim of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rim {
    /// Of an opening.
    Hole,
    /// Of what stands out of a face.
    Boss,
}

/// What a circle is the rim of, and where the wall is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RimSide {
    /// What it is the rim of.
    pub rim: Rim,
    /// The unit vector along which the wall leads away from the circle; `None` for an opening in a sheet.
    pub wall: Option<[f64; 3]>,
}

impl Rim {
    /// The name in files.
    pub fn name(self) -> &'static str {
        match self {
            Rim::Hole => "hole",
            Rim::Boss => "boss",
        }
    }
}

/// Parts of a turn in which points are looked for.
const SECTORS: usize = 16;
/// Parts with points from which on there is a face, and up to which there is none.
const PRESENT: u32 = 12;
const ABSENT: u32 = 4;
/// Where face and wall are looked for, distances from the circle in spacings.
const NEAR: std::ops::Range<f64> = 1.0..4.0;
/// Half the thickness in which points count as of one face, spacings.
const THICK: f64 = 1.0;
/// Half the width of a ray, spacings: wide enough to meet some points of any face across it.
const RAY: f64 = 1.2;
/// Distance along a ray beyond which points are of another face, and greatest length of a face along it, spacings.
const GAP: f64 = 2.5;
const ALONG: f64 = 5.0;
/// Fewest rays that tell, and the share of them that must agree.
const VOTES: usize = 4;
const AGREED: f64 = 0.75;
/// Angle of an arc from which on it may bound a hole or a boss, degrees: an arc of less is more likely a rounded corner.
pub(super) const MOST_OF_A_TURN: f64 = 200.0;

/// `(S)` what each strip is the rim of. `points` are those on surfaces, world frame; `spacing` is theirs.
pub fn rims(strips: &[Strip], points: &[[f64; 3]], spacing: f64) -> Vec<Option<RimSide>> {
    if !(spacing > 0.0) || points.is_empty() {
        return vec![None; strips.len()];
    }
    let rim = |strip: &Strip| {
        let circle = circle(strip)?;
        Surround::of(circle, points, spacing).rim(strip.kind, circle.normal)
    };
    strips.par_iter().map(rim).collect()
}

/// The circle of a strip that is one, or most of one.
fn circle(strip: &Strip) -> Option<&Round> {
    match strip.curves.as_slice() {
        [Piece { shape: Shape::Circle(round), .. }] => Some(round),
        [Piece { shape: Shape::Arc { round, sweep }, .. }] if sweep.to_degrees() > MOST_OF_A_TURN => {
            Some(round)
        }
        _ => None,
    }
}

/// The points about a circle. Bits are sectors.
struct Surround {
    /// The face in the plane of the circle, inside and outside of it.
    face: [u32; 2],
    /// The wall below and above that plane.
    wall: [u32; 2],
    /// Heights of the points along the rays inside and outside, one ray a sector.
    rays: [[Vec<f64>; SECTORS]; 2],
    spacing: f64,
}

impl Surround {
    fn of(circle: &Round, points: &[[f64; 3]], h: f64) -> Self {
        let mut found = Surround { face: [0; 2], wall: [0; 2], rays: Default::default(), spacing: h };
        let Round { centre, normal, radius } = *circle;
        let across = perpendicular(normal);
        let frame = [across, cross(normal, across)];
        let middle = 0.5 * (NEAR.start + NEAR.end) * h;
        for &point in points {
            let from = sub(point, centre);
            let height = dot(from, normal);
            let flat = add_scaled(from, normal, -height);
            let away = norm(flat) - radius;
            if away > NEAR.end * h {
                continue;
            }
            let turns = dot(flat, frame[1]).atan2(dot(flat, frame[0])) / std::f64::consts::TAU;
            let sector = ((turns + 1.0) * SECTORS as f64) as usize % SECTORS;
            let (bit, side) = (1 << sector, usize::from(away > 0.0));
            let near = |x: f64| NEAR.contains(&(x.abs() / h));
            if height.abs() < THICK * h && near(away) {
                found.face[side] |= bit;
            }
            if away.abs() < THICK * h && near(height) {
                found.wall[usize::from(height > 0.0)] |= bit;
            }
            // The ray stands in the middle of its sector; inside a small circle all rays are the axis.
            let out = if side == 1 { radius + middle } else { (radius - middle).max(0.0) };
            let (sin, cos) = ((sector as f64 + 0.5) / SECTORS as f64 * std::f64::consts::TAU).sin_cos();
            let foot = add_scaled(frame[0].map(|x| x * out * cos), frame[1], out * sin);
            if norm(sub(flat, foot)) < RAY * h {
                found.rays[side][sector].push(height);
            }
        }
        found
    }

    fn rim(mut self, kind: StripKind, normal: [f64; 3]) -> Option<RimSide> {
        let outside = alone(self.face)?;
        if kind == StripKind::Border {
            // The edge of an opening in a sheet: that of a disc would have its face inside, that of a tube a wall.
            let bare = self.wall.iter().all(|side| side.count_ones() <= ABSENT);
            return (outside == 1 && bare).then_some(RimSide { rim: Rim::Hole, wall: None });
        }
        let wall = alone(self.wall)?;
        let solid = self.solid(outside)?;
        // From a face around it a wall goes into the solid in a hole, and out of it to a boss. A face within is the floor of a
        // hole or the top of a boss.
        let rim = if (wall == solid) == (outside == 1) { Rim::Hole } else { Rim::Boss };
        Some(RimSide { rim, wall: Some(scale(normal, if wall == 1 { 1.0 } else { -1.0 })) })
    }

    /// The side of the face, 0 below or 1 above, on which the solid lies.
    fn solid(&mut self, side: usize) -> Option<usize> {
        let spacing = self.spacing;
        let votes: Vec<usize> =
            self.rays[side].iter_mut().filter_map(|heights| inwards(heights, spacing)).collect();
        let above = votes.iter().sum::<usize>();
        let solid = usize::from(2 * above > votes.len());
        let agreed = above.max(votes.len() - above) as f64;
        (votes.len() >= VOTES && agreed >= AGREED * votes.len() as f64).then_some(solid)
    }
}

/// The one of two sides that is there, if the other is not.
fn alone(sides: [u32; 2]) -> Option<usize> {
    let counts = sides.map(u32::count_ones);
    (0..2).find(|&i| counts[i] >= PRESENT && counts[1 - i] <= ABSENT)
}

/// The side on which a ray from a face meets an odd number of others, 0 below or 1 above, if it meets an even number on the other.
fn inwards(heights: &mut [f64], h: f64) -> Option<usize> {
    heights.sort_unstable_by(f64::total_cmp);
    let own = |&z: &f64| z.abs() <= GAP * h;
    let faces = |side: usize| {
        let beyond = heights.iter().copied().filter(|z| !own(z) && usize::from(*z > 0.0) == side);
        let mut faces: Vec<[f64; 2]> = Vec::new();
        for z in beyond {
            match faces.last_mut() {
                Some([_, end]) if z - *end <= GAP * h => *end = z,
                _ => faces.push([z; 2]),
            }
        }
        // A face along the ray is met anywhere or nowhere.
        faces.iter().all(|[from, to]| to - from <= ALONG * h).then_some(faces.len())
    };
    let odd = [faces(0)? % 2, faces(1)? % 2];
    (odd[0] != odd[1]).then_some(odd[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes;

    /// The rim that a crease is.
    fn rim(points: &[[f64; 3]], h: f64, centre: [f64; 3], normal: [f64; 3], radius: f64) -> Option<Rim> {
        // Which way the normal points means nothing.
        let [a, b] = [1.0, -1.0].map(|sign| {
            let circle = Round { centre, normal: normal.map(|x| sign * x), radius };
            Surround::of(&circle, points, h).rim(StripKind::Crease, circle.normal)
        });
        assert_eq!(a, b);
        a.map(|side| side.rim)
    }

    #[test]
    fn the_bracket_has_a_hole_and_a_boss() {
        let sampled = (shapes::sample("bracket").unwrap().make)(1);
        let (points, h) = (&sampled.cloud.positions, 0.072);
        for z in [0.0, 1.2] {
            assert_eq!(rim(points, h, [2.0, 4.0, z], [0.0, 0.0, 1.0], 0.9), Some(Rim::Hole), "{z}");
        }
        for y in [1.2, 2.2] {
            assert_eq!(rim(points, h, [2.0, y, 3.3], [0.0, 1.0, 0.0], 0.8), Some(Rim::Boss), "{y}");
        }
        // A circle that is none, on a face.
        assert_eq!(rim(points, h, [2.0, 4.0, 1.2], [0.0, 0.0, 1.0], 1.5), None);
    }

    #[test]
    fn a_blind_hole_has_a_rim_and_a_floor() {
        // A block of 4 by 4 by 2 on a grid, with a hole of radius 1 and depth 1.2 in the middle of its top.
        let (h, mut points) = (0.1, Vec::new());
        let steps =
            |from: f64, to: f64| (0..=((to - from) / h).round() as usize).map(move |i| from + i as f64 * h);
        for x in steps(-2.0, 2.0) {
            for y in steps(-2.0, 2.0) {
                points.push([x, y, 0.0]);
                points.push([x, y, if x.hypot(y) > 1.0 { 2.0 } else { 0.8 }]);
            }
            for z in steps(h, 2.0 - h) {
                points.extend([[x, -2.0, z], [x, 2.0, z], [-2.0, x, z], [2.0, x, z]]);
            }
        }
        for z in steps(0.8, 2.0) {
            let at = |i: i32| f64::from(i) / 64.0 * std::f64::consts::TAU;
            points.extend((0..64).map(|i| [at(i).cos(), at(i).sin(), z]));
        }
        let up = [0.0, 0.0, 1.0];
        assert_eq!(rim(&points, h, [0.0, 0.0, 2.0], up, 1.0), Some(Rim::Hole));
        assert_eq!(rim(&points, h, [0.0, 0.0, 0.8], up, 1.0), Some(Rim::Hole));
        // Seen from above alone, nothing tells the solid from the open.
        let seen: Vec<[f64; 3]> =
            points.into_iter().filter(|p| p[2] > 0.5 && p[0].abs().max(p[1].abs()) < 1.95).collect();
        assert_eq!(rim(&seen, h, [0.0, 0.0, 2.0], up, 1.0), None);
    }

    #[test]
    fn a_hole_in_a_sheet_has_a_border() {
        let sampled = (shapes::sample("sheet").unwrap().make)(1);
        let h = (12.0f64 / 15_000.0).sqrt();
        let circle = Round { centre: [1.6, 1.4, 0.0], normal: [0.0, 0.0, 1.0], radius: 0.7 };
        let of = |points: &[[f64; 3]]| {
            Surround::of(&circle, points, h).rim(StripKind::Border, circle.normal).map(|s| s.rim)
        };
        assert_eq!(of(&sampled.cloud.positions), Some(Rim::Hole));
        // The disc that was cut out of it, as far as another part of the sheet can show it.
        let moved = sampled.cloud.positions.iter().map(|p| [p[0] - 1.4, p[1], p[2]]);
        let inside: Vec<[f64; 3]> = moved.filter(|p| (p[0] - 1.6).hypot(p[1] - 1.4) < 0.7).collect();
        assert!(inside.len() > 1000);
        assert_eq!(of(&inside), None);
    }
}
