//! Lesson 2: a class and a score for each point. `cargo run --example 02_classify` writes `cube.ply`.

use lineament::detect::baselines::Detector;
use lineament::detect::points::mark;
use lineament::{Class, Params, extract, shapes};
use lineament_io::{PointTable, write_points};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // The 386 surface points of a 9 x 9 x 9 grid: 8 corners, 12 edges of 7 further points, 6 faces.
    let cloud = shapes::cube_386().cloud;

    // Classes follow from the network: a point is on a crease if a crease passes within a spacing or so.
    let found = extract(&cloud, &Params::default())?;
    let (classes, scores) = (found.classes(), found.scores());
    let count = |wanted: Class| classes.iter().filter(|&&class| class == wanted).count();
    println!("{} on creases, {} at corners", count(Class::Crease), count(Class::Corner));
    assert!(count(Class::Crease) >= 84 && count(Class::Border) == 0);

    // Rows are those of the cloud, in its order; attributes of the input go along.
    let bytes: Vec<u8> = classes.iter().map(|&class| class as u8).collect();
    let table = PointTable { cloud: &cloud, classes: &bytes, scores: &scores, las: None };
    write_points("cube.ply".as_ref(), &[], &table)?;

    // A detector alone marks points without lines: faster, and the way to compare measures.
    let marked = mark(&cloud, &Params::default(), &[Detector::Projection])?;
    let sharp = marked.classes(0).iter().filter(|&&class| class != Class::Smooth).count();
    println!("{sharp} points above the threshold of the projected distance");
    assert!(sharp > 0);
    Ok(())
}
