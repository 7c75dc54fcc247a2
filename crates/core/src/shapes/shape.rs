//! A shape: trimmed faces, and the network between them.

use super::face::Face;
use super::truth::Truth;

/// The boundary of a solid, or a sheet, with the feature network that it has by construction.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Its name.
    pub name: &'static str,
    /// Smooth pieces that meet along the network's creases and end at its borders.
    pub faces: Vec<Face>,
    /// Creases, borders and the nodes between them.
    pub network: Truth,
}

impl Shape {
    /// Surface area: the sum of `Face::area`.
    pub fn area(&self) -> f64 {
        self.faces.iter().map(Face::area).sum()
    }

    /// Least and greatest corner of a box along the world axes that holds the untrimmed faces.
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        let points = self.faces.iter().flat_map(Face::extremes);
        points.fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], p| {
            [0, 1].map(|side| [0, 1, 2].map(|k| if side == 0 { low[k].min(p[k]) } else { high[k].max(p[k]) }))
        })
    }
}
