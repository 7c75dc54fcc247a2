//! First-order segmentation (Demarsin et al. 2007, section 2.2): clusters of points whose normals change little from
//! neighbour to neighbour.
//!
//! Region growing with one angle gives the connected components of the relation "adjacent, and the normals differ by no more
//! than the angle", from whatever point it starts. The components are computed directly, so that the order of points cannot
//! matter.
//!
//! Two forms. `as_printed`: normals of the one-rings; clusters below the mean size are small and lie along sharp edges.
//! `robust`: normals that keep to their side of a crease, so that faces stay whole under noise; remaining small clusters are
//! absorbed by the large ones beside them.

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
pub(crate) use segmented::angle;
