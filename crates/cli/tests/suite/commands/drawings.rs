//! Line drawings, sheets of views and grounds of pictures.

use crate::common::{Sandbox, cube};

#[test]
fn render_writes_line_drawings_as_vectors() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    sandbox.run(&["extract", "cube.xyz", "-o", "n.json"]).expect(0);
    let base = ["render", "--network", "n.json", "--view", "1,-1.7,0.8", "--size", "320x240"];
    let drawn = |input: &str, more: &[&str]| {
        sandbox.run(&[&base[..], &[input, "-o", "a.svg"], more].concat()).expect(0);
        String::from_utf8(sandbox.read("a.svg")).unwrap()
    };
    let paths = |svg: &str, group: &str| {
        let part = svg.split(&format!("<g id=\"{group}\"")).nth(1).and_then(|rest| rest.split("</g>").next());
        part.map_or(0, |part| part.matches("<path").count())
    };
    let dashed = drawn("cube.xyz", &[]);
    assert_eq!((paths(&dashed, "crease"), paths(&dashed, "crease-hidden")), (9, 3));
    let without =
        drawn("cube.xyz", &["--hidden", "none", "--background", "none", "--scale-bar", "--unit", "mm"]);
    assert_eq!((paths(&without, "crease"), paths(&without, "crease-hidden")), (9, 0));
    assert!(without.contains(" mm</text>") && !without.contains("id=\"ground\""));
    let frame = drawn("cube.xyz", &["--surface", "none"]);
    assert_eq!((paths(&frame, "crease"), paths(&frame, "crease-hidden")), (12, 0));
}

#[test]
fn render_draws_lines_without_points_and_behind_a_mesh() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    sandbox.run(&["extract", "cube.xyz", "-o", "n.json"]).expect(0);
    let faces = ["1 2 4 3", "5 6 8 7", "1 2 6 5", "3 4 8 7", "1 3 7 5", "2 4 8 6"];
    let side = |bit: usize| if bit == 0 { -0.5 } else { 0.5 };
    let vertices = (0..8).map(|i| format!("v {} {} {}\n", side(i & 1), side(i & 2), side(i & 4)));
    let mesh = vertices.chain(faces.iter().map(|f| format!("f {f}\n"))).collect::<String>();
    sandbox.write("cube.obj", mesh);
    let hidden = |more: &[&str]| {
        let base = ["render", "n.json", "-o", "a.svg", "--view", "1,-1.7,0.8", "--size", "320x240"];
        sandbox.run(&[&base[..], more].concat()).expect(0);
        String::from_utf8(sandbox.read("a.svg")).unwrap().matches("stroke-dasharray").count()
    };
    assert_eq!((hidden(&[]), hidden(&["--surface", "cube.obj"])), (0, 3));
    sandbox.run(&["render", "cube.xyz", "-o", "a.png", "--surface", "cube.xyz"]).expect(3);
}

#[test]
fn a_transparent_ground_shows_through_beside_the_surface_and_not_in_it() {
    let sandbox = Sandbox::new();
    sandbox.write_points("cube.xyz", &cube());
    let base =
        ["render", "cube.xyz", "-o", "a.png", "--background", "none", "--no-caption", "--size", "320x240"];
    sandbox.run(&[&base[..], &["--point-color", "class", "--view", "front,top"]].concat()).expect(0);
    let (width, height, pixels) = decode(&sandbox.read("a.png"));
    assert_eq!(pixels.len(), 4 * (width * height) as usize);
    let alpha = |x: u32, y: u32| pixels[4 * (y * width + x) as usize + 3];
    assert_eq!((alpha(2, 200), alpha(80, 120), alpha(240, 120)), (0, 255, 255));
}

/// Width, height and bytes of a picture.
fn decode(bytes: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    (info.width, info.height, pixels)
}
