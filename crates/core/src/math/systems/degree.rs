//! An order of elimination that leaves a sparse factor: ever a vertex that has fewest neighbours then, by the approximate minimum degree over
//! the quotient graph (Amestoy, Davis and Duff 1996, An approximate minimum degree ordering algorithm). Vertices of equal degree go by index.

use std::collections::BTreeSet;

/// Vertices that meet more than this many times the root of their number come last: they meet all of the graph.
const DENSE: f64 = 10.0;
/// Degree up to which none is dense.
const NEVER_DENSE: f64 = 16.0;

/// The quotient graph: vertices that are left, and elements, which stand for those eliminated and join all their members.
struct Quotient<'a> {
    /// Unknowns of each vertex.
    weight: &'a [usize],
    /// Vertices beside each vertex by an edge of the graph.
    vertices: Vec<Vec<usize>>,
    /// Elements that each vertex is a member of.
    elements: Vec<Vec<usize>>,
    /// Members of each element, which has the index of the vertex eliminated.
    members: Vec<Vec<usize>>,
    degree: Vec<usize>,
    /// Weight of an element's members outside of the newest, and when that was counted.
    outside: Vec<(usize, usize)>,
    mark: Vec<usize>,
}

/// The vertices of a graph in their order of elimination. `near` has the neighbours of each, ascending, without itself, `weight` the number
/// of its unknowns.
pub fn order(near: &[Vec<usize>], weight: &[usize]) -> Vec<usize> {
    let n = near.len();
    let dense = (DENSE * (n as f64).sqrt()).max(NEVER_DENSE) as usize;
    let late: Vec<bool> = near.iter().map(|v| v.len() > dense).collect();
    let early = |v: &Vec<usize>| v.iter().copied().filter(|&b| !late[b]).collect();
    let vertices: Vec<Vec<usize>> = near.iter().map(early).collect();
    let degree: Vec<usize> = vertices.iter().map(|v| v.iter().map(|&b| weight[b]).sum()).collect();
    let mut graph = Quotient {
        weight,
        vertices,
        degree,
        elements: vec![Vec::new(); n],
        members: vec![Vec::new(); n],
        outside: vec![(0, usize::MAX); n],
        mark: vec![usize::MAX; n],
    };
    let mut queue: BTreeSet<(usize, usize)> =
        (0..n).filter(|&v| !late[v]).map(|v| (graph.degree[v], v)).collect();
    let mut sequence = Vec::with_capacity(n);
    while let Some((_, v)) = queue.pop_first() {
        sequence.push(v);
        for b in graph.eliminate(v, sequence.len()) {
            queue.remove(&(graph.degree[b], b));
            graph.degree[b] = graph.bound(b, v);
            queue.insert((graph.degree[b], b));
        }
    }
    sequence.extend((0..n).filter(|&v| late[v]));
    sequence
}

impl Quotient<'_> {
    /// Makes an element of a vertex; returns its members. `round` counts eliminations.
    fn eliminate(&mut self, v: usize, round: usize) -> Vec<usize> {
        let gone = std::mem::take(&mut self.elements[v]);
        let mut joined = std::mem::take(&mut self.vertices[v]);
        gone.iter().for_each(|&e| joined.append(&mut self.members[e]));
        self.mark[v] = round;
        let mark = &mut self.mark;
        joined.retain(|&b| std::mem::replace(&mut mark[b], round) != round);
        for &b in &joined {
            let mark = &self.mark;
            // Neighbours by the element need no edge.
            self.vertices[b].retain(|&c| mark[c] != round);
            self.elements[b].retain(|e| !gone.contains(e));
            for &e in &self.elements[b] {
                let (outside, counted) = &mut self.outside[e];
                if *counted != round {
                    *outside = self.members[e].iter().map(|&c| self.weight[c]).sum();
                    *counted = round;
                }
                *outside -= self.weight[b];
            }
        }
        for &b in &joined {
            // An element all of whose members are in this one says nothing more.
            let outside = &self.outside;
            self.elements[b].retain(|&e| outside[e].0 > 0);
            self.elements[b].push(v);
        }
        self.members[v].clone_from(&joined);
        joined
    }

    /// A bound on the degree of a member of the newest element.
    fn bound(&self, b: usize, newest: usize) -> usize {
        let beside: usize =
            self.members[newest].iter().map(|&c| self.weight[c]).sum::<usize>() - self.weight[b];
        let own: usize = self.vertices[b].iter().map(|&c| self.weight[c]).sum();
        let others = self.elements[b].iter().filter(|&&e| e != newest).map(|&e| self.outside[e].0);
        (self.degree[b] + beside).min(own + beside + others.sum::<usize>())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Entries of the factor below the diagonal, by elimination on the graph itself.
    fn fill(near: &[Vec<usize>], sequence: &[usize]) -> usize {
        let mut graph: Vec<BTreeSet<usize>> = near.iter().map(|v| v.iter().copied().collect()).collect();
        let mut sum = 0;
        for &v in sequence {
            let beside = std::mem::take(&mut graph[v]);
            sum += beside.len();
            for &b in &beside {
                graph[b].remove(&v);
                graph[b].extend(beside.iter().filter(|&&c| c != b));
            }
        }
        sum
    }

    #[test]
    fn a_grid_with_a_vertex_beside_all_fills_little_more_than_n_log_n() {
        let side = 30;
        let n = side * side;
        let mut near: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); n + 1];
        let mut edge = |a: usize, b: usize| {
            near[a].insert(b);
            near[b].insert(a);
        };
        for k in 0..n {
            edge(k, n);
            if k % side + 1 < side {
                edge(k, k + 1);
            }
            if k + side < n {
                edge(k, k + side);
            }
        }
        let near: Vec<Vec<usize>> = near.into_iter().map(|v| v.into_iter().collect()).collect();
        let sequence = order(&near, &vec![1; n + 1]);
        let all: BTreeSet<usize> = sequence.iter().copied().collect();
        assert_eq!((all.len(), sequence[n]), (n + 1, n));
        // By rows it is side * n; nested dissection takes 31 / 4 n log2 n for great n (George 1973).
        let found = fill(&near, &sequence);
        assert!(found < 13 * n, "{found}");
        assert!(fill(&near, &(0..=n).collect::<Vec<_>>()) > 25 * n);
    }
}
