//! The graph of lines: their ends are its nodes, those that lie together one.

use super::lines::Line;
use crate::math::trees::kd;
use crate::math::union_find::UnionFind;

/// Counts of a graph of lines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Topology {
    /// Lines.
    pub lines: usize,
    /// Connected parts.
    pub components: usize,
    /// Parts that are a single loop.
    pub closed_loops: usize,
    /// Nodes with three line ends or more.
    pub junctions: usize,
    /// Nodes with one.
    pub ends: usize,
    /// Independent cycles.
    pub cycles: usize,
}

/// Lines between nodes.
pub(super) struct Graph {
    /// A place for each node: that of the first line end there.
    pub places: Vec<[f64; 3]>,
    /// The number of line ends at each node.
    pub degrees: Vec<usize>,
    /// The nodes of each line; a closed line has one node twice.
    pub lines: Vec<[usize; 2]>,
}

impl Graph {
    /// Of lines whose ends are one node up to `tolerance`.
    pub fn new<'a>(lines: impl Iterator<Item = &'a Line>, tolerance: f64) -> Self {
        let mut ends: Vec<[f64; 3]> = Vec::new();
        for line in lines {
            let Some((&first, &last)) = line.points.first().zip(line.points.last()) else { continue };
            ends.extend([first, if line.closed { first } else { last }]);
        }
        // Ends at the very same place count once: thousands of lines may meet there.
        let (distinct, of) = distinct(&ends);
        let tree = kd::Tree::new(&distinct);
        let (mut sets, mut near) = (UnionFind::new(distinct.len()), Vec::new());
        for (i, &end) in distinct.iter().enumerate() {
            tree.within(end, tolerance, &mut near);
            for &j in &near {
                sets.union(i as u32, j);
            }
        }
        let mut graph = Self { places: Vec::new(), degrees: Vec::new(), lines: Vec::new() };
        let mut number = vec![usize::MAX; distinct.len()];
        let nodes: Vec<usize> = (0..ends.len())
            .map(|i| {
                let root = sets.find(of[i]) as usize;
                if number[root] == usize::MAX {
                    number[root] = graph.places.len();
                    graph.places.push(ends[i]);
                    graph.degrees.push(0);
                }
                graph.degrees[number[root]] += 1;
                number[root]
            })
            .collect();
        graph.lines = nodes.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect();
        graph
    }

    /// The places of the junctions.
    pub fn junctions(&self) -> Vec<[f64; 3]> {
        let many = self.degrees.iter().zip(&self.places).filter(|(degree, _)| **degree >= 3);
        many.map(|(_, &place)| place).collect()
    }

    /// Its counts.
    pub fn topology(&self) -> Topology {
        let nodes = self.degrees.len();
        let mut parts = UnionFind::new(nodes);
        let joined = self.lines.iter().filter(|[a, b]| parts.union(*a as u32, *b as u32)).count();
        let mut round = vec![true; nodes];
        for (node, &degree) in self.degrees.iter().enumerate() {
            round[parts.find(node as u32) as usize] &= degree == 2;
        }
        let roots = (0..nodes).filter(|&n| parts.find(n as u32) as usize == n).collect::<Vec<_>>();
        Topology {
            lines: self.lines.len(),
            components: roots.len(),
            closed_loops: roots.iter().filter(|&&n| round[n]).count(),
            junctions: self.degrees.iter().filter(|&&d| d >= 3).count(),
            ends: self.degrees.iter().filter(|&&d| d == 1).count(),
            cycles: self.lines.len() - joined,
        }
    }
}

/// Points that differ in a coordinate, and for each of the points given its number among them.
fn distinct(points: &[[f64; 3]]) -> (Vec<[f64; 3]>, Vec<u32>) {
    let by = |a: &[f64; 3], b: &[f64; 3]| (0..3).map(|k| a[k].total_cmp(&b[k])).find(|o| o.is_ne());
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| by(&points[a], &points[b]).unwrap_or(a.cmp(&b)));
    let (mut distinct, mut of) = (Vec::new(), vec![0; points.len()]);
    for i in order {
        if distinct.last() != Some(&points[i]) {
            distinct.push(points[i]);
        }
        of[i] = distinct.len() as u32 - 1;
    }
    (distinct, of)
}

#[cfg(test)]
mod tests {
    use super::distinct;

    #[test]
    fn ends_at_one_place_are_one_point() {
        let (a, b) = ([1.0, 2.0, 3.0], [1.0, 2.0, 4.0]);
        assert_eq!(distinct(&[b, a, b, a, a]), (vec![a, b], vec![1, 0, 1, 0, 0]));
        assert_eq!(distinct(&[]), (vec![], vec![]));
    }
}
