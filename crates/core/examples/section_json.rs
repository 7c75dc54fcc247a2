//! Interim: `section_json section CLOUD.ply -o OUT.json --axis x|y|z --at=Z1,Z2`.
use lineament::{Cloud, section};
use std::io::Write;
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let bytes = std::fs::read(&args[2]).unwrap();
    let out = &args[4];
    let mut params = section::SectionParams::default();
    params.axis = section::Axis::Coordinate(match args[6].as_str() {
        "x" => 0,
        "y" => 1,
        _ => 2,
    });
    params.planes = section::Planes::At(
        args[7].trim_start_matches("--at=").split(',').map(|s| s.parse().unwrap()).collect(),
    );
    for w in args[8..].chunks(2) {
        match (w[0].as_str(), w[1].as_str()) {
            ("--outline", "hull") => params.outline = section::Outline::Hull,
            ("--outline", "voronoi") => params.outline = section::Outline::Voronoi,
            ("--side", "out") => params.side = section::Side::Outside,
            ("--side", "in") => params.side = section::Side::Inside,
            ("--carry", "no") => params.carry = false,
            ("--count", n) => params.planes = section::Planes::Count(n.parse().unwrap()),
            _ => panic!("{w:?}"),
        }
    }
    let end = bytes.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
    let head = String::from_utf8_lossy(&bytes[..end]).to_string();
    let n: usize =
        head.lines().find(|l| l.starts_with("element vertex")).unwrap()[15..].trim().parse().unwrap();
    let props: Vec<&str> = head.lines().filter(|l| l.starts_with("property")).collect();
    let double = props[0].contains("double") || props[0].contains("float64");
    let size = |p: &str| {
        if p.contains("double") || p.contains("float64") {
            8
        } else if p.contains("float") || p.contains(" int") || p.contains("uint ") {
            4
        } else {
            1
        }
    };
    let stride: usize = props.iter().map(|p| size(p)).sum();
    let w = if double { 8 } else { 4 };
    let get = |o: usize| {
        if double {
            f64::from_le_bytes(bytes[o..o + 8].try_into().unwrap())
        } else {
            f64::from(f32::from_le_bytes(bytes[o..o + 4].try_into().unwrap()))
        }
    };
    let pos: Vec<[f64; 3]> = (0..n)
        .map(|i| {
            let o = end + i * stride;
            [get(o), get(o + w), get(o + 2 * w)]
        })
        .collect();
    let t = std::time::Instant::now();
    let result = section::section(&Cloud::new(pos), &params).unwrap();
    eprintln!("{:?}", t.elapsed());
    let mut f = std::io::BufWriter::new(std::fs::File::create(out).unwrap());
    write!(f, "{{\"strips\":[").unwrap();
    for (i, (plane, c)) in result.contours().enumerate() {
        if i > 0 {
            write!(f, ",").unwrap();
        }
        let p: Vec<String> = c.points.iter().map(|p| format!("[{},{},{}]", p[0], p[1], p[2])).collect();
        writeln!(f, "{{\"closed\":{},\"plane\":{},\"points\":[{}]}}", c.closed, plane, p.join(",")).unwrap();
    }
    write!(f, "]}}").unwrap();
}
