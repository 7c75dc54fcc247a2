//! Seams: the face of a surface that goes round its axis, such as the side of a cylinder between two circles, is cut open along a
//! line across it, so that it has one loop. Without a seam a face like that has no inside in the parameters of its surface.

use super::edge::points;
use super::tangle::sides;
use super::vertex::{axis, meet, radial};
use super::{Brep, Edge, Face};
use crate::curve::Round;
use crate::curve::pieces::Shape;
use crate::math::vec3::{add_scaled, cross, dot, norm, perpendicular, scale, sub, unit};
use crate::patch::fit::Surface;
use std::collections::BTreeSet;
use std::f64::consts::PI;

/// Length of the mean of unit vectors below which they have no common direction.
const SCATTERED: f64 = 1e-6;
/// Directions that are tried for a seam, and the angle from a hole up to which one lies beside it, radians.
const TRIED: usize = 72;
const BESIDE: f64 = 0.02;

/// Cuts open what goes round, and says from where the angle about the axis of each surface counts.
pub(super) fn seams(found: &mut Brep) {
    let mut fixed = fixed(found);
    let all = 0..found.faces.len();
    let mut open: Vec<(usize, usize)> = all.filter_map(|f| Some((f, goes_round(found, f)?))).collect();
    // Vertices of circles follow those that are settled: along a shaft from one collar to the next.
    while !open.is_empty() {
        let next = open.iter().position(|&(f, holes)| settled(found, f, holes, &fixed) > 0).unwrap_or(0);
        let (f, holes) = open.remove(next);
        cut_soundly(found, f, holes, &mut fixed);
    }
    for f in 0..found.faces.len() {
        if found.faces[f].first == [0.0; 3] {
            (found.faces[f].axis, found.faces[f].first) = behind(found, &found.faces[f]);
        }
    }
}

/// The vertices that stay where they are: all but those of whole circles.
fn fixed(found: &Brep) -> BTreeSet<u32> {
    let mut uses = vec![0; found.vertices.len()];
    found.edges.iter().flat_map(|e| e.ends).for_each(|v| uses[v as usize] += 1);
    let free = |e: &&Edge| matches!(e.shape, Shape::Circle(_)) && uses[e.ends[0] as usize] == 2;
    let free: BTreeSet<u32> = found.edges.iter().filter(free).map(|e| e.ends[0]).collect();
    (0..found.vertices.len() as u32).filter(|v| !free.contains(v)).collect()
}

/// Points along a loop, in its direction.
fn along(found: &Brep, row: &[(u32, bool)]) -> Vec<[f64; 3]> {
    let of = |&(e, forward): &(u32, bool)| {
        let edge = &found.edges[e as usize];
        let mut own = points(&edge.shape, edge.ends.map(|v| found.vertices[v as usize]));
        if !forward {
            own.reverse();
        }
        own
    };
    row.iter().flat_map(of).collect()
}

/// Whether a loop goes round an axis.
fn winds(found: &Brep, row: &[(u32, bool)], about: ([f64; 3], [f64; 3])) -> bool {
    let points = along(found, row);
    let turn = |w: &[[f64; 3]]| {
        let [a, b] = [w[0], w[1]].map(|p| radial(about, p));
        dot(cross(a, b), about.1).atan2(dot(a, b))
    };
    points.windows(2).map(turn).sum::<f64>().abs() > PI
}

/// Where two loops of a face go round its axis, or one about an apex, puts these first and says how many others there are.
fn goes_round(found: &mut Brep, f: usize) -> Option<usize> {
    let Face { surface, loops, .. } = found.faces[f].clone();
    let about = axis(&surface)?;
    let (round, holes): (Vec<_>, Vec<_>) = loops.into_iter().partition(|row| winds(found, row, about));
    let wanted = if matches!(surface, Surface::Cone { .. }) { 1..=2 } else { 2..=2 };
    let count = holes.len();
    wanted.contains(&round.len()).then(|| {
        found.faces[f].loops = round.into_iter().chain(holes).collect();
        count
    })
}

/// The direction from an axis that lies farthest from the holes of a face, of evenly spaced ones beginning at `zero`; and how far
/// `zero` itself lies from them, radians.
fn clear(
    found: &Brep,
    holes: &[Vec<(u32, bool)>],
    about: ([f64; 3], [f64; 3]),
    zero: [f64; 3],
) -> ([f64; 3], f64) {
    let seen: Vec<[f64; 3]> =
        holes.iter().flat_map(|row| along(found, row)).map(|p| unit(radial(about, p))).collect();
    let other = cross(about.1, zero);
    let away = |d: [f64; 3]| seen.iter().map(|&s| dot(s, d).clamp(-1.0, 1.0).acos()).fold(PI, f64::min);
    let at = |k: usize| {
        let (sin, cos) = (2.0 * PI * k as f64 / TRIED as f64).sin_cos();
        add_scaled(scale(zero, cos), other, sin)
    };
    let best = (0..TRIED).map(at).max_by(|&a, &b| away(a).total_cmp(&away(b))).unwrap_or(zero);
    (best, away(zero))
}

/// The vertex at which a loop begins.
fn start(found: &Brep, row: &[(u32, bool)]) -> u32 {
    let (edge, forward) = row[0];
    found.edges[edge as usize].ends[usize::from(!forward)]
}

/// The number of loops round a face whose first vertex stays.
fn settled(found: &Brep, f: usize, holes: usize, fixed: &BTreeSet<u32>) -> usize {
    let loops = &found.faces[f].loops;
    loops[..loops.len() - holes].iter().filter(|row| fixed.contains(&start(found, row))).count()
}

/// Cuts a face open from the first vertex of its loops from which the seam crosses neither of them; else from the first.
fn cut_soundly(found: &mut Brep, f: usize, holes: usize, fixed: &mut BTreeSet<u32>) {
    let loops = &found.faces[f].loops;
    let turns = loops[..loops.len() - holes].iter().map(Vec::len).max().unwrap_or(0);
    let cut_from = |turn: usize| {
        let (mut tried, mut held) = (found.clone(), fixed.clone());
        for row in &mut tried.faces[f].loops {
            let first = turn % row.len().max(1);
            row.rotate_left(first);
        }
        cut(&mut tried, f, holes, &mut held);
        (tried, held)
    };
    let sound = |(tried, _): &(Brep, _)| {
        let face = &tried.faces[f];
        face.first != [0.0; 3] && sides(tried, face).is_some()
    };
    (*found, *fixed) = (0..turns).map(cut_from).find(sound).unwrap_or_else(|| cut_from(0));
}

/// Cuts a face open, unless both of its loops are settled: their vertices do not lie across from each other.
fn cut(found: &mut Brep, f: usize, holes: usize, fixed: &mut BTreeSet<u32>) {
    let Face { surface, outward, mut loops, .. } = found.faces[f].clone();
    let Some(about) = axis(&surface) else { return };
    let holes = loops.split_off(loops.len() - holes);
    if loops.len() == 2 && fixed.contains(&start(found, &loops[1])) {
        loops.swap(0, 1);
    }
    let from = start(found, &loops[0]);
    let towards = unit(radial(about, found.vertices[from as usize]));
    let (best, distance) = clear(found, &holes, about, towards);
    let towards = if distance > BESIDE {
        towards
    } else if !fixed.contains(&from) && across(found, &loops[0], (about, best), &surface).is_some() {
        best
    } else {
        return;
    };
    let at = found.vertices[from as usize];
    let to = match loops.get(1) {
        Some(row) if fixed.contains(&start(found, row)) => return,
        Some(row) => across(found, row, (about, towards), &surface),
        None => apex(found, &surface),
    };
    let Some(to) = to else { return };
    let ahead = along(found, &loops[0]);
    let out = scale(surface.normal(at), if outward { 1.0 } else { -1.0 });
    // Into the face, which lies to the left.
    let inwards = cross(out, sub(ahead[1], ahead[0]));
    let shape = crossing(&surface, [at, found.vertices[to as usize]], towards, inwards);
    let seam = found.edges.len() as u32;
    let strip = found.edges[loops[0][0].0 as usize].strip;
    found.edges.push(Edge { shape, ends: [from, to], strip });
    fixed.extend([from, to]);
    let mut row = loops.remove(0);
    row.push((seam, true));
    row.extend(loops.pop().unwrap_or_default());
    row.push((seam, false));
    let face = &mut found.faces[f];
    (face.loops, face.axis, face.first) = ([vec![row], holes].concat(), about.1, towards);
}

/// The line across a surface between two points in one half plane of its axis, that begins in a direction.
fn crossing(surface: &Surface, [from, to]: [[f64; 3]; 2], towards: [f64; 3], inwards: [f64; 3]) -> Shape {
    let Surface::Torus { center, axis, major, minor } = *surface else { return Shape::Line };
    let centre = add_scaled(center, towards, major);
    let normal = cross(axis, towards);
    let side = dot(cross(normal, sub(from, centre)), inwards).signum();
    let round = Round { centre, radius: minor, normal: scale(normal, side) };
    Shape::Arc { round, sweep: round.sweep_between(from, to) }
}

/// Moves the vertex of a circle to where the half plane from the axis towards a direction meets it.
fn across(
    found: &mut Brep,
    row: &[(u32, bool)],
    (about, towards): (([f64; 3], [f64; 3]), [f64; 3]),
    surface: &Surface,
) -> Option<u32> {
    let [(edge, _)] = *row else { return None };
    let edge = &found.edges[edge as usize];
    let (Shape::Circle(round), vertex) = (&edge.shape, edge.ends[0]) else { return None };
    let plane = |point, normal| Surface::Plane { point, normal };
    let near = round.foot(add_scaled(round.centre, towards, round.radius));
    let on = [*surface, plane(about.0, cross(about.1, towards)), plane(round.centre, round.normal)];
    found.vertices[vertex as usize] = meet(near, &on);
    Some(vertex)
}

fn apex(found: &mut Brep, surface: &Surface) -> Option<u32> {
    let Surface::Cone { apex, .. } = surface else { return None };
    found.vertices.push(*apex);
    Some(found.vertices.len() as u32 - 1)
}

/// The axis of a surface, and the direction across it that lies farthest from the face, where its angle may jump.
fn behind(found: &Brep, face: &Face) -> ([f64; 3], [f64; 3]) {
    let rows: Vec<Vec<[f64; 3]>> = face.loops.iter().map(|row| along(found, row)).collect();
    if let Surface::Plane { normal, .. } = face.surface {
        return (normal, perpendicular(normal));
    }
    if let Surface::Sphere { center, .. } = face.surface {
        // The poles lie beside the cap.
        let vector = |w: &[[f64; 3]]| cross(sub(w[0], center), sub(w[1], center));
        let areas = rows.iter().flat_map(|row| row.windows(2)).map(vector);
        let area = areas.fold([0.0; 3], |sum, a| add_scaled(sum, a, if face.outward { 1.0 } else { -1.0 }));
        if norm(area) > 0.0 {
            let cap = unit(area);
            return (perpendicular(cap), scale(cap, -1.0));
        }
        return ([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    }
    let about = axis(&face.surface).unwrap_or(([0.0; 3], [0.0, 0.0, 1.0]));
    let directions = rows.iter().flatten().map(|&p| unit(radial(about, p)));
    let mean = directions.fold([0.0; 3], |sum, d| add_scaled(sum, d, 1.0));
    let count = rows.iter().flatten().count().max(1) as f64;
    let first = if norm(mean) > SCATTERED * count { scale(unit(mean), -1.0) } else { perpendicular(about.1) };
    (about.1, first)
}
