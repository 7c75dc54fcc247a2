use lineament::section::*;
use lineament::shapes::*;
use std::time::Instant;
fn main() {
    let count: usize = std::env::args().nth(1).and_then(|a| a.parse().ok()).unwrap_or(1_000_000);
    let cloud = bracket().sample(&Scan::new(Sampling::Area { count }).noise(0.1).seed(1)).cloud;
    let params = SectionParams { planes: Planes::Count(100), fit: true, ..SectionParams::default() };
    for _ in 0..4 {
        let t = Instant::now();
        let s = section(&cloud, &params).unwrap();
        let a = t.elapsed().as_secs_f64();
        let t = Instant::now();
        let (s2, st) = section_observed(&cloud, &params, &|_| ()).unwrap();
        let b = t.elapsed().as_secs_f64();
        println!(
            "section {a:.3} named {b:.3} add {:.2} ({} {} runs {})",
            (b - a) / a,
            s.contours().count(),
            s2.contours().count(),
            st.runs.len()
        );
    }
}
