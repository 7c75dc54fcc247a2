use crate::params::{Method, SegmentForm};
use crate::shapes::{Sampling, Scan, Shape, cube, pipe_cross};
use crate::{Extraction, Params, extract};

fn segmented(shape: &Shape, count: usize, form: SegmentForm) -> Extraction {
    let part = shape.sample(&Scan::new(Sampling::Area { count }).seed(1));
    let mut params = Params { method: Method::Segments, ..Params::default() };
    params.segments.form = form;
    extract(&part.cloud, &params).unwrap()
}

fn open_ends(result: &Extraction) -> usize {
    let closed = &result.pattern.crease.edges;
    closed.iter().filter(|e| e.len() == 1).count()
}

#[test]
fn a_cube_has_six_large_clusters_and_nothing_open_in_either_form() {
    for form in [SegmentForm::Paper, SegmentForm::Robust] {
        let result = segmented(&cube(10.0), 15_206, form);
        let clusters = result.clusters.as_ref().unwrap();
        assert_eq!(clusters.segmented.segments.large_count(), 6, "{form:?}");
        assert_eq!(open_ends(&result), 0, "{form:?}");
        assert!(result.pattern.crease.edge_count() > 100, "{form:?}");
        let names: Vec<&str> = clusters.graphs.iter().map(|g| g.name).collect();
        let stages = ["G_all", "G_extended", "G_pruned_mst", "G_pruned_branches", "G_closed", "G_smooth"];
        assert_eq!(names, stages);
    }
}

#[test]
fn a_spanning_forest_has_fewer_edges_than_vertices_and_the_extended_graph_more_than_all() {
    let result = segmented(&pipe_cross(), 26_846, SegmentForm::Paper);
    let graphs = result.clusters.unwrap().graphs;
    assert!(graphs[1].edges > graphs[0].edges);
    assert!(graphs[2].edges < graphs[2].vertices);
    assert_eq!(open_ends(&segmented(&pipe_cross(), 26_846, SegmentForm::Paper)), 0);
}
