//! Triangles of a face. A convex face is a fan; from others ears are cut (Meisters, "Polygons have ears", 1975), in the plane of
//! the face.

use crate::math::vec3::{add, cross, dot, sub};

/// Corners up to which ears are looked for, which takes the square of their number.
const MOST_EARS: usize = 256;

/// Appends the triangles of a face whose corners lie at `at`; `false` where it is not convex and has too many corners.
pub(super) fn split(face: &[u32], at: impl Fn(u32) -> [f64; 3], out: &mut Vec<[u32; 3]>) -> bool {
    let points: Vec<[f64; 3]> = face.iter().map(|&v| at(v)).collect();
    let normal = newell(&points);
    if convex(&points, normal) {
        out.extend((1..face.len() - 1).map(|i| [face[0], face[i], face[i + 1]]));
        return true;
    }
    if face.len() > MOST_EARS {
        return false;
    }
    let ears = clip(face.len(), |left, i| is_ear(&points, left, i, normal));
    out.extend(ears.into_iter().map(|ear| ear.map(|i| face[i])));
    true
}

/// The triangles that ears of a polygon of three corners or more are cut to. `is_ear` tells whether a corner, counted along those that
/// are left, is an ear; it is asked three times at most for each.
fn clip(corners: usize, mut is_ear: impl FnMut(&[usize], usize) -> bool) -> Vec<[usize; 3]> {
    let mut out = Vec::with_capacity(corners - 2);
    let mut left: Vec<usize> = (0..corners).collect();
    let mut ears: Vec<bool> = (0..corners).map(|i| is_ear(&left, i)).collect();
    while left.len() > 3 {
        let count = left.len();
        // Where rounding leaves no ear, any corner does.
        let ear = ears.iter().position(|&e| e).unwrap_or(0);
        out.push([(ear + count - 1) % count, ear, (ear + 1) % count].map(|i| left[i]));
        left.remove(ear);
        ears.remove(ear);
        // No corner but the two beside it becomes an ear or ceases to be one: an ear is convex and lies in no other.
        for i in [(ear + count - 2) % (count - 1), ear % (count - 1)] {
            ears[i] = is_ear(&left, i);
        }
    }
    out.push([left[0], left[1], left[2]]);
    out
}

/// Twice the vector area of a polygon, relative to its first corner (Newell's normal).
fn newell(points: &[[f64; 3]]) -> [f64; 3] {
    let from = |i: usize| sub(points[i], points[0]);
    (1..points.len() - 1).fold([0.0; 3], |sum, i| add(sum, cross(from(i), from(i + 1))))
}

/// Whether no corner turns against the normal; a face that winds round twice does not count as one, as none is seen.
fn convex(points: &[[f64; 3]], normal: [f64; 3]) -> bool {
    let n = points.len();
    n == 3 || (0..n).all(|i| turn(points[i], points[(i + 1) % n], points[(i + 2) % n], normal) >= 0.0)
}

/// Twice the area of a triangle as seen along the normal, times the length of the normal.
fn turn(a: [f64; 3], b: [f64; 3], c: [f64; 3], normal: [f64; 3]) -> f64 {
    dot(cross(sub(b, a), sub(c, b)), normal)
}

/// Whether the corner `i` of those left is convex and its triangle holds no other corner.
fn is_ear(points: &[[f64; 3]], left: &[usize], i: usize, normal: [f64; 3]) -> bool {
    let count = left.len();
    let [a, b, c] = [(i + count - 1) % count, i, (i + 1) % count];
    let [pa, pb, pc] = [a, b, c].map(|k| points[left[k]]);
    let inside = |p: [f64; 3]| {
        turn(pa, pb, p, normal) >= 0.0 && turn(pb, pc, p, normal) >= 0.0 && turn(pc, pa, p, normal) >= 0.0
    };
    let corner = |p: [f64; 3]| p == pa || p == pb || p == pc;
    turn(pa, pb, pc, normal) > 0.0
        && !(0..count).any(|k| ![a, b, c].contains(&k) && !corner(points[left[k]]) && inside(points[left[k]]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3::norm;

    fn area(points: &[[f64; 3]]) -> (usize, f64) {
        let mut out = Vec::new();
        let face: Vec<u32> = (0..points.len() as u32).collect();
        assert!(split(&face, |v| points[v as usize], &mut out));
        let size = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| points[v as usize]);
            0.5 * norm(cross(sub(b, a), sub(c, a)))
        };
        (out.len(), out.iter().map(size).sum())
    }

    #[test]
    fn an_l_is_split_into_triangles_of_its_own_area() {
        let l = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 4.0], [0.0, 4.0]];
        for first in 0..6 {
            let turned: Vec<[f64; 3]> =
                (0..6).map(|i| [l[(first + i) % 6][0], 2.0, l[(first + i) % 6][1]]).collect();
            assert_eq!(area(&turned), (4, 6.0));
            let back: Vec<[f64; 3]> = turned.iter().rev().copied().collect();
            assert_eq!(area(&back), (4, 6.0));
        }
    }

    #[test]
    fn a_convex_face_is_a_fan_whatever_its_corners() {
        let corner = |i: u32| {
            let turn = std::f64::consts::TAU * f64::from(i) / 1000.0;
            [turn.cos(), turn.sin(), 0.0]
        };
        let disc: Vec<[f64; 3]> = (0..1000).map(corner).collect();
        let (count, area) = area(&disc);
        assert!(count == 998 && (area - std::f64::consts::PI).abs() < 1e-4, "{count} {area}");
    }

    #[test]
    fn corners_that_are_nearly_all_reflex_are_asked_for_ears_three_times_each() {
        // A spiral band of 254 corners.
        let along = |i: u32, wide: f64| {
            let turn = 40.0 * std::f64::consts::PI * f64::from(i) / 126.0;
            [(turn + wide) * turn.cos(), (turn + wide) * turn.sin(), 0.0]
        };
        let inner = (0..127).map(|i| along(i, 1.0));
        let band: Vec<[f64; 3]> = inner.chain((0..127).rev().map(|i| along(i, 1.3))).collect();
        let (mut asked, normal) = (0, newell(&band));
        let triangles = clip(254, |left, i| {
            asked += 1;
            is_ear(&band, left, i, normal)
        });
        assert!(triangles.len() == 252 && asked <= 3 * 254, "{} {asked}", triangles.len());
    }

    #[test]
    fn many_corners_that_are_not_convex_are_refused() {
        let radius = |i: u32| if i.is_multiple_of(2) { 1.0 } else { 2.0 };
        let corner = |i: u32| {
            let turn = std::f64::consts::TAU * f64::from(i) / 300.0;
            [radius(i) * turn.cos(), radius(i) * turn.sin(), 0.0]
        };
        let star: Vec<[f64; 3]> = (0..300).map(corner).collect();
        let face: Vec<u32> = (0..300).collect();
        assert!(!split(&face, |v| star[v as usize], &mut Vec::new()));
    }
}
