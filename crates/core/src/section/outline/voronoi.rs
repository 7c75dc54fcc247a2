//! Feature points by the largest empty circle of each region: Kyriazis et al., section 4.
//!
//! In a region whose points lie far from their chord, each Voronoi vertex on the other side of the chord is the centre of a
//! circle that touches the points from outside. The farthest of them within a bound gives the next feature points, the points
//! on its circle. This eliminates the internal-external point switching effect (figure 6), by which the curve changes from one
//! side of a thick band to the other. The bound is a multiple of the greatest distance of the region's points from the chord: a
//! large one gives small steps and many feature points, a small one large steps and few.
//!
//! Departures: if a circle cuts off less than a twentieth of a large region, the point farthest from the chord is taken as well,
//! which keeps the number of rounds logarithmic; the paper assumes it. Circles through the two ends of a region alone are
//! skipped; of more than three points on a circle three are taken. Regions, threshold and the polyline drawn are those of
//! `hull`.

use spade::{DelaunayTriangulation, HasPosition, Point2, Triangulation};

use super::regions::{FeatureMark, chord, farthest, positions, refine};
use crate::math::vec2::{along, cross, distance, onto, sub, unit};
use crate::section::contour::band::Band;

/// Regions below this size may be split as unevenly as the circles do.
const LARGE_REGION: usize = 256;

/// An empty circle that gave feature points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct EmptyCircle {
    /// The Voronoi vertex.
    pub centre: [f64; 2],
    /// Its distance from the points that it touches.
    pub radius: f64,
    /// The round that it belongs to.
    pub round: u32,
}

/// Feature points; `bound` is the multiple named above. `see` is shown every circle taken.
pub(crate) fn features(
    band: &Band,
    threshold: f64,
    bound: f64,
    mut see: impl FnMut(EmptyCircle),
) -> Vec<FeatureMark> {
    refine(band, threshold, |region, round| {
        let (picked, circle) = circle(band, region, bound);
        circle.into_iter().for_each(|(centre, radius)| see(EmptyCircle { centre, radius, round }));
        picked
    })
}

struct Site {
    position: Point2<f64>,
    mark: usize,
}

impl HasPosition for Site {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.position
    }
}

/// The centre and the radius of a circle.
type Round = ([f64; 2], f64);

/// The marks on the chosen circle of a region (the paper's `largest_circle` at its `farthest_vertex`), and that circle; no marks if
/// the region has no triangle.
fn circle(band: &Band, region: &[usize], bound: f64) -> (Vec<usize>, Option<Round>) {
    let (a, b) = chord(band, region);
    let axis = unit(sub(b, a));
    let sites = region.iter().map(|&mark| {
        let [x, y] = sub(band.marks[mark].raw, a);
        Site { position: Point2::new(settled(x), settled(y)), mark }
    });
    let Ok(diagram) = DelaunayTriangulation::<Site>::bulk_load_stable(sites.collect()) else {
        return (Vec::new(), None);
    };
    let offs = region.iter().map(|&m| cross(axis, sub(band.marks[m].raw, a)));
    // The points' own side of the chord; circles are sought on the other.
    let own = if offs.sum::<f64>() >= 0.0 { 1.0 } else { -1.0 };
    let deepest = region[farthest(band, region)];
    let limit = bound * onto(a, b, band.marks[deepest].raw).1;
    let mut best: Option<(f64, [usize; 3], [f64; 2])> = None;
    for face in diagram.inner_faces() {
        let centre = face.circumcenter();
        let off = -own * cross(axis, [centre.x, centre.y]);
        let touched = face.vertices().map(|v| v.data().mark);
        let better = best.is_none_or(|(most, marks, _)| off > most || (off == most && touched < marks));
        if off > 0.0 && off <= limit && better && splits(touched, region) {
            best = Some((off, touched, [centre.x, centre.y]));
        }
    }
    let mut picked = best.map_or(Vec::new(), |(_, marks, _)| marks.to_vec());
    if best.is_none() || lopsided(&picked, region) {
        picked.push(deepest);
    }
    let chosen = best.map(|(_, marks, centre)| {
        let centre = along(a, centre, 1.0);
        (centre, distance(centre, band.marks[marks[0]].raw))
    });
    (picked, chosen)
}

/// Whether a circle touches more than the two ends of a region.
fn splits(touched: [usize; 3], region: &[usize]) -> bool {
    touched.iter().any(|&m| m != region[0] && m != region[region.len() - 1])
}

fn lopsided(picked: &[usize], region: &[usize]) -> bool {
    let n = region.len();
    n > LARGE_REGION && !positions(region, picked).iter().any(|k| (n / 20..=n - n / 20).contains(k))
}

/// Coordinates so small that the triangulation refuses them count as zero.
fn settled(x: f64) -> f64 {
    if x.abs() < 1e-100 { 0.0 } else { x }
}
