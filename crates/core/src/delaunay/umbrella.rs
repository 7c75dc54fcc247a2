//! The simplified umbrella filter: the triangles at each point "form at least one closed fan. [...] The Gabriel triangles incident
//! on a point are sorted according to a parameter [...]. For each data point, triangles are extracted from the sorted list, until
//! the first fan is completed at which point these triangles are validated as part of the output".
//!
//! The parameter is the radius of the circumsphere, at which a Gabriel triangle enters Adamy's alpha shapes. A triangle at a point
//! is an edge between two neighbours, a fan a cycle of such edges. The disjoint set that tells a cycle is, as the paper's, one whose
//! trees are not pruned: their links are the edges themselves, so that the way between two neighbours is the rest of the fan.

use super::facets::Facet;
use super::long::at_points;
use super::triangle::Triangle;
use crate::parallel;

/// The triangles of the first fan at each point, ascending.
pub(crate) fn umbrella(points: usize, gabriel: &[Facet]) -> Vec<Triangle> {
    let mut order: Vec<u32> = (0..gabriel.len() as u32).collect();
    order.sort_unstable_by(|&a, &b| {
        let (a, b) = (&gabriel[a as usize], &gabriel[b as usize]);
        a.radius.total_cmp(&b.radius).then(a.corners.cmp(&b.corners))
    });
    let sorted: Vec<Triangle> = order.iter().map(|&f| gabriel[f as usize].corners).collect();
    let at = at_points(points, &sorted);
    let mut all = parallel::flat_map(points, parallel::QUICK, |i, fan| {
        fan.extend(first_fan(i as u32, at.of(i).iter().map(|&t| sorted[t as usize])));
    });
    all.sort_unstable();
    all.dedup();
    all
}

/// The first closed fan among the triangles at a point in their order; none if no fan closes.
fn first_fan(point: u32, triangles: impl Iterator<Item = Triangle>) -> Vec<Triangle> {
    let mut trees = Trees::default();
    for triangle in triangles {
        let mut ends = triangle.iter().copied().filter(|&corner| corner != point);
        let (Some(a), Some(b)) = (ends.next(), ends.next()) else { continue };
        if let Some(mut way) = trees.join(a, b) {
            way.push(way[0]);
            return way.windows(2).map(|w| ordered(point, w[0], w[1])).collect();
        }
    }
    Vec::new()
}

fn ordered(a: u32, b: u32, c: u32) -> Triangle {
    let mut corners = [a, b, c];
    corners.sort_unstable();
    corners
}

/// Trees over a point's few neighbours: each with the one it is linked to.
#[derive(Default)]
struct Trees {
    links: Vec<(u32, Option<u32>)>,
}

impl Trees {
    /// Joins two neighbours by an edge; if they are joined already, the way from the first to the second.
    fn join(&mut self, a: u32, b: u32) -> Option<Vec<u32>> {
        let (up_a, up_b) = (self.way_up(a), self.way_up(b));
        if up_a.last() != up_b.last() {
            // The tree of `a` is turned so that `a` is its root.
            for pair in up_a.windows(2).rev() {
                self.set(pair[1], Some(pair[0]));
            }
            self.set(a, Some(b));
            return None;
        }
        let meeting = up_a.iter().position(|x| up_b.contains(x))?;
        let mut way = up_a[..=meeting].to_vec();
        let down = up_b.iter().take_while(|&&x| x != up_a[meeting]).copied();
        way.extend(down.collect::<Vec<u32>>().into_iter().rev());
        Some(way)
    }

    /// A neighbour and those above it, up to its root.
    fn way_up(&mut self, from: u32) -> Vec<u32> {
        if !self.links.iter().any(|l| l.0 == from) {
            self.links.push((from, None));
        }
        let mut way = vec![from];
        while let Some(next) = self.links.iter().find(|l| l.0 == way[way.len() - 1]).and_then(|l| l.1) {
            way.push(next);
        }
        way
    }

    fn set(&mut self, neighbor: u32, link: Option<u32>) {
        if let Some(found) = self.links.iter_mut().find(|l| l.0 == neighbor) {
            found.1 = link;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_fan_that_closes_is_found_and_nothing_else() {
        // Round point 9: a triangle that hangs on the fan, one that belongs to another, and the fan 0 1 2 3.
        let edges = [[0, 1], [2, 3], [3, 7], [5, 6], [1, 2], [3, 0], [5, 7]];
        let fan = first_fan(9, edges.iter().map(|&[a, b]| ordered(a, b, 9)));
        let mut fan: Vec<Triangle> = fan;
        fan.sort_unstable();
        assert_eq!(fan, [[0, 1, 9], [0, 3, 9], [1, 2, 9], [2, 3, 9]]);
        assert!(first_fan(9, edges[..5].iter().map(|&[a, b]| ordered(a, b, 9))).is_empty());
    }
}
