//! First-order segmentation (Demarsin et al. 2007, section 2.2): clusters of points whose normals change little from
//! neighbour to neighbour.
//!
//! Region growing with one angle, whatever point it begins from, gives the connected components of the relation "adjacent,
//! and the normals differ by no more than the angle". They are taken directly, so no order of points can matter.
//!
//! Two forms. `as_printed`: normals of the one-rings; clusters below the mean size are small, and are what sharp edges are made
//! of. `robust`: normals that keep to their side of a crease, so that faces stay whole under noise; what is then left in
//! small clusters is given to the large one beside it, and the places where large clusters meet are known for every point.

mod absorb;
mod as_printed;
mod robust;
mod segmentation;
mod segmented;
mod smoothing;

pub(crate) use as_printed::as_printed;
pub(crate) use robust::robust;
pub use segmentation::Segmentation;
pub use segmented::Segmented;
