//! The last pass: the measure of every tile's own points.

use super::found::Found;
use super::kept::Kept;
use super::linked::Linked;
use super::part::Part;
use super::run::Run;
use crate::error::Error;
use crate::method;
use crate::prepare::{Prepared, scaled};
use crate::resolution::Resolution;
use crate::surface::reach::of_spacings;
use crate::surface::{evened, spacings};

impl Run<'_> {
    /// The measure of every tile's own points goes to `take`; what linking reads of them stays.
    ///
    /// # Errors
    /// Those of the points.
    pub(super) fn detect(
        &mut self,
        kept: &Kept,
        resolution: Resolution,
        take: &mut dyn FnMut(Found),
    ) -> Result<Vec<Linked>, Error> {
        let (all, params, frame) = (self.all(), self.params, self.frame);
        let count = kept.counts.iter().sum();
        let pass = |part: &Part| {
            let set = kept.of(all(part));
            let (graph, rows) = set.graph();
            let (spacing, known) = match scaled(params) {
                true => {
                    let known = rows.and(&of_spacings(&set.nearest, &set.lists));
                    (evened(&spacings(&set.positions, &set.nearest), resolution), known)
                }
                false => (Vec::new(), rows),
            };
            let points = (set.positions, set.source);
            let cloud = Prepared::of_part(frame, points, graph, (resolution, spacing), count);
            let measure = method::detect(&cloud, params);
            let steps = method::steps(&cloud, params);
            let known = known.steps(&cloud.graph, steps - 1);
            let certain = set.owned.iter().zip(&known.0).all(|(owned, known)| !owned || *known);
            let found = Found::new(&cloud, &measure, &set.owned);
            ((found, Linked::new(&cloud, &measure, &set.owned)), certain)
        };
        let tiles = 0..self.plan.tiles().len();
        let one = |t: usize| {
            let (found, linked) = self.one(t, &pass)?;
            take(found);
            Ok(linked)
        };
        tiles.map(one).collect()
    }
}
