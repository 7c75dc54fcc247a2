//! Relations as they are reported, and how far their imposition has moved a network.

/// A curve of a strip.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Member {
    /// Index of the strip in the network.
    pub strip: u32,
    /// Index in the strip's `curves`.
    pub curve: u32,
}

/// Kinds of relations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum RelationKind {
    /// Lines, and axes of arcs and circles, in one direction.
    Parallel,
    /// Those of one direction stand at a right angle on those of another.
    Perpendicular,
    /// In one plane.
    Coplanar,
    /// Arcs and circles about one axis.
    Coaxial,
    /// Arcs and circles about one point, in one plane.
    Concentric,
    /// Arcs and circles of one radius.
    EqualRadius,
    /// Two that go over into each other without a corner.
    Tangent,
    /// The halves are mirror images of each other.
    Symmetric,
}

impl RelationKind {
    /// All kinds, in the order in which they are reported.
    pub const ALL: [RelationKind; 8] = [
        RelationKind::Parallel,
        RelationKind::Perpendicular,
        RelationKind::Coplanar,
        RelationKind::Coaxial,
        RelationKind::Concentric,
        RelationKind::EqualRadius,
        RelationKind::Tangent,
        RelationKind::Symmetric,
    ];

    /// The name in files.
    pub fn name(self) -> &'static str {
        match self {
            RelationKind::Parallel => "parallel",
            RelationKind::Perpendicular => "perpendicular",
            RelationKind::Coplanar => "coplanar",
            RelationKind::Coaxial => "coaxial",
            RelationKind::Concentric => "concentric",
            RelationKind::EqualRadius => "equal-radius",
            RelationKind::Tangent => "tangent",
            RelationKind::Symmetric => "symmetric",
        }
    }

    /// Whether its deviation is an angle; else it is a length.
    pub fn is_angle(self) -> bool {
        matches!(self, RelationKind::Parallel | RelationKind::Perpendicular)
    }
}

/// A relation between curves of a network.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Relation {
    /// Its kind.
    pub kind: RelationKind,
    /// The curves of the set, ascending; of a right angle those of the first direction, of a mirror those of one side.
    pub members: Vec<Member>,
    /// Of a right angle the curves of the second direction, of a mirror the image of each member; else empty.
    pub others: Vec<Member>,
    /// Probability of the relation against chance, from 0 to 1: that of its least likely member.
    pub likelihood: f64,
    /// Root mean square deviation of the fits from the relation, before it was imposed: radians of angles, else a length in the unit of the input.
    pub deviation: f64,
    /// Unit vector: the common direction, the normal of the plane, the axis, the normal of the mirror; none of equal radii and tangents.
    pub direction: Option<[f64; 3]>,
    /// A point of the plane, the axis or the mirror, the common centre; world frame in an `Extraction`.
    pub point: Option<[f64; 3]>,
    /// The common radius.
    pub radius: Option<f64>,
    /// Whether the curves were moved so that it holds exactly. Members, direction, point and radius are then those after the move.
    pub imposed: bool,
}

impl Relation {
    /// Moves the relation by an affine `map` that scales lengths by `unit` and turns nothing.
    pub(crate) fn place(&mut self, map: impl Fn([f64; 3]) -> [f64; 3], unit: f64) {
        self.point = self.point.map(map);
        self.radius = self.radius.map(|r| r * unit);
        if !self.kind.is_angle() {
            self.deviation *= unit;
        }
    }

    /// The relation among the strips that stay, by their new numbers; `None` where it relates nothing any more.
    pub(crate) fn of_strips(mut self, number: &[Option<u32>]) -> Option<Self> {
        let renumbered = |m: &Member| {
            let strip = number.get(m.strip as usize).copied().flatten()?;
            Some(Member { strip, ..*m })
        };
        if self.kind == RelationKind::Symmetric {
            let pairs = self.members.iter().zip(&self.others);
            let (a, b) = pairs.filter_map(|(a, b)| Some((renumbered(a)?, renumbered(b)?))).unzip();
            (self.members, self.others) = (a, b);
        } else {
            self.members = self.members.iter().filter_map(renumbered).collect();
            self.others = self.others.iter().filter_map(renumbered).collect();
        }
        let least =
            if matches!(self.kind, RelationKind::Perpendicular | RelationKind::Symmetric) { 1 } else { 2 };
        let facing = self.kind != RelationKind::Perpendicular || !self.others.is_empty();
        (self.members.len() >= least && facing).then_some(self)
    }
}

/// What the imposition of relations has moved.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Regularised {
    /// How far each node was moved, in the unit of the input.
    pub nodes: Vec<f64>,
    /// How far each curve of each strip was moved: the greatest distance of its ends, its middle and, of an arc or a circle, its centre.
    pub curves: Vec<Vec<f64>>,
    /// Curves that were left out of a relation, as it contradicted others or would have moved them by more than their points allow.
    pub released: Vec<Member>,
}

impl Regularised {
    /// In a unit of which one of today's has `unit`.
    pub(crate) fn scale(&mut self, unit: f64) {
        self.nodes.iter_mut().chain(self.curves.iter_mut().flatten()).for_each(|x| *x *= unit);
    }

    /// The greatest distance by which a node or a curve was moved.
    pub fn greatest(&self) -> f64 {
        self.nodes.iter().chain(self.curves.iter().flatten()).copied().fold(0.0, f64::max)
    }

    /// Of the strips that stay and the nodes that these have.
    pub(crate) fn of_strips(mut self, number: &[Option<u32>], kept: impl Fn(usize) -> bool) -> Self {
        let mut strips = number.iter();
        self.curves.retain(|_| strips.next().is_some_and(Option::is_some));
        let mut nodes = 0..;
        self.nodes.retain(|_| nodes.next().is_some_and(&kept));
        let new = |m: Member| Some(Member { strip: number.get(m.strip as usize).copied().flatten()?, ..m });
        self.released = self.released.into_iter().filter_map(new).collect();
        self
    }
}
