//! Prepares a cloud for any method: local frame, neighbour graph, spacing and noise, points on surfaces.

use crate::error::Error;
use crate::frame::{Frame, Localised};
use crate::math::vec3::{cross, norm, sub};
use crate::mesh::Fold;
use crate::neighbors::{Neighbors, all_nearest, among, riemannian};
use crate::params::{Auto, Clutter, Method, Params, PenaltyForm, SegmentForm};
use crate::report::{Clock, Report, Stage};
use crate::resolution::Resolution;
use crate::surface::{self, CLUTTER, Findings, Scales, evened, spacings};

/// Fewest distinct points that can lie on a surface.
pub(crate) const SURFACE_POINTS: usize = 4;
/// Greatest distance of collinear points from their line, as a share of its length.
const COLLINEAR: f64 = 1e-9;

/// A cloud ready for a detector: distinct points in canonical order, local frame.
pub(crate) struct Prepared {
    /// World frame to local frame.
    pub(crate) frame: Frame,
    /// `(M, 3)` positions of the points on surfaces.
    pub(crate) positions: Vec<[f64; 3]>,
    /// `(M)` index of each point in the input.
    pub(crate) source: Vec<u32>,
    /// `(N)` canonical index of each input point; `u32::MAX` if it was dropped or is clutter.
    pub(crate) canonical: Vec<u32>,
    /// The Riemannian graph.
    pub(crate) graph: Neighbors,
    /// Spacing and noise; the noise of the parameters if they give one.
    pub(crate) resolution: Resolution,
    /// Points of the input that lie on no surface, ascending.
    pub(crate) clutter: Vec<u32>,
    /// Edges at which the faces of a mesh fold that the points were sampled on, local frame; none of a scan.
    pub(crate) folds: Vec<Fold>,
    /// `(M)` spacing at each point; empty if the mean holds everywhere.
    spacing: Vec<f32>,
    /// The number of points on surfaces in the whole cloud, of which `positions` may be a part.
    pub(crate) count: usize,
    findings: Findings,
    dropped: usize,
    beyond: usize,
    merged: usize,
}

/// Localises a cloud, refuses it if it has no surface, makes its neighbour graph and estimates its resolution.
///
/// # Errors
/// [`Error::TooFewPoints`], [`Error::Collinear`], [`Error::Extent`] or [`Error::TooManyPoints`].
pub(crate) fn prepare(world: &[[f64; 3]], params: &Params, clock: &mut Clock) -> Result<Prepared, Error> {
    let (mut canonical, local) =
        clock.run(Stage::Localise, || Frame::of_points(world).map(|local| (local.canonical(), local)))?;
    let merged = local.merged();
    refuse_degenerate(world.len(), &local.positions)?;
    let Localised { frame, mut positions, mut source, dropped, beyond, .. } = local.with_spacing()?;
    let mut joined = clock.run(Stage::Neighbors, || Joined::new(&positions, params));
    let (mut clutter, mut findings) = (Vec::new(), Findings::default());
    if cleaned(params) {
        clock.run(Stage::Surface, || {
            // The graph would be half of the memory of this stage, which needs the lists alone.
            joined.graph = Neighbors::default();
            let sorted = surface::sort(&positions, &joined.nearest, joined.resolution);
            findings = sorted.findings;
            if sorted.stands.is_empty() {
                joined.graph = riemannian::graph(&positions, &joined.nearest);
                return Ok(());
            }
            let all = std::mem::take(&mut joined.nearest);
            let number = numbers(&sorted.stands);
            clutter = take_out(&sorted.stands, &number, &mut positions, &mut source, &mut canonical);
            refuse_degenerate(world.len(), &positions)?;
            let nearest = among(all, params.neighbors.k, &number, &positions);
            joined = Joined::over(nearest, &positions, params);
            Ok(())
        })?;
    }
    let Joined { nearest, graph, resolution } = joined;
    let spacing =
        if scaled(params) { evened(&spacings(&positions, &nearest), resolution) } else { Vec::new() };
    let count = positions.len();
    let part = Prepared::of_part(frame, (positions, source), graph, (resolution, spacing), count);
    Ok(Prepared { canonical, clutter, findings, dropped, beyond, merged, ..part })
}

/// Whether the stage `surface` runs: in the robust forms by default, but not in the forms as printed, which take every point.
pub(crate) fn cleaned(params: &Params) -> bool {
    let printed = match params.method {
        Method::Auto | Method::Penalty => params.penalty.form == PenaltyForm::Paper,
        Method::Segments => params.segments.form == SegmentForm::Paper,
        Method::Projection => false,
    };
    match params.surface.clutter {
        Clutter::Auto => !printed,
        Clutter::LeaveOut => true,
        Clutter::Keep => false,
    }
}

/// Whether the method takes the spacing at each point for the unit of lengths there.
pub(crate) fn scaled(params: &Params) -> bool {
    matches!(params.method, Method::Auto | Method::Penalty) && params.penalty.form == PenaltyForm::Robust
}

/// The resolution that counts: its noise is that of the parameters if they give one.
pub(crate) fn given(resolution: Resolution, params: &Params) -> Resolution {
    match params.penalty.noise_spacings {
        // The ratio that was estimated keeps every bit of the noise.
        Auto::Given(ratio) if ratio != resolution.noise / resolution.spacing => {
            Resolution { noise: ratio * resolution.spacing, ..resolution }
        }
        _ => resolution,
    }
}

/// The neighbour graph of the points, and their resolution.
#[derive(Default)]
struct Joined {
    nearest: Neighbors,
    graph: Neighbors,
    resolution: Resolution,
}

impl Joined {
    fn new(positions: &[[f64; 3]], params: &Params) -> Joined {
        Joined::over(all_nearest(positions, params.neighbors.k), positions, params)
    }

    fn over(nearest: Neighbors, positions: &[[f64; 3]], params: &Params) -> Joined {
        let graph = riemannian::graph(positions, &nearest);
        let resolution = given(Resolution::estimate(positions, &nearest, &graph), params);
        Joined { nearest, graph, resolution }
    }
}

/// `(N)` new index of each point that represents itself; `u32::MAX` for the others.
pub(crate) fn numbers(stands: &[u32]) -> Vec<u32> {
    let mut next = 0;
    let number = |(&stand, i): (&u32, u32)| {
        let stays = stand == i;
        next += u32::from(stays);
        if stays { next - 1 } else { u32::MAX }
    };
    stands.iter().zip(0..).map(number).collect()
}

/// Takes the points that do not represent themselves out of the positions and sources, and leads their canonical indices to
/// their representatives; returns the input points that are clutter, ascending.
fn take_out(
    stands: &[u32],
    number: &[u32],
    positions: &mut Vec<[f64; 3]>,
    source: &mut Vec<u32>,
    canonical: &mut [u32],
) -> Vec<u32> {
    let mut clutter = Vec::new();
    for (i, place) in canonical.iter_mut().enumerate().filter(|(_, c)| **c != u32::MAX) {
        let stand = stands[*place as usize];
        *place = number.get(stand as usize).copied().unwrap_or(u32::MAX);
        if stand == CLUTTER {
            clutter.push(i as u32);
        }
    }
    let mut stays = number.iter().map(|&n| n != u32::MAX);
    positions.retain(|_| stays.next().unwrap_or(false));
    let mut stays = number.iter().map(|&n| n != u32::MAX);
    source.retain(|_| stays.next().unwrap_or(false));
    clutter
}

impl Prepared {
    /// A part of a cloud of `count` points on surfaces, as far as detectors and linkers for lines read it. `spacing` is that at each point;
    /// empty if the mean holds everywhere.
    pub(crate) fn of_part(
        frame: Frame,
        (positions, source): (Vec<[f64; 3]>, Vec<u32>),
        graph: Neighbors,
        (resolution, spacing): (Resolution, Vec<f32>),
        count: usize,
    ) -> Prepared {
        let (canonical, clutter, findings) = Default::default();
        let (dropped, beyond, merged) = (0, 0, 0);
        Prepared {
            frame,
            positions,
            source,
            canonical,
            graph,
            resolution,
            clutter,
            folds: Vec::new(),
            spacing,
            count,
            findings,
            dropped,
            beyond,
            merged,
        }
    }

    /// With the folds of the mesh that the points were sampled on, world frame.
    pub(crate) fn with_folds(mut self, folds: &[Fold]) -> Prepared {
        let unit = self.frame.length_to_world(1.0);
        let local =
            |f: &Fold| Fold { ends: f.ends.map(|p| self.frame.to_local(p)), height: f.height / unit, ..*f };
        self.folds = folds.iter().map(local).collect();
        self
    }

    /// Whether the stage `surface` left points out.
    pub(crate) fn is_part(&self) -> bool {
        self.positions.len() + self.merged + self.dropped < self.canonical.len()
    }

    /// Whether any of the points lie on a surface, as far as this was asked.
    pub(crate) fn has_surface(&self) -> bool {
        !self.findings.none
    }

    /// The spacing at a point; `None` if the mean holds everywhere.
    pub(crate) fn spacing_at(&self, i: usize) -> Option<f32> {
        self.spacing.get(i).copied()
    }

    /// Spacing and noise at every point.
    pub(crate) fn scales(&self) -> Scales<'_> {
        Scales::new(self.resolution, &self.spacing)
    }

    fn beyond_note(&self) -> Vec<String> {
        let words = "numbers that stand for no value: left out and counted as not finite, as f64 cannot hold the others beside them";
        (self.beyond > 0).then(|| format!("{} of the points hold {words}", self.beyond)).into_iter().collect()
    }

    /// Counts, estimates and notes on the cloud; stages and settings are still empty.
    pub(crate) fn report(&self) -> Report {
        let surface = self.findings.scaled(self.frame.length_to_world(1.0));
        Report {
            read: self.canonical.len(),
            dropped: self.dropped,
            merged: self.merged,
            points: self.positions.len(),
            surface,
            notes: [self.beyond_note(), surface.notes(self.canonical.len())].concat(),
            spacing: self.frame.length_to_world(self.resolution.spacing),
            noise: self.frame.length_to_world(self.resolution.noise),
            ..Report::default()
        }
    }
}

fn refuse_degenerate(read: usize, positions: &[[f64; 3]]) -> Result<(), Error> {
    if positions.len() < SURFACE_POINTS {
        return Err(Error::TooFewPoints { read, distinct: positions.len(), needed: SURFACE_POINTS });
    }
    // A single point far out makes all others look collinear, so the nearer half of the points decides then.
    let off_line =
        beside_line(positions, COLLINEAR) || beside_line(&nearer_half(positions), 10.0 * COLLINEAR);
    if off_line { Ok(()) } else { Err(Error::Collinear { distinct: positions.len() }) }
}

/// Whether points lie beside the line from the first to the one farthest from it, by more than `share` of its length.
fn beside_line(positions: &[[f64; 3]], share: f64) -> bool {
    let Some(&origin) = positions.first() else { return false };
    let farthest = positions
        .iter()
        .map(|&p| sub(p, origin))
        .fold([0.0; 3], |best, d| if norm(d) > norm(best) { d } else { best });
    let length = norm(farthest);
    positions.iter().any(|&p| norm(cross(farthest, sub(p, origin))) > share * length * length)
}

/// The half of the points nearer to the median of each axis.
fn nearer_half(positions: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let half = positions.len().div_ceil(2);
    let median = |axis: usize| {
        let mut along: Vec<f64> = positions.iter().map(|p| p[axis]).collect();
        *along.select_nth_unstable_by(half - 1, f64::total_cmp).1
    };
    let middle = [median(0), median(1), median(2)];
    let mut near = positions.to_vec();
    near.sort_by(|&a, &b| norm(sub(a, middle)).total_cmp(&norm(sub(b, middle))));
    near.truncate(half);
    near
}
