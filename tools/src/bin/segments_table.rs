//! Tables 1 and 2 of Demarsin et al. 2007 for shapes of the paper's kind and size, in both forms of the method: `cargo run
//! --release -p lineament-tools --bin segments_table`.

use lineament::params::{Method, SegmentForm};
use lineament::shapes::{Sampling, Scan, brick, cube, pipe_cross};
use lineament::{Params, extract};

fn main() -> Result<(), lineament::Error> {
    let parts = [
        ("cube", cube(10.0), 15_206, 0.0),
        ("cylinders", pipe_cross(), 26_846, 0.0),
        ("brick", brick(), 41_432, 0.06),
        ("large", pipe_cross(), 110_053, 0.0),
    ];
    for form in [SegmentForm::Paper, SegmentForm::Robust] {
        for (name, shape, count, noise) in &parts {
            let part = shape.sample(&Scan::new(Sampling::Area { count: *count }).noise(*noise).seed(1));
            let mut params = Params { method: Method::Segments, ..Params::default() };
            params.segments.form = form;
            let result = extract(&part.cloud, &params)?;
            let Some(clusters) = &result.clusters else { continue };
            let segments = &clusters.segmented.segments;
            println!(
                "{form:?} {name}: {count} points, {} small of {:.2} points, {} large",
                segments.small_count(),
                segments.mean_small(),
                segments.large_count()
            );
            for (step, seconds) in &clusters.segmented.seconds {
                println!("  {step:18} {:27.3} s", seconds);
            }
            for graph in &clusters.graphs {
                let ends = graph.lines.edges.iter().filter(|e| e.len() == 1).count();
                let (vertices, edges) = (graph.vertices, graph.edges);
                println!(
                    "  {:18} {vertices:6} V {edges:6} E {ends:5} ends {:.3} s",
                    graph.name, graph.seconds
                );
            }
            println!("  strips {}, loops {}", result.network.strips.len(), result.network.loops());
            let steps: f64 = clusters.segmented.seconds.iter().map(|s| s.1).sum();
            let graphs: f64 = clusters.graphs.iter().map(|g| g.seconds).sum();
            if let Some((_, search)) = clusters.segmented.seconds.iter().find(|s| s.0 == "neighbors") {
                println!("  all steps together take {:.2} times the search", (steps + graphs) / search);
            }
            if let Some(patches) = &result.patches {
                println!("  patches {}, creases between two {}", patches.patches.len(), patches.separating());
            }
        }
    }
    Ok(())
}
