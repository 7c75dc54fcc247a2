//! Patches as STEP: advanced faces with shared edges and vertices, sewn to solids where they close, else to open shells.

use crate::write::encode::step::{Id, List, Real, Step, Text};
use crate::write::network::NetworkContext;
use crate::write::network::step::{head, rounding};
use lineament::Network;
use lineament::curve::pieces::Shape;
use lineament::math::vec3::{add_scaled, dot, sub};
use lineament::patch::{Brep, Edge, Face, Shell, Surface, brep};
use std::io::{self, Write};

pub(super) fn write(out: &mut dyn Write, network: &Network, context: &NetworkContext) -> io::Result<()> {
    let found = context.patches.as_ref().map(|p| brep(network, p)).unwrap_or_default();
    let head = head(context, found.gap.max(rounding(network)));
    let mut step = Step::begin(out, &head)?;
    let vertices: Vec<Id> =
        found.vertices.iter().map(|&v| vertex(&mut step, v)).collect::<io::Result<_>>()?;
    let edges: Vec<Id> =
        found.edges.iter().map(|e| edge(&mut step, &found, e, &vertices)).collect::<io::Result<_>>()?;
    let faces: Vec<Id> =
        found.faces.iter().map(|f| face(&mut step, &found, f, &edges)).collect::<io::Result<_>>()?;
    let (closed, open): (Vec<&Shell>, Vec<&Shell>) = found.shells.iter().partition(|s| s.closed);
    let of = |shell: &&Shell| shell.faces.iter().map(|&f| faces[f as usize]).collect::<Vec<Id>>();
    let mut shapes = Vec::new();
    if !closed.is_empty() {
        let solid = |(n, shell)| {
            let shell = step.add(format_args!("CLOSED_SHELL('',{})", List(&of(shell))))?;
            step.add(format_args!("MANIFOLD_SOLID_BREP('solid_{n}',#{shell})"))
        };
        let solids: Vec<Id> = closed.iter().enumerate().map(solid).collect::<io::Result<_>>()?;
        shapes.push(representation(&mut step, "ADVANCED_BREP", &solids, context)?);
    }
    if !open.is_empty() {
        let shell = |shell| step.add(format_args!("OPEN_SHELL('',{})", List(&of(shell))));
        let shells: Vec<Id> = open.iter().map(shell).collect::<io::Result<_>>()?;
        let model = step.add(format_args!("SHELL_BASED_SURFACE_MODEL('',{})", List(&shells)))?;
        shapes.push(representation(&mut step, "MANIFOLD_SURFACE", &[model], context)?);
    }
    step.end(&shapes)
}

fn representation(step: &mut Step, kind: &str, items: &[Id], context: &NetworkContext) -> io::Result<Id> {
    let place = step.placement([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0])?;
    let items: Vec<Id> = [place].iter().chain(items).copied().collect();
    let (name, inside) = (Text(&context.input_name), step.context);
    step.add(format_args!("{kind}_SHAPE_REPRESENTATION({name},{},#{inside})", List(&items)))
}

fn vertex(step: &mut Step, at: [f64; 3]) -> io::Result<Id> {
    let point = step.point(at)?;
    step.add(format_args!("VERTEX_POINT('',#{point})"))
}

fn edge(step: &mut Step, found: &Brep, edge: &Edge, vertices: &[Id]) -> io::Result<Id> {
    let [from, to] = edge.ends.map(|v| found.vertices[v as usize]);
    let curve = match &edge.shape {
        Shape::Line => step.line(from, to)?,
        Shape::Arc { round, .. } | Shape::Circle(round) => step.circle("", round, from)?,
        Shape::Ellipse { ellipse, .. } => step.ellipse("", ellipse)?,
        Shape::Spline(spline) => step.spline("", spline)?,
    };
    let [a, b] = edge.ends.map(|v| vertices[v as usize]);
    step.add(format_args!("EDGE_CURVE('strip_{}',#{a},#{b},#{curve},.T.)", edge.strip))
}

fn face(step: &mut Step, found: &Brep, face: &Face, edges: &[Id]) -> io::Result<Id> {
    let surface = surface(step, found, face)?;
    let mut bounds = Vec::new();
    for row in &face.loops {
        let mut oriented = Vec::new();
        for &(edge, forward) in row {
            let (edge, sense) = (edges[edge as usize], if forward { "T" } else { "F" });
            oriented.push(step.add(format_args!("ORIENTED_EDGE('',*,*,#{edge},.{sense}.)"))?);
        }
        let ring = step.add(format_args!("EDGE_LOOP('',{})", List(&oriented)))?;
        // Where a surface goes round, none of its loops is the outer one.
        let outer =
            bounds.is_empty() && (face.loops.len() == 1 || matches!(face.surface, Surface::Plane { .. }));
        let kind = if outer { "FACE_OUTER_BOUND" } else { "FACE_BOUND" };
        bounds.push(step.add(format_args!("{kind}('',#{ring},.T.)"))?);
    }
    if let (Some(point), true) = (pole(face), bounds.is_empty()) {
        let vertex = vertex(step, point)?;
        let ring = step.add(format_args!("VERTEX_LOOP('',#{vertex})"))?;
        bounds.push(step.add(format_args!("FACE_BOUND('',#{ring},.T.)"))?);
    }
    let sense = if face.outward { "T" } else { "F" };
    let name = format!("patch_{}", face.patch);
    step.add(format_args!("ADVANCED_FACE('{name}',{},#{surface},.{sense}.)", List(&bounds)))
}

/// A point of a surface that closes on itself.
fn pole(face: &Face) -> Option<[f64; 3]> {
    match face.surface {
        Surface::Sphere { center, radius } => Some(add_scaled(center, face.axis, radius)),
        Surface::Torus { center, major, minor, .. } => Some(add_scaled(center, face.first, major + minor)),
        _ => None,
    }
}

fn surface(step: &mut Step, found: &Brep, face: &Face) -> io::Result<Id> {
    let (kind, at, sizes) = match face.surface {
        Surface::Plane { point, .. } => ("PLANE", point, vec![]),
        Surface::Sphere { center, radius } => ("SPHERICAL_SURFACE", center, vec![radius]),
        Surface::Cylinder { point, radius, .. } => ("CYLINDRICAL_SURFACE", point, vec![radius]),
        Surface::Cone { apex, axis, half_angle } => {
            // Placed among the edges, not at the apex, where the radius would be none.
            let edges = face.loops.iter().flatten().map(|e| found.edges[e.0 as usize].ends[0]);
            let heights = edges.map(|v| dot(sub(found.vertices[v as usize], apex), axis));
            let height = heights.fold(0.0, f64::max);
            let sizes = vec![height * half_angle.tan(), half_angle];
            ("CONICAL_SURFACE", add_scaled(apex, axis, height), sizes)
        }
        Surface::Torus { center, major, minor, .. } => ("TOROIDAL_SURFACE", center, vec![major, minor]),
    };
    let place = step.placement(at, face.axis, face.first)?;
    let sizes: String = sizes.into_iter().map(|size| format!(",{}", Real(size))).collect();
    step.add(format_args!("{kind}('',#{place}{sizes})"))
}
