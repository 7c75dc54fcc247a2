//! The feature network, the result: crease strips and border loops that meet in nodes.

mod strip;
mod trace;

pub use strip::{Blend, Strip, StripKind};
pub(crate) use trace::{Trace, trace};

/// A feature network: strips that run from node to node, and closed strips without any.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Network {
    /// The points where strips meet or end.
    pub nodes: Vec<Node>,
    /// The lines, each ordered.
    pub strips: Vec<Strip>,
}

/// A point where strips meet or end.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Node {
    /// World frame in an `Extraction`, local frame before.
    pub position: [f64; 3],
    /// The kind, by the number of strips that meet here.
    pub kind: NodeKind,
    /// The number of strip ends here; a strip that starts and ends at one node counts twice.
    pub degree: u32,
    /// The point of the cloud for the node's vertex in the pattern, as an index into the input.
    pub source: u32,
    /// Standard deviation of the position on each axis, in the unit of the input, from the fits of the faces that meet here; `None` where
    /// it was not recovered from these.
    pub sigma: Option<[f64; 3]>,
}

/// The kind of a [`Node`], by the strips that meet in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum NodeKind {
    /// Three strips or more.
    Junction,
    /// Two strips that meet at an angle.
    Corner,
    /// One strip stops here (Gumhold: singleton end).
    End,
    /// No strip: a peak.
    Apex,
}

impl NodeKind {
    /// The kind of a node in which `degree` strip ends meet.
    pub(crate) fn of_degree(degree: u32) -> NodeKind {
        match degree {
            0 => NodeKind::Apex,
            1 => NodeKind::End,
            2 => NodeKind::Corner,
            _ => NodeKind::Junction,
        }
    }

    /// The name in files: `junction`, `corner`, `end` or `apex`.
    pub fn name(self) -> &'static str {
        match self {
            NodeKind::Junction => "junction",
            NodeKind::Corner => "corner",
            NodeKind::End => "end",
            NodeKind::Apex => "apex",
        }
    }
}

impl Network {
    /// Leaves only the strips that `keep` says, and the nodes that they have; the kind of a node follows from those left. `(S)`
    /// whether each strip stays.
    pub fn choose(&mut self, keep: impl Fn(&Strip) -> bool) -> Vec<bool> {
        let stay: Vec<bool> = self.strips.iter().map(keep).collect();
        self.keep(&stay);
        stay
    }

    /// As [`Network::choose`], by `(S)` whether each strip stays. Returns whether each node does.
    pub(crate) fn keep(&mut self, stay: &[bool]) -> Vec<bool> {
        let mut next = stay.iter();
        self.strips.retain(|_| next.next().is_some_and(|&s| s));
        let mut degree = vec![0u32; self.nodes.len()];
        let ends = |strip: &Strip| [strip.start, strip.end].into_iter().flatten();
        self.strips.iter().flat_map(ends).for_each(|n| degree[n as usize] += 1);
        let mut number = vec![0; self.nodes.len()];
        let stays = |(node, &degree): (&Node, &u32)| degree > 0 || node.degree == 0;
        let nodes = self.nodes.iter().zip(&degree).map(stays).collect();
        let mut kept = Vec::new();
        for (i, node) in
            self.nodes.drain(..).enumerate().filter(|(i, node)| degree[*i] > 0 || node.degree == 0)
        {
            number[i] = kept.len() as u32;
            let kind = if degree[i] == node.degree { node.kind } else { NodeKind::of_degree(degree[i]) };
            kept.push(Node { kind, degree: degree[i], ..node });
        }
        self.nodes = kept;
        for end in self.strips.iter_mut().flat_map(|s| [&mut s.start, &mut s.end]) {
            *end = end.map(|n| number[n as usize]);
        }
        nodes
    }

    /// The network of the lines on the surface, without rounded edges: these stand last, so that the numbers of the strips and nodes left are
    /// the same.
    pub fn on_surface(&self) -> Network {
        let mut network = self.clone();
        network.strips.retain(|s| s.kind != StripKind::Rounded);
        let used = network.strips.iter().flat_map(|s| [s.start, s.end]).flatten().map(|n| n as usize + 1);
        let apexes =
            network.nodes.iter().enumerate().filter(|(_, n)| n.kind == NodeKind::Apex).map(|(k, _)| k + 1);
        let count = used.chain(apexes).max().unwrap_or(0);
        network.nodes.truncate(count);
        network
    }

    /// The number of closed strips.
    pub fn loops(&self) -> usize {
        self.strips.iter().filter(|s| s.closed).count()
    }

    /// The number of nodes of one kind.
    pub fn count(&self, kind: NodeKind) -> usize {
        self.nodes.iter().filter(|n| n.kind == kind).count()
    }
}
