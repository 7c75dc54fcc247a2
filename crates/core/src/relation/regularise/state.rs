//! The relations as they stand after imposition: those that hold, by what was solved, and those that were released, as they were found.

use super::super::find::Found;
use super::super::listed::Place;
use super::super::relations::Relation;
use super::imposed::Imposed;
use super::layout::{Layout, triple};
use crate::math::vec3::{add_scaled, dot};

/// The relations of a network that was moved to the unknowns `x`. Members that were released are left out of those that hold.
pub(super) fn state(found: &Found, imposed: &Imposed, layout: &Layout, x: &[f64]) -> Vec<Relation> {
    let one = |(place, relation): (Place, Relation)| match held(found, imposed, place) {
        Some([members, others]) => {
            let [members, others] = [members, others].map(|of| found.named(&of));
            solved(imposed, layout, x, place, Relation { members, others, imposed: true, ..relation })
        }
        None => relation,
    };
    found.listed().into_iter().map(one).collect()
}

/// The members and the others of a relation that is imposed.
fn held(found: &Found, imposed: &Imposed, place: Place) -> Option<[Vec<usize>; 2]> {
    let class = |c: usize| imposed.classes[c].clone();
    let both = match place {
        Place::Class(c) => [Some(class(c)).filter(|c| c.len() > 1)?, Vec::new()],
        Place::Right(k) => imposed.right.iter().find(|r| r.found == k)?.classes.map(class),
        Place::Plane(k) => [imposed.planes.iter().find(|p| p.found == k)?.members.clone(), Vec::new()],
        Place::Axis(k) => [imposed.axes.iter().find(|a| a.found == k)?.members.clone(), Vec::new()],
        Place::Radius(k) => [imposed.radii.iter().find(|r| r.found == k)?.members.clone(), Vec::new()],
        Place::Tangent(k) => {
            [imposed.tangents.contains(&k).then(|| found.tangents[k].features.to_vec())?, Vec::new()]
        }
        Place::Mirror => return None,
    };
    Some(both)
}

/// A relation that is imposed, with what its curves now share.
fn solved(imposed: &Imposed, layout: &Layout, x: &[f64], place: Place, mut relation: Relation) -> Relation {
    let turned = |c: usize| layout.class[c].map(|at| triple(x, at));
    match place {
        Place::Class(c) => relation.direction = turned(c),
        Place::Plane(k) => {
            let plane = imposed.planes.iter().zip(&layout.plane).find(|p| p.0.found == k);
            if let Some((normal, height, point)) =
                plane.and_then(|(p, &at)| Some((turned(p.class)?, x[at], relation.point?)))
            {
                relation.direction = Some(normal);
                relation.point = Some(add_scaled(point, normal, height - dot(normal, point)));
            }
        }
        Place::Axis(k) => {
            let first = imposed.axes.iter().find(|a| a.found == k).map(|a| a.members[0]);
            let first = first.and_then(|i| Some((layout.direction[i]?, layout.centre[i]?)));
            if let Some((((direction, sign), centre), old)) = first.zip(relation.direction) {
                let now = triple(x, direction).map(|d| sign * d);
                relation.direction = Some(if dot(now, old) < 0.0 { now.map(|d| -d) } else { now });
                relation.point = Some(triple(x, centre));
            }
        }
        Place::Radius(k) => {
            let first = imposed.radii.iter().find(|r| r.found == k).map(|r| r.members[0]);
            relation.radius = first.and_then(|i| layout.radius[i]).map(|at| x[at]).or(relation.radius);
        }
        Place::Right(_) | Place::Tangent(_) | Place::Mirror => {}
    }
    relation
}
