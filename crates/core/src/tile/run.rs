//! The passes over the tiles: what all of them need to know comes first, then the points that are kept (`kept`), at last the measure (`measured`).

use super::guests::Guests;
use super::part::Part;
use super::plan::{Plan, Tile};
use super::points::Points;
use super::set::Set;
use crate::error::Error;
use crate::frame::{Frame, LEVELS, Levels, finite};
use crate::neighbors::riemannian::Scratch;
use crate::params::Params;
use crate::prepare::given;
use crate::resolution::{PlaneFit, Resolution, Sampled, steps, wide_fit};

/// Margin with which each tile begins, spacings: what the first stages read on even surfaces.
pub(super) const MARGIN: f64 = 24.0;
/// Factor by which the margin of a tile grows where something at one of its points is not known.
const WIDER: f64 = 1.5;
/// Most lonely points of a tile that have guests; for more the margin grows.
const MOST_LONELY: usize = 16;

/// A cloud that is read tile by tile.
pub(super) struct Run<'a> {
    points: &'a dyn Points,
    pub(super) params: &'a Params,
    pub(super) plan: &'a Plan,
    pub(super) frame: Frame,
    /// Present margin of each tile, local frame.
    margins: Vec<f64>,
    /// Guests of each tile, once it has asked for them.
    guests: Vec<Option<Guests>>,
    /// Most points that each tile held at a time.
    pub(super) held: Vec<usize>,
}

impl<'a> Run<'a> {
    /// Finds the frame of the whole cloud and the number of distinct points in each cell.
    ///
    /// # Errors
    /// Those of the points.
    pub(super) fn new(
        points: &'a dyn Points,
        params: &'a Params,
        plan: &'a Plan,
    ) -> Result<(Run<'a>, Vec<usize>), Error> {
        let tiles = plan.tiles().len();
        let frame = Frame { offset: plan.corner(), scale: 1.0 };
        let (margins, guests, held) = (vec![MARGIN; tiles], vec![None; tiles], vec![0; tiles]);
        let mut run = Run { points, params, plan, frame, margins, guests, held };
        let (mut levels, mut counts) = (plan.levels(), vec![0; plan.codes.len()]);
        for tile in plan.tiles() {
            let mut own: Vec<[f64; 3]> = Vec::new();
            points.within(&[tile.core], &mut |_, p| {
                if finite(&p) && tile.owns(plan.grid.relative(p)) {
                    own.push(p);
                }
            })?;
            let (relative, parted) = Frame::sorted(&plan.grid, &own);
            (plan.level as usize..=LEVELS).for_each(|l| levels[l] += parted[l]);
            let first = |i: &usize| *i == 0 || relative[i - 1] != relative[*i];
            (0..relative.len()).filter(first).for_each(|i| counts[plan.cell(relative[i])] += 1);
        }
        run.frame = Frame::of_levels(&plan.grid, &levels);
        Ok((run, counts))
    }

    /// Runs a pass over every tile.
    pub(super) fn each<T>(&mut self, pass: impl Fn(&Part) -> (T, bool)) -> Result<Vec<T>, Error> {
        (0..self.plan.tiles().len()).map(|t| self.one(t, &pass)).collect()
    }

    /// Runs a pass over a tile, again with a wider margin until all that it gives is known.
    pub(super) fn one<T>(&mut self, t: usize, pass: &impl Fn(&Part) -> (T, bool)) -> Result<T, Error> {
        let (plan, frame) = (self.plan, self.frame);
        let tile: &Tile = &plan.tiles()[t];
        loop {
            let guests = self.guests[t].clone().unwrap_or_default();
            let part = Part::gather(plan, tile, frame, (self.margins[t], &guests), self.points)?;
            self.held[t] = self.held[t].max(part.positions.len());
            let (result, known) = pass(&part);
            if known || part.whole {
                return Ok(result);
            }
            let asked = self.guests[t].is_some();
            let lonely = if asked { Vec::new() } else { Set::all(&part, self.params.neighbors.k).lonely() };
            if (1..=MOST_LONELY).contains(&lonely.len()) {
                self.guests[t] = Some(Guests::of(&lonely, plan, frame, self.points)?);
            } else {
                self.margins[t] *= WIDER;
            }
        }
    }

    /// The resolution of all points of the sets that `of` gives for the tiles; `counts` is their number in each cell.
    pub(super) fn resolution(
        &mut self,
        counts: &[usize],
        of: impl Fn(&Part) -> Set,
    ) -> Result<Resolution, Error> {
        let (plan, frame) = (self.plan, self.frame);
        let firsts: Vec<usize> =
            counts.iter().scan(0, |next, n| Some(std::mem::replace(next, *next + n))).collect();
        let [step, wide] = steps(counts.iter().sum());
        let chosen = |set: &Set, step: usize| -> Vec<(usize, usize)> {
            set.ranks(plan, frame, &firsts).into_iter().filter(|(_, rank)| rank % step == 0).collect()
        };
        let samples = self.each(|part| {
            let set = of(part);
            let chosen = chosen(&set, step);
            let known = chosen.iter().all(|&(i, _)| set.lists.0[i]);
            let sampled = |(i, rank)| (rank, Sampled::of(&set.positions, &set.nearest, i));
            (chosen.into_iter().map(sampled).collect(), known)
        })?;
        let resolution = Resolution::of_samples(&in_order(samples), |hops| {
            let fits: Vec<Vec<(usize, Option<PlaneFit>)>> = self.each(|part| {
                let set = of(part);
                let (graph, rows) = set.graph();
                let (chosen, rows) = (chosen(&set, wide), rows.steps(&graph, hops - 1));
                let known = chosen.iter().all(|&(i, _)| rows.0[i]);
                let mut scratch = Scratch::default();
                let fit = |(i, rank)| (rank, wide_fit(&set.positions, &graph, i, hops, &mut scratch));
                (chosen.into_iter().map(fit).collect(), known)
            })?;
            Ok(in_order(fits).into_iter().flatten().collect())
        });
        resolution.map(|r| given(r, self.params))
    }

    /// All points of a part.
    pub(super) fn all(&self) -> impl Fn(&Part) -> Set + 'a {
        let k = self.params.neighbors.k;
        move |part| Set::all(part, k)
    }
}

/// What the tiles give, each with its place in the canonical order, in that order.
fn in_order<T>(parts: Vec<Vec<(usize, T)>>) -> Vec<T> {
    let mut all: Vec<(usize, T)> = parts.into_iter().flatten().collect();
    all.sort_by_key(|(rank, _)| *rank);
    all.into_iter().map(|(_, value)| value).collect()
}

impl Plan {
    /// The levels at which the first points of neighbouring cells part.
    fn levels(&self) -> Levels {
        let mut levels = [0; LEVELS + 1];
        for pair in self.codes.windows(2) {
            let shared = (pair[0] ^ pair[1]).leading_zeros() - (u64::BITS - 3 * self.level);
            levels[shared as usize / 3] += 1;
        }
        levels
    }
}
