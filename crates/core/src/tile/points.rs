//! Where the points of a cloud in tiles come from.

use crate::error::Error;

/// A box by its least and greatest corner, from the least corner of the cloud ([`Plan::corner`](super::Plan::corner)), in the unit of the input.
pub type Corners = [[f64; 3]; 2];

/// The points of a cloud, in memory or anywhere else, as [`extract`](super::extract()) asks for them.
///
/// Anything that is a slice of positions is a source; where points do not fit into memory, a source reads those of some boxes.
pub trait Points {
    /// The number of points of the input, also of those that are not finite.
    fn count(&self) -> usize;

    /// Passes on points, world frame, with their indices in the input: every finite one that lies in any of some boxes, sides
    /// included, and others as it likes, but none twice. Of points at the same place that of the least index comes first.
    ///
    /// # Errors
    /// [`Error::Points`] where the source cannot be read.
    fn within(&self, boxes: &[Corners], take: &mut dyn FnMut(u32, [f64; 3])) -> Result<(), Error>;
}

impl<T: AsRef<[[f64; 3]]> + ?Sized> Points for T {
    fn count(&self) -> usize {
        self.as_ref().len()
    }

    /// All points, whatever the boxes.
    fn within(&self, _: &[Corners], take: &mut dyn FnMut(u32, [f64; 3])) -> Result<(), Error> {
        self.as_ref().iter().zip(0..).for_each(|(&p, i)| take(i, p));
        Ok(())
    }
}
