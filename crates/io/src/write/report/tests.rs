//! Reports, read again as the viewer reads them.

use super::*;
use base64::prelude::{BASE64_STANDARD, Engine};
use lineament::patch::NO_PATCH;
use lineament::section::{Planes, SectionParams, section_observed};
use lineament::{Params, extract, shapes};
use serde_json::Value;
use sha2::{Digest, Sha256};

/// The page and its data.
fn page(report: &Report) -> (String, Value) {
    let mut bytes = Vec::new();
    write_report_to(&mut bytes, report).unwrap();
    let page = String::from_utf8(bytes).unwrap();
    let (_, rest) = page.split_once("id=\"data\">").unwrap();
    let data = serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap();
    (page, data)
}

fn bytes(value: &Value) -> Vec<u8> {
    BASE64_STANDARD.decode(value.as_str().unwrap()).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// The positions of the points, world frame.
fn positions(points: &Value) -> Vec<[f64; 3]> {
    let width = points["bytes"].as_u64().unwrap() as usize;
    let whole = |b: &[u8]| b.iter().rev().fold(0u64, |sum, &x| 256 * sum + u64::from(x)) as f64;
    let place = |row: &[u8]| {
        [0, 1, 2].map(|k| {
            let steps = whole(&row[k * width..(k + 1) * width]);
            number(&points["corner"][k]) + steps * number(&points["step"])
        })
    };
    bytes(&points["positions"]).chunks_exact(3 * width).map(place).collect()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

fn context() -> NetworkContext {
    NetworkContext { input_name: "part.ply".into(), ..NetworkContext::default() }
}

#[test]
fn lines_come_back_bit_for_bit_and_points_within_a_step() {
    let cloud = shapes::cube_386().cloud;
    let found = extract(&cloud, &Params::default()).unwrap();
    let context = context();
    let classes: Vec<u8> = found.classes().iter().map(|&c| c as u8).collect();
    let report = Report {
        cloud: Some(&cloud),
        classes: &classes,
        network: Some(&found.network),
        ..Report::new(&context)
    };
    let (_, data) = page(&report);
    let read: Vec<f64> = bytes(&data["coordinates"])
        .chunks_exact(8)
        .map(|b| f64::from_le_bytes(b.try_into().unwrap()))
        .collect();
    let written: Vec<f64> =
        found.network.strips.iter().flat_map(|s| s.points.iter().flatten().copied()).collect();
    assert_eq!(read, written);
    assert_eq!(data["strips"].as_array().unwrap().len(), found.network.strips.len());
    assert_eq!(data["nodes"].as_array().unwrap().len(), found.network.nodes.len());
    let points = &data["points"];
    let (step, spacing) = (number(&points["step"]), number(&points["spacing"]));
    assert!(32.0 * step <= spacing, "a step of {step} at a spacing of {spacing}");
    let read = positions(points);
    assert_eq!(read.len(), cloud.len());
    let read_classes = bytes(&points["classes"]);
    for (p, class) in read.iter().zip(read_classes) {
        let near = |q: &[f64; 3]| distance(*p, *q) < step;
        let source = cloud.positions.iter().position(near).expect("a point of the cloud");
        assert_eq!(class, classes[source]);
    }
}

#[test]
fn every_beginning_of_the_points_covers_the_cloud() {
    let cloud = shapes::cube_386().cloud;
    let context = context();
    let (_, data) = page(&Report { cloud: Some(&cloud), ..Report::new(&context) });
    let read = positions(&data["points"]);
    let quarter = &read[..read.len() / 4];
    let farthest = |p: &[f64; 3]| quarter.iter().map(|q| distance(*p, *q)).fold(f64::INFINITY, f64::min);
    let worst = read.iter().map(farthest).fold(0.0, f64::max);
    assert!(worst < 5.0 * number(&data["points"]["spacing"]), "{worst}");
}

#[test]
fn names_end_no_element_and_no_text() {
    let name = "</script><script>alert('\u{2028}')</script><!-- \"a\\b\" & .ply";
    let context = NetworkContext { input_name: name.into(), ..NetworkContext::default() };
    let (page, data) = page(&Report::new(&context));
    assert_eq!(data["input"]["name"], name);
    assert_eq!(page.matches("</script").count(), 2, "the data and the viewer end once each");
    assert!(!page.contains("<script>alert") && !page.contains("<!-- "));
    assert!(page.contains("<title>&lt;/script&gt;&lt;script&gt;alert("));
}

#[test]
fn nothing_is_fetched() {
    let context = context();
    let (page, _) = page(&Report::new(&context));
    let head = page.split_once("<script").unwrap().0;
    assert!(head.contains("default-src 'none'") && !head.contains("src=\"http") && !head.contains("<link"));
}

#[test]
fn large_clouds_are_thinned_to_the_limit() {
    let side = 900u32;
    let row = |y: u32| {
        (0..side).map(move |x| [f64::from(x), f64::from(y), 0.01 * f64::from((x * 7 + y * 13) % 11)])
    };
    let cloud = Cloud::new((0..side).flat_map(row).collect());
    let classes = vec![0; cloud.len()];
    let labels: Vec<u32> =
        (0..cloud.len() as u32).map(|i| if i % 2 == 0 { NO_PATCH } else { i % 70_000 }).collect();
    let context = context();
    let report = Report { cloud: Some(&cloud), classes: &classes, labels: &labels, ..Report::new(&context) };
    let (page, data) = page(&report);
    assert!(page.len() < 15_000_000, "{} bytes", page.len());
    let count = data["points"]["count"].as_u64().unwrap();
    assert!(count > 300_000 && count < cloud.len() as u64, "{count} points");
    assert_eq!(data["points"]["of"], cloud.len());
    assert_eq!(bytes(&data["points"]["labels"]).len() as u64, 2 * count);
    assert_eq!(bytes(&data["points"]["normals"]).len() as u64, 3 * count);
}

#[test]
fn the_bytes_depend_on_no_thread() {
    let cloud = shapes::cube_386().cloud;
    let found = extract(&cloud, &Params::default()).unwrap();
    let context = context();
    let report = Report { cloud: Some(&cloud), network: Some(&found.network), ..Report::new(&context) };
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| page(&report).0)
    };
    assert!(with(1) == with(3));
}

#[test]
fn sections_come_back_within_single_precision() {
    let cloud = shapes::cube_386().cloud;
    let params = SectionParams { planes: Planes::Count(5), fit: true, ..SectionParams::default() };
    let (sections, stack) = section_observed(&cloud, &params, &|_| ()).unwrap();
    let context = context();
    let report = Report { cloud: Some(&cloud), sections: Some((&sections, &stack)), ..Report::new(&context) };
    let (_, data) = page(&report);
    let found = &data["sections"];
    assert_eq!(found["planes"].as_array().unwrap().len(), 5);
    assert_eq!(found["runs"].as_array().unwrap().len(), stack.runs.len());
    let single = |b: &[u8]| f64::from(f32::from_le_bytes(b.try_into().unwrap()));
    let read: Vec<f64> = bytes(&found["coordinates"]).chunks_exact(4).map(single).collect();
    let written: Vec<f64> =
        sections.contours().flat_map(|(_, c)| c.points.iter().flatten().copied()).collect();
    assert!(!written.is_empty() && read.len() == written.len());
    for (i, (r, w)) in read.iter().zip(&written).enumerate() {
        assert!((r + number(&found["corner"][i % 3]) - w).abs() < 1e-6, "{i}");
    }
}

#[test]
fn reports_of_nothing_and_of_few_points_are_pages() {
    let context = context();
    for count in 0..4 {
        let cloud = Cloud::new((0..count).map(|x| [f64::from(x), 0.0, f64::NAN.min(0.0)]).collect());
        let (page, data) = page(&Report { cloud: Some(&cloud), ..Report::new(&context) });
        assert!(page.ends_with("</html>\n"));
        assert_eq!(data["points"]["count"], count);
    }
}

#[test]
fn columns_of_another_length_are_refused() {
    let cloud = Cloud::new(vec![[0.0; 3]; 2]);
    let context = context();
    let report = Report { cloud: Some(&cloud), classes: &[0], ..Report::new(&context) };
    let folder = tempfile::tempdir().unwrap();
    let error = write_report(&folder.path().join("a.html"), &[], &report).unwrap_err().to_string();
    assert!(error.contains("1 classes for 2 points"), "{error}");
}

/// All files below a folder of the viewer, by their names within `web`.
fn sources(folder: &Path, prefix: &str, found: &mut Vec<(String, PathBuf)>) {
    for entry in std::fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            sources(&entry.path(), &format!("{name}/"), found);
        } else {
            found.push((name, entry.path()));
        }
    }
}

/// `build.mjs` writes the same hash into the first line of the script.
#[test]
fn the_bundle_is_current() {
    let web = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web");
    let mut found: Vec<(String, PathBuf)> =
        ["build.mjs", "package.json", "package-lock.json"].map(|n| (n.to_string(), web.join(n))).into();
    sources(&web.join("src"), "src/", &mut found);
    found.sort();
    let mut hash = Sha256::new();
    for (name, path) in found {
        hash.update(format!("{name}\n"));
        hash.update(std::fs::read_to_string(path).unwrap().replace("\r\n", "\n"));
    }
    let digest: String = hash.finalize().iter().map(|b| format!("{b:02x}")).collect();
    let first = include_str!("viewer.js").lines().next().unwrap();
    assert_eq!(first, format!("// sources {digest}"), "run `cargo xtask web`");
}
