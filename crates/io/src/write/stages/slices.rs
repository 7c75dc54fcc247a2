//! The stages of sections: slabs, points on the planes, feature points round by round, empty circles, outlines (Kyriazis et al. 2007,
//! figures 2 to 7).

use super::table::Table;
use crate::error::Error;
use crate::write::encode::json::{Text, list};
use crate::write::encode::ply;
use lineament::math::vec3::{add_scaled, dot};
use lineament::section::{Circle, FeaturePoint, SectionParams, Sections, SliceSteps};
use lineament::{Cloud, params::ParamValue};
use std::f64::consts::TAU;
use std::io::{self, Write};

/// Corners of a circle.
const CORNERS: usize = 64;

/// Writes the files into the table's folder.
pub(super) fn write(
    mut table: Table,
    cloud: &Cloud,
    sections: &Sections,
    steps: &[SliceSteps],
    params: &SectionParams,
) -> Result<(), Error> {
    let count = steps.iter().map(|s| s.slab.len()).sum();
    table.add("slab", &[("vertices", count)], |out| slab(out, count, cloud, sections, steps))?;
    let count = steps.iter().map(|s| s.projected.len()).sum();
    let contours = steps.iter().map(|s| s.closed.len()).sum();
    let held = [("vertices", count), ("contours", contours)];
    table.add("projection", &held, |out| projection(out, count, steps))?;
    let outline = params.outline.show();
    let rounds = steps.iter().flat_map(|s| &s.features).map(|f| f.round + 1).max().unwrap_or(0);
    for round in 0..rounds {
        let lines = Lines::of_round(steps, round);
        let name = format!("{outline}_{round:02}");
        table.add(&name, &lines.held(), |out| lines.write(out, ["slice", "contour", "round"]))?;
    }
    let circles: Vec<(&SliceSteps, &Circle)> =
        steps.iter().flat_map(|s| s.circles.iter().map(move |c| (s, c))).collect();
    if !circles.is_empty() {
        let [vertices, edges] = [CORNERS + 1, CORNERS].map(|n| n * circles.len());
        let held = [("vertices", vertices), ("edges", edges), ("circles", circles.len())];
        table.add("circles", &held, |out| rings(out, &circles, sections.frame.axes))?;
    }
    let lines = Lines::of_contours(sections);
    table.add("outlines", &lines.held(), |out| lines.write(out, ["slice", "contour", "corner"]))?;
    let axis = sections.frame.axes[2];
    table.finish(|out| {
        write!(out, "\"method\": \"section\",\n\"outline\": {},\n\"axis\": [", Text(&outline))?;
        list(out, &axis, |out, _, x| write!(out, "{x}"))?;
        writeln!(out, "],\n\"slices\": {},", steps.len())
    })
}

/// The points of the slabs, each with its slice, its row of the input and its height over the plane.
fn slab(
    out: &mut dyn Write,
    count: usize,
    cloud: &Cloud,
    sections: &Sections,
    steps: &[SliceSteps],
) -> io::Result<()> {
    let columns = [("int", "slice"), ("int", "point"), ("float", "height")];
    ply::header(out, &[], &[ply::vertices(count, &columns)])?;
    for step in steps {
        for &i in &step.slab {
            let p = cloud.positions[i as usize];
            let height = dot(p, sections.frame.axes[2]) - sections.heights[step.plane];
            let numbers = [ply::index(step.plane)?, ply::index(i as usize)?].map(i32::to_le_bytes).concat();
            ply::vertex(out, p, &[&numbers[..], &(height as f32).to_le_bytes()].concat())?;
        }
    }
    Ok(())
}

/// The points on the planes, each with its slice and its contour, -1 for none.
fn projection(out: &mut dyn Write, count: usize, steps: &[SliceSteps]) -> io::Result<()> {
    ply::header(out, &[], &[ply::vertices(count, &[("int", "slice"), ("int", "contour")])])?;
    for step in steps {
        for p in &step.projected {
            let contour = p.contour.map_or(Ok(-1), |c| ply::index(c as usize))?;
            ply::vertex(out, p.at, &[ply::index(step.plane)?, contour].map(i32::to_le_bytes).concat())?;
        }
    }
    Ok(())
}

/// The centres, then the circles as polygons; all vertices with slice, contour, round and radius.
fn rings(
    out: &mut dyn Write,
    circles: &[(&SliceSteps, &Circle)],
    [u, v, _]: [[f64; 3]; 3],
) -> io::Result<()> {
    let columns = [("int", "slice"), ("int", "contour"), ("int", "round"), ("double", "radius")];
    let [vertices, edges] = [CORNERS + 1, CORNERS].map(|n| n * circles.len());
    let comment = format!("the first {} vertices are the centres", circles.len());
    ply::header(out, &[&comment], &[ply::vertices(vertices, &columns), ply::edges(edges, &[])])?;
    let more = |(step, c): &(&SliceSteps, &Circle)| -> io::Result<Vec<u8>> {
        let numbers = [step.plane, c.contour as usize, c.round as usize];
        let numbers = numbers.into_iter().map(|n| ply::index(n).map(i32::to_le_bytes));
        let numbers: Vec<[u8; 4]> = numbers.collect::<io::Result<_>>()?;
        Ok([&numbers.concat()[..], &c.radius.to_le_bytes()].concat())
    };
    for circle in circles {
        ply::vertex(out, circle.1.centre, &more(circle)?)?;
    }
    for circle in circles {
        let (Circle { centre, radius, .. }, more) = (circle.1, more(circle)?);
        for k in 0..CORNERS {
            let (sin, cos) = (TAU * k as f64 / CORNERS as f64).sin_cos();
            ply::vertex(out, add_scaled(add_scaled(*centre, u, radius * cos), v, radius * sin), &more)?;
        }
    }
    for first in (0..circles.len()).map(|c| circles.len() + CORNERS * c) {
        for k in 0..CORNERS {
            ply::edge(out, [first + k, first + (k + 1) % CORNERS], &[])?;
        }
    }
    Ok(())
}

/// Polylines with three numbers at each vertex.
#[derive(Default)]
struct Lines {
    vertices: Vec<([f64; 3], [usize; 3])>,
    edges: Vec<[usize; 2]>,
    count: usize,
}

impl Lines {
    /// The feature points found up to a round, joined in order: slice, contour and the round that found each.
    fn of_round(steps: &[SliceSteps], round: u32) -> Lines {
        let mut lines = Lines::default();
        for step in steps {
            for contour in step.features.chunk_by(|a, b| a.contour == b.contour) {
                let found = contour.iter().filter(|f| f.round <= round);
                let number = |f: &FeaturePoint| (f.at, [step.plane, f.contour as usize, f.round as usize]);
                lines.push(found.map(number).collect(), step.closed[contour[0].contour as usize]);
            }
        }
        lines
    }

    /// The outlines that came of it: slice, contour, and 1 at a corner.
    fn of_contours(sections: &Sections) -> Lines {
        let mut lines = Lines::default();
        for section in &sections.sections {
            for (c, contour) in section.contours.iter().enumerate() {
                let corner = |k: &usize| usize::from(contour.corners.binary_search(k).is_ok());
                let points = contour.points.iter().enumerate();
                let points = points.map(|(k, &at)| (at, [section.plane, c, corner(&k)])).collect();
                lines.push(points, contour.closed);
            }
        }
        lines
    }

    fn push(&mut self, points: Vec<([f64; 3], [usize; 3])>, closed: bool) {
        let (first, n) = (self.vertices.len(), points.len());
        self.edges.extend((1..n).map(|k| [first + k - 1, first + k]));
        self.edges.extend((closed && n > 2).then(|| [first + n - 1, first]));
        self.vertices.extend(points);
        self.count += 1;
    }

    fn held(&self) -> [(&'static str, usize); 3] {
        [("vertices", self.vertices.len()), ("edges", self.edges.len()), ("contours", self.count)]
    }

    fn write(&self, out: &mut dyn Write, names: [&str; 3]) -> io::Result<()> {
        let columns = names.map(|name| ("int", name));
        let elements = [ply::vertices(self.vertices.len(), &columns), ply::edges(self.edges.len(), &[])];
        ply::header(out, &[], &elements)?;
        for (at, numbers) in &self.vertices {
            let [a, b, c] = *numbers;
            let more = [ply::index(a)?, ply::index(b)?, ply::index(c)?].map(i32::to_le_bytes).concat();
            ply::vertex(out, *at, &more)?;
        }
        self.edges.iter().try_for_each(|&ends| ply::edge(out, ends, &[]))
    }
}
