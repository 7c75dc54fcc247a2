//! Curves over noise as an SVG drawing.

use std::fmt::Write;

/// A named curve; points are `[noise, f1]`.
pub struct Curve {
    pub name: String,
    pub points: Vec<[f64; 2]>,
}

const SIZE: [f64; 2] = [720.0, 420.0];
/// Left, top, right, bottom of the frame.
const FRAME: [f64; 4] = [60.0, 20.0, 520.0, 370.0];
const COLOURS: [&str; 7] = ["#c00020", "#1060c0", "#e08000", "#208040", "#8040a0", "#606060", "#e070a0"];
const MOST_NOISE: f64 = 0.5;

/// The drawing, with a dashed line at the noise above which the method warns.
pub fn svg(curves: &[Curve], limit: f64) -> String {
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        SIZE[0], SIZE[1]
    );
    for tick in 0..=5 {
        let share = f64::from(tick) / 5.0;
        let [x, y] = place([share * MOST_NOISE, share]);
        line(&mut out, [[FRAME[0], y], [FRAME[2], y]], "#dddddd", "");
        line(&mut out, [[x, FRAME[1]], [x, FRAME[3]]], "#dddddd", "");
        text(&mut out, [FRAME[0] - 8.0, y + 4.0], "end", "black", &format!("{share:.1}"));
        text(&mut out, [x, FRAME[3] + 18.0], "middle", "black", &format!("{:.1}", share * MOST_NOISE));
    }
    let [x, _] = place([limit, 0.0]);
    line(&mut out, [[x, FRAME[1]], [x, FRAME[3]]], "#c00020", " stroke-dasharray=\"5 4\"");
    text(&mut out, [x + 4.0, FRAME[1] + 12.0], "start", "#c00020", "warning");
    for (k, curve) in curves.iter().enumerate() {
        let colour = COLOURS[k % COLOURS.len()];
        let places = curve.points.iter().map(|&p| place(p).map(|c| format!("{c:.1}")).join(","));
        let places = places.collect::<Vec<_>>().join(" ");
        let width = if k == 0 { 3 } else { 2 };
        let _ = writeln!(
            out,
            "<polyline points=\"{places}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"/>"
        );
        text(&mut out, [FRAME[2] + 14.0, FRAME[1] + 20.0 + 22.0 * k as f64], "start", colour, &curve.name);
    }
    let middle = 0.5 * (FRAME[0] + FRAME[2]);
    text(&mut out, [middle, SIZE[1] - 12.0], "middle", "black", "noise, spacings");
    text(&mut out, [8.0, 14.0], "start", "black", "F1");
    out + "</svg>\n"
}

fn place([noise, f1]: [f64; 2]) -> [f64; 2] {
    [FRAME[0] + (FRAME[2] - FRAME[0]) * noise / MOST_NOISE, FRAME[3] - (FRAME[3] - FRAME[1]) * f1]
}

fn line(out: &mut String, [a, b]: [[f64; 2]; 2], colour: &str, extra: &str) {
    let _ = writeln!(
        out,
        "<line x1=\"{:.1}\" y1=\"{:.1}\" x2=\"{:.1}\" y2=\"{:.1}\" stroke=\"{colour}\"{extra}/>",
        a[0], a[1], b[0], b[1]
    );
}

fn text(out: &mut String, at: [f64; 2], anchor: &str, colour: &str, words: &str) {
    let _ = writeln!(
        out,
        "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"{anchor}\" fill=\"{colour}\">{words}</text>",
        at[0], at[1]
    );
}
