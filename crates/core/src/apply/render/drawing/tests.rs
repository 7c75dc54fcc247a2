//! Line drawings of shapes whose edges and outlines are known.

use super::Shape;
use crate::apply::render::{Drawing, Hidden, Scene, Settings, Style, Triangles, View, draw, surfels};
use crate::network::{Network, Strip, StripKind};
use crate::shapes::{Sampling, Scan, cuboid, sphere, torus};

const EDGES: [f64; 3] = [4.0, 3.0, 2.0];

fn corner(i: usize) -> [f64; 3] {
    [0, 1, 2].map(|axis| EDGES[axis] * (f64::from((i >> axis) as u32 & 1) - 0.5))
}

/// The twelve edges of the cuboid.
fn edges() -> Network {
    let pairs = (0..8usize).flat_map(|a| (0..3).map(move |axis| (a, a | 1 << axis))).filter(|(a, b)| a != b);
    let strip = |(a, b): (usize, usize)| Strip {
        kind: StripKind::Crease,
        closed: false,
        start: None,
        end: None,
        points: [0.0, 0.5, 1.0]
            .map(|t| [0, 1, 2].map(|c| corner(a)[c] + t * (corner(b)[c] - corner(a)[c])))
            .into(),
        curve: Default::default(),
        sources: Vec::new(),
        fold_deg: None,
        evidence: None,
        curves: Vec::new(),
        deviation: 0.0,
        confidence: 1.0,
        sigma: Vec::new(),
        blend: None,
    };
    Network { nodes: Vec::new(), strips: pairs.map(strip).collect() }
}

fn settings(hidden: Hidden) -> Settings {
    Settings {
        views: vec![View::From([1.0, -1.7, 0.8])],
        style: Style::Lines,
        hidden,
        width: 480,
        height: 400,
        caption: false,
        ..Settings::default()
    }
}

/// The lines of a layer.
fn lines(drawing: &Drawing, name: &str) -> Vec<Vec<[f32; 2]>> {
    let layers = drawing.layers.iter().filter(|l| l.name == name).flat_map(|l| &l.shapes);
    let line = |shape: &Shape| match shape {
        Shape::Line { points, .. } => Some(points.clone()),
        _ => None,
    };
    layers.filter_map(line).collect()
}

fn length(line: &[[f32; 2]]) -> f32 {
    line.windows(2).map(|w| (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1])).sum()
}

/// Nine edges are seen whole, and three are hidden whole, but for a hundredth of their length.
fn check_cuboid(scene: &Scene) {
    let whole = lines(&draw(scene, &settings(Hidden::Solid)).unwrap(), "crease");
    assert_eq!(whole.len(), 12 + lines(&draw(scene, &settings(Hidden::Dashed)).unwrap(), "crease").len() - 9);
    let drawing = draw(scene, &settings(Hidden::Dashed)).unwrap();
    let (seen, hidden) = (lines(&drawing, "crease"), lines(&drawing, "crease-hidden"));
    assert_eq!((seen.len(), hidden.len()), (9, 3));
    let total = |lines: &[Vec<[f32; 2]>]| lines.iter().map(|l| length(l)).sum::<f32>();
    assert!((total(&seen) + total(&hidden) - total(&whole)).abs() < 1.0);
    assert!(seen.iter().chain(&hidden).all(|line| (2..=3).contains(&line.len())), "vectors, not samples");
    assert_eq!(lines(&drawing, "silhouette"), Vec::<Vec<[f32; 2]>>::new());
    assert_eq!(lines(&draw(scene, &settings(Hidden::None)).unwrap(), "crease-hidden").len(), 0);
}

#[test]
fn nine_edges_of_a_cuboid_of_points_are_seen_and_three_are_hidden() {
    let scan = Scan::new(Sampling::BlueNoise { count: 8000 }).noise(0.1).seed(3);
    let (surfels, spacing) = surfels(&cuboid(EDGES).sample(&scan).cloud).unwrap();
    let network = edges();
    check_cuboid(&Scene { surfels: &surfels, network: Some(&network), spacing, ..Scene::default() });
}

#[test]
fn nine_edges_of_a_cuboid_of_triangles_are_seen_and_three_are_hidden() {
    let vertices: Vec<[f64; 3]> = (0..8).map(corner).collect();
    let faces = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    let triangles: Vec<[u32; 3]> = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    let mesh = Some(Triangles { vertices: &vertices, triangles: &triangles });
    let network = edges();
    check_cuboid(&Scene { mesh, network: Some(&network), spacing: 0.03, ..Scene::default() });
}

#[test]
fn without_a_surface_all_edges_are_seen() {
    let network = edges();
    let drawing =
        draw(&Scene { network: Some(&network), ..Scene::default() }, &settings(Hidden::None)).unwrap();
    assert_eq!(lines(&drawing, "crease").len(), 12);
    let captioned = Settings { caption: true, ..settings(Hidden::None) };
    let drawing = draw(&Scene { network: Some(&network), ..Scene::default() }, &captioned).unwrap();
    assert_eq!(drawing.texts[0].text, "12 creases", "points that are not drawn are not counted");
}

#[test]
fn a_sphere_has_one_outline_which_is_a_circle() {
    let cloud = sphere(1.0).sample(&Scan::new(Sampling::BlueNoise { count: 5000 }).seed(2)).cloud;
    let (surfels, spacing) = surfels(&cloud).unwrap();
    let drawing =
        draw(&Scene { surfels: &surfels, spacing, ..Scene::default() }, &settings(Hidden::Dashed)).unwrap();
    let outlines = lines(&drawing, "silhouette");
    assert_eq!(outlines.len(), 1);
    assert_eq!(outlines[0].first(), outlines[0].last());
    let pixels = drawing.scale as f32;
    for p in &outlines[0] {
        let radius = (p[0] - 240.0).hypot(p[1] - 200.0) / pixels;
        assert!((radius - 1.0).abs() < 0.5 * spacing as f32, "{radius}");
    }
}

#[test]
fn a_rough_sphere_has_one_outline() {
    let scan = Scan::new(Sampling::BlueNoise { count: 5000 }).noise(0.25).seed(2);
    let (surfels, spacing) = surfels(&sphere(1.0).sample(&scan).cloud).unwrap();
    let scene = Scene { surfels: &surfels, spacing, ..Scene::default() };
    assert_eq!(lines(&draw(&scene, &settings(Hidden::Dashed)).unwrap(), "silhouette").len(), 1);
}

#[test]
fn a_torus_from_above_has_an_outer_and_an_inner_outline() {
    let cloud = torus(2.0, 0.6).sample(&Scan::new(Sampling::BlueNoise { count: 8000 }).seed(2)).cloud;
    let (surfels, spacing) = surfels(&cloud).unwrap();
    let settings = Settings { views: vec![View::From([0.0, 0.0, 1.0])], ..settings(Hidden::Dashed) };
    let drawing = draw(&Scene { surfels: &surfels, spacing, ..Scene::default() }, &settings).unwrap();
    let lengths: Vec<f32> =
        lines(&drawing, "silhouette").iter().map(|l| length(l) / drawing.scale as f32).collect();
    let [outer, inner] = [2.6, 1.4].map(|radius| std::f32::consts::TAU * radius);
    assert_eq!(lengths.len(), 2);
    assert!(
        (lengths[0] - outer).abs() < 0.1 * outer && (lengths[1] - inner).abs() < 0.1 * inner,
        "{lengths:?}"
    );
}

#[test]
fn several_views_share_their_scale_and_have_names() {
    let network = edges();
    let views = View::parse_list("front,top,left,iso").unwrap();
    let settings = Settings { views, scale_bar: Some("mm".into()), ..settings(Hidden::Solid) };
    let drawing = draw(&Scene { network: Some(&network), ..Scene::default() }, &settings).unwrap();
    let texts: Vec<&str> = drawing.texts.iter().map(|t| t.text.as_str()).collect();
    assert_eq!(texts, ["front", "top", "left", "iso", "2 mm"]);
    let long = lines(&drawing, "crease").iter().map(|l| length(l)).fold(0.0, f32::max);
    assert!(
        (long - 4.0 * drawing.scale as f32).abs() < 0.5,
        "the longest edge is 4 units in the front and from above"
    );
}
