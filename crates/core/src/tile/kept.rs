//! The points that are kept: what is clutter and what is thinned, and the resolution of the others.

use super::crowds::{clutter, members};
use super::run::{MARGIN, Run};
use super::set::Set;
use crate::error::Error;
use crate::prepare::cleaned;
use crate::reach::Known;
use crate::resolution::Resolution;
use crate::surface::reach::{LocalKnown, Whole};
use crate::surface::{self, Local, leave_out};

/// What the stage `surface` leaves of the whole cloud.
pub(super) struct Kept {
    /// Resolution of all points.
    mean: Resolution,
    /// Members of crowds that are clutter, indices of the input, ascending.
    clutter: Vec<u32>,
    whole: Whole,
    /// Points left in each cell of the plan.
    pub(super) counts: Vec<usize>,
    /// Whether any point was left out; and whether there is no surface at all.
    any: bool,
    pub(super) none: bool,
}

impl Run<'_> {
    /// Finds the points that are kept; `counts` is the number of distinct points in each cell.
    pub(super) fn kept(&mut self, mean: Resolution, counts: Vec<usize>) -> Result<Kept, Error> {
        let count: usize = counts.iter().sum();
        let whole = Whole { widest: 0.0, far: Vec::new(), long: MARGIN };
        let mut kept = Kept { mean, clutter: Vec::new(), whole, counts, any: false, none: false };
        if !cleaned(self.params) || count < surface::FEWEST {
            return Ok(kept);
        }
        self.judge_crowds(&mut kept)?;
        let (all, plan, frame) = (self.all(), self.plan, self.frame);
        let tallies = self.each(|part| {
            let set = all(part);
            let Judgement { stands, clutter, known } = kept.judge(&set);
            let stays = set.own().filter(|&i| stands[i] == i as u32);
            let left = runs(stays.map(|i| plan.cell(set.positions[i].map(|x| x * frame.scale))));
            ((left, set.own().filter(|&i| clutter[i]).count()), set.is_known(&known))
        })?;
        let stray: usize = tallies.iter().map(|t| t.1).sum();
        kept.none = count - stray < surface::PIECE;
        let mut counts = vec![0; kept.counts.len()];
        tallies.iter().flat_map(|t| &t.0).for_each(|(cell, left)| counts[*cell] += left);
        kept.any = !kept.none && counts != kept.counts;
        if kept.any {
            kept.counts = counts;
        }
        Ok(kept)
    }

    /// Finds the crowds that are clutter.
    fn judge_crowds(&mut self, kept: &mut Kept) -> Result<(), Error> {
        let (all, mean) = (self.all(), kept.mean);
        let crowds = self.each(|part| {
            let set = all(part);
            let local = Local::new(&set.positions, &set.nearest, mean);
            let known = LocalKnown::new(&set.ground(), &set.nearest, &set.lists, &local);
            let (members, certain) = members(&set, &local, &known);
            let widest = set.own().map(|i| local.apart[i]).fold(0.0, f64::max);
            let reach = set.own().map(|i| (set.positions[i], f64::from(local.marks.reach[i])));
            let far: Vec<_> = reach.filter(|(_, reach)| *reach > MARGIN).collect();
            ((members, widest, far), certain && set.is_known(&known.apart))
        })?;
        kept.whole.widest = crowds.iter().map(|c| c.1).fold(0.0, f64::max);
        kept.whole.far = crowds.iter().flat_map(|c| &c.2).copied().collect();
        kept.clutter = clutter(crowds.into_iter().flat_map(|c| c.0).collect());
        Ok(())
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
    pub(super) fn of(&self, set: Set) -> Set {
        if !self.any {
            return set;
        }
        let Judgement { stands, known, .. } = self.judge(&set);
        set.kept(&stands, &known)
    }
}

/// Runs of equal cells, each with its length.
fn runs(cells: impl Iterator<Item = usize>) -> Vec<(usize, usize)> {
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for cell in cells {
        match runs.last_mut() {
            Some(run) if run.0 == cell => run.1 += 1,
            _ => runs.push((cell, 1)),
        }
    }
    runs
}
