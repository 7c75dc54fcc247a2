//! The passes over the tiles: what all of them need to know comes first, then the points that are kept, at last the measure.

use super::crowds::{clutter, members};
use super::found::Found;
use super::guests::Guests;
use super::part::Part;
use super::plan::{Plan, Tile};
use super::set::Set;
use crate::error::Error;
use crate::frame::{Frame, LEVELS, Levels, finite};
use crate::method;
use crate::neighbors::riemannian::Scratch;
use crate::params::Params;
use crate::prepare::{Prepared, cleaned, given, scaled};
use crate::reach::Known;
use crate::resolution::{PlaneFit, Resolution, Sampled, steps, wide_fit};
use crate::surface::reach::{LocalKnown, Whole, of_spacings};
use crate::surface::{self, Local, evened, leave_out, spacings};

/// Margin with which each tile begins, spacings: what the first stages read on even surfaces.
const MARGIN: f64 = 24.0;
/// Factor by which the margin of a tile grows where something at one of its points is not known.
const WIDER: f64 = 1.5;
/// Most lonely points of a tile that have guests; for more the margin grows.
const MOST_LONELY: usize = 16;

/// A cloud that is read tile by tile.
pub(super) struct Run<'a> {
    pub(super) world: &'a [[f64; 3]],
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

/// What the stage `surface` leaves of the whole cloud.
pub(super) struct Kept {
    /// Resolution of all points.
    mean: Resolution,
    /// Members of crowds that are clutter, indices of the input, ascending.
    clutter: Vec<u32>,
    whole: Whole,
    /// Points left in each cell of the plan.
    counts: Vec<usize>,
    /// Whether any point was left out; and whether there is no surface at all.
    any: bool,
    pub(super) none: bool,
}

impl<'a> Run<'a> {
    /// Finds the frame of the whole cloud and the number of distinct points in each cell.
    pub(super) fn new(world: &'a [[f64; 3]], params: &'a Params, plan: &'a Plan) -> (Run<'a>, Vec<usize>) {
        let tiles = plan.tiles().len();
        let frame = Frame { offset: plan.corner(), scale: 1.0 };
        let (margins, guests, held) = (vec![MARGIN; tiles], vec![None; tiles], vec![0; tiles]);
        let mut run = Run { world, params, plan, frame, margins, guests, held };
        let (mut levels, mut counts) = (plan.levels(), vec![0; plan.codes.len()]);
        for tile in plan.tiles() {
            let own: Vec<[f64; 3]> =
                world.iter().copied().filter(|&p| tile.owns(plan.grid.relative(p))).collect();
            let (relative, parted) = Frame::sorted(&plan.grid, &own);
            (plan.level as usize..=LEVELS).for_each(|l| levels[l] += parted[l]);
            let first = |i: &usize| *i == 0 || relative[i - 1] != relative[*i];
            (0..relative.len()).filter(first).for_each(|i| counts[plan.cell(relative[i])] += 1);
        }
        run.frame = Frame::of_levels(&plan.grid, &levels);
        (run, counts)
    }

    /// Runs a pass over every tile, again with a wider margin until all that it gives is known.
    fn each<T>(&mut self, pass: impl Fn(&Part) -> (T, bool)) -> Vec<T> {
        let (plan, frame, world, k) = (self.plan, self.frame, self.world, self.params.neighbors.k);
        let mut one = |t: usize, tile: &Tile| loop {
            let guests = self.guests[t].clone().unwrap_or_default();
            let part = Part::gather(plan, tile, frame, (self.margins[t], &guests), world);
            self.held[t] = self.held[t].max(part.positions.len());
            let (result, known) = pass(&part);
            if known || part.whole {
                break result;
            }
            let lonely = if self.guests[t].is_none() { Set::all(&part, k).lonely() } else { Vec::new() };
            if (1..=MOST_LONELY).contains(&lonely.len()) {
                let all = world.iter().filter(|p| finite(p));
                let local = all.map(|&p| plan.grid.relative(p).map(|x| x / frame.scale));
                self.guests[t] = Some(Guests::of(&lonely, local));
            } else {
                self.margins[t] *= WIDER;
            }
        };
        plan.tiles().iter().enumerate().map(|(t, tile)| one(t, tile)).collect()
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
        });
        let resolution = Resolution::of_samples(&in_order(samples), |hops| {
            let fits: Vec<Vec<(usize, Option<PlaneFit>)>> = self.each(|part| {
                let set = of(part);
                let (graph, rows) = set.graph();
                let (chosen, rows) = (chosen(&set, wide), rows.steps(&graph, hops - 1));
                let known = chosen.iter().all(|&(i, _)| rows.0[i]);
                let mut scratch = Scratch::default();
                let fit = |(i, rank)| (rank, wide_fit(&set.positions, &graph, i, hops, &mut scratch));
                (chosen.into_iter().map(fit).collect(), known)
            });
            Ok(in_order(fits).into_iter().flatten().collect())
        });
        resolution.map(|r| given(r, self.params))
    }

    /// All points of a part.
    pub(super) fn all(&self) -> impl Fn(&Part) -> Set + 'a {
        let k = self.params.neighbors.k;
        move |part| Set::all(part, k)
    }

    /// Finds the points that are kept; `counts` is the number of distinct points in each cell.
    pub(super) fn kept(&mut self, mean: Resolution, counts: Vec<usize>) -> Kept {
        let count: usize = counts.iter().sum();
        let whole = Whole { widest: 0.0, far: Vec::new(), long: MARGIN };
        let mut kept = Kept { mean, clutter: Vec::new(), whole, counts, any: false, none: false };
        if !cleaned(self.params) || count < surface::FEWEST {
            return kept;
        }
        let (all, plan, frame) = (self.all(), self.plan, self.frame);
        let crowds = self.each(|part| {
            let set = all(part);
            let local = Local::new(&set.positions, &set.nearest, mean);
            let known = LocalKnown::new(&set.ground(), &set.nearest, &set.lists, &local);
            let (members, certain) = members(&set, &local, &known);
            let widest = set.own().map(|i| local.apart[i]).fold(0.0, f64::max);
            let reach = set.own().map(|i| (set.positions[i], f64::from(local.marks.reach[i])));
            let far: Vec<_> = reach.filter(|(_, reach)| *reach > MARGIN).collect();
            ((members, widest, far), certain && set.is_known(&known.apart))
        });
        kept.whole.widest = crowds.iter().map(|c| c.1).fold(0.0, f64::max);
        kept.whole.far = crowds.iter().flat_map(|c| &c.2).copied().collect();
        kept.clutter = clutter(crowds.into_iter().flat_map(|c| c.0).collect());
        let tallies = self.each(|part| {
            let set = all(part);
            let Judgement { stands, clutter, known } = kept.judge(&set);
            let stays = |&(i, _): &(usize, usize)| stands[i] == i as u32;
            let cells = |i: usize| (i, plan.cell(set.positions[i].map(|x| x * frame.scale)));
            let left: Vec<usize> = set.own().map(cells).filter(stays).map(|(_, cell)| cell).collect();
            ((left, set.own().filter(|&i| clutter[i]).count()), set.is_known(&known))
        });
        let stray: usize = tallies.iter().map(|t| t.1).sum();
        kept.none = count - stray < surface::PIECE;
        let mut counts = vec![0; kept.counts.len()];
        tallies.iter().flat_map(|t| &t.0).for_each(|&cell| counts[cell] += 1);
        kept.any = !kept.none && counts != kept.counts;
        if kept.any {
            kept.counts = counts;
        }
        kept
    }

    /// The resolution of the points that are kept, and their number.
    pub(super) fn after(&mut self, kept: &Kept) -> Result<(Resolution, usize), Error> {
        let all = self.all();
        let resolution = match kept.any {
            true => self.resolution(&kept.counts, |part| kept.of(all(part)))?,
            false => kept.mean,
        };
        Ok((resolution, kept.counts.iter().sum()))
    }

    /// The measure of every tile's own points, and what a linker reads of them.
    pub(super) fn detect(
        &mut self,
        kept: &Kept,
        resolution: Resolution,
        take: &mut dyn FnMut(&Found),
    ) -> Vec<Found> {
        let (all, params, frame) = (self.all(), self.params, self.frame);
        let count = kept.counts.iter().sum();
        let found = self.each(|part| {
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
            (Found::new(&cloud, &measure, &set.owned), certain)
        });
        found.iter().for_each(take);
        found
    }
}

/// What becomes of the points of a set.
struct Judgement {
    stands: Vec<u32>,
    clutter: Vec<bool>,
    known: Known,
}

impl Kept {
    fn judge(&self, set: &Set) -> Judgement {
        let (points, nearest) = (&set.positions[..], &set.nearest);
        let local = Local::new(points, nearest, self.mean);
        let known = LocalKnown::new(&set.ground(), nearest, &set.lists, &local);
        let crowd = |i: usize| local.marks.crowd[i] && self.clutter.binary_search(&set.source[i]).is_ok();
        let crowds: Vec<bool> = (0..points.len()).map(crowd).collect();
        let judged = local.judged(points, nearest, &crowds);
        let known = known.kept(&set.ground(), nearest, &local, &judged, &self.whole);
        let (mut stands, clutter) = (judged.stands, judged.clutter);
        leave_out(&mut stands, &clutter);
        Judgement { stands, clutter, known }
    }

    /// The points of a set that are kept.
    fn of(&self, set: Set) -> Set {
        if !self.any {
            return set;
        }
        let Judgement { stands, known, .. } = self.judge(&set);
        set.kept(&stands, &known)
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
