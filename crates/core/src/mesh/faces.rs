//! The faces of a mesh.

/// Faces of a mesh, each with three vertices or more.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Faces {
    corners: Vec<u32>,
    ends: Vec<usize>,
}

impl Faces {
    /// Adds a face by the indices of its vertices, counted from 0; one with fewer than three has no area and is left out.
    pub fn push(&mut self, face: &[u32]) {
        if face.len() >= 3 {
            self.corners.extend_from_slice(face);
            self.ends.push(self.corners.len());
        }
    }

    /// The number of faces.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The faces in their order.
    pub fn iter(&self) -> impl Iterator<Item = &[u32]> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| &self.corners[start..end])
    }

    /// The greatest index of a vertex.
    pub fn greatest(&self) -> Option<u32> {
        self.corners.iter().copied().max()
    }
}
