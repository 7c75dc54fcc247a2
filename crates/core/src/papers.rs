//! The four papers, term by term: where each of their sections, equations, algorithms and figures is in the code.
//!
//! This module holds documentation only. An item is a path below `crates/core/src`: `link::spanning::graph::closes_long` is the
//! function `closes_long` in `link/spanning/graph.rs`. The paper's own word stands in the file of the item, so that one search
//! for the word finds it. A test checks both. How to run each paper as printed, its parameters and figures: `docs/papers.md`.
//!
//! # S. Gumhold, X. Wang, R. MacLeod: Feature Extraction from Point Clouds (2001)
//!
//! | in the paper | its word | item |
//! |---|---|---|
//! | section 2.1 | Riemannian graph | `neighbors::riemannian::graph` |
//! | section 2.1, figure 3 | Gabriel complex | `delaunay::facets::facets` |
//! | section 2.1 | umbrella filter | `delaunay::umbrella::umbrella` |
//! | section 2.1, figure 4 | average edge length | `delaunay::long::without_long` |
//! | equation 1 | average distance | `neighbors::density::mean_distance` |
//! | equations 2, 3 | correlation matrix | `math::tensor::ellipsoid` |
//! | figure 6 | correlation ellipsoid | `math::tensor::Ellipsoid` |
//! | section 3.1, equations 4 to 9 | penalty functions | `detect::penalty::as_printed::penalties` |
//! | equation 5 | omega_kappa | `detect::penalty::as_printed::penalties` |
//! | equation 8, figure 7 b | open angle | `detect::evidence::open_angle::open_angle` |
//! | equation 9 | corner penalty | `detect::penalty::as_printed::point` |
//! | section 3.2 | w_c, w_b | `link::spanning::weight::weigh` |
//! | section 3.2, figure 5 b | minimum spanning graph | `link::spanning::graph::minimum_spanning_graph` |
//! | section 3.2 | cycle test, pathLonger | `link::spanning::graph::closes_long` |
//! | section 3.2 | disjoint set | `math::union_find::UnionFind` |
//! | section 3.3, figure 5 c | pruning | `link::spanning::prune::prune` |
//! | section 3.3 | singleton end | `link::spanning::prune::prune` |
//! | section 4, figure 8 | spline | `recover::spline::strip` |
//! | section 4 | chordal length parameterization | `curve::fit::fit` |
//! | section 4 | feature recovery | `recover::sharpen::sharpen` |
//! | section 4.1 | crease strips | `pattern::paths::paths` |
//! | section 4.1 | crease points, crease direction | `recover::wedge::stations::stations` |
//! | section 4.1, figure 9 b, c | wedge fitting, split line, zenith | `recover::wedge::split::split` |
//! | section 4.1 | smallest eigenvalue | `math::eigen2::least_vector` |
//! | section 4.1, figure 10 c | votes, weight, axes | `recover::wedge::vote::votes` |
//! | section 4.1 | near zero, sign | `recover::wedge::vote::sides` |
//! | section 4.1, figure 10 d | two planes, intersection | `recover::wedge::plane::project` |
//! | section 4.2, figure 11 b | centroid of the neighbourhood, junction point | `recover::corner::view::View` |
//! | section 4.2, figure 11 c | initial grouping | `recover::corner::view::sector` |
//! | section 4.2, figure 11 d, e | k weights, no point changes | `recover::corner::group::group` |
//! | section 4.2, figure 11 f | k planes | `recover::corner::junctions::junctions` |
//! | section 4.2 | quadric error | `recover::corner::quadric_error::corner` |
//! | section 5.1 | neighbor graph | `apply::graph::cut_graph` |
//! | section 5.2, figure 12 | enrichment | `apply::enrich::line_points` |
//! | section 5.2 | third filter | `apply::meshing` |
//! | section 5.1 | advancing front | not built |
//! | section 5.3, figures 13, 14 | non photorealistic rendering | `apply::render` |
//! | section 6.2 | isolated peaks | not built |
//!
//! # K. Demarsin, D. Vanderstraeten, T. Volodine, D. Roose: Detection of closed sharp edges in point clouds (2007)
//!
//! | in the paper | its word | item |
//! |---|---|---|
//! | section 2.2 | one-ring | `neighbors::delaunay_ring::one_rings` |
//! | section 2.2, figure 1 | first-order segmentation | `detect::segments` |
//! | section 2.2 | region growing | `detect::segments::segmentation::Segmentation` |
//! | section 2.2 | perfectly aligned points | `detect::segments::segmentation::take_apart` |
//! | Algorithm 1 | closed sharp feature lines | `link::clusters` |
//! | section 2.3, figure 2 | G_all | `link::clusters::all::all_clusters` |
//! | section 2.4, figure 4 | G_extended | `link::clusters::extend::extend` |
//! | section 2.5 | G_pruned_mst | `link::clusters::forest::forest` |
//! | Algorithm 2, section 2.6 | G_pruned_branches | `link::clusters::branches::prune_branches` |
//! | section 2.7, figure 5 | connect algorithm | `link::clusters::connect::connect` |
//! | section 2.7 | G_closed | `link::clusters::as_printed::link_as_printed` |
//! | section 2.8 | G_smooth | `link::clusters::smooth::smooth` |
//! | section 3 | boundary | `link::clusters::include::include` |
//! | section 4, future work | curve network | `patch` |
//!
//! # T.-T. Tran, S. Ali, D. Laurendeau: Automatic Sharp Feature Extraction with Optimal Neighborhood Size (2013)
//!
//! | in the paper | its word | item |
//! |---|---|---|
//! | equation 1, figure 2 | projected distance | `detect::projection::scales::AtScale` |
//! | section 2.2, table 1 | several scales | `detect::projection::scales::at_every_scale` |
//! | section 2.3, figure 3 | rate of change | `detect::projection::choice::best_scale` |
//! | section 2.3, figure 4 | optimal neighborhood size | `detect::projection::choice::best_scale` |
//! | section 2.4, figure 5 | Otsu's method | `math::otsu::otsu` |
//! | section 2.4 | histogram | `math::otsu::histogram` |
//! | section 2.4 | sharp feature | `detect::projection` |
//! | section 3.1, figures 6, 7 | surface variation | `detect::baselines::variation` |
//! | section 3.1, figure 6 | mean curvature | `detect::baselines::curvature` |
//! | section 3.1, figure 6 | normal difference | `detect::baselines::normal_difference::mean_angle` |
//! | section 3.2, figure 8 | noise | `detect::projection::warning` |
//!
//! # I. Kyriazis, I. Fudos, L. Palios: Detecting Features from Sliced Point Clouds (2007)
//!
//! | in the paper | its word | item |
//! |---|---|---|
//! | section 2, figure 1 | slicing direction | `section::slicing::direction` |
//! | section 2 | adaptive thickness | `section::slicing::adaptive` |
//! | section 2, figure 2 | slab | `section::slicing::slabs` |
//! | section 3, figures 3, 4 | convex hull | `section::outline::hull::features` |
//! | section 3 | feature points | `section::outline::regions::refine` |
//! | section 3, figure 5 | false assignments | `section::contour::assign::assign` |
//! | section 3, figure 5 | region of a point | `section::outline::regions::refine` |
//! | section 4, figure 6 | switching effect | `section::outline::voronoi` |
//! | section 4, figure 7 | largest empty circle | `section::outline::voronoi::features` |
//! | section 4 | Voronoi vertex | `section::outline::voronoi::circle` |
//! | sections 1, 2 | holes, extrusions | `section::stack::stack` |
//! | section 1 | symmetrical | `section::stack::mirror` |
//! | section 5 | O(n log n) | `section::outline::hull` |

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    /// A row of a table above: the place in the paper, its word and the item.
    struct Row {
        paper: usize,
        word: &'static str,
        item: &'static str,
    }

    fn rows() -> Vec<Row> {
        let mut paper = 0;
        let mut rows = Vec::new();
        for line in include_str!("papers.rs").lines().filter_map(|l| l.strip_prefix("//! ")) {
            paper += usize::from(line.starts_with("# "));
            let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
            if let [place, word, item] = cells[..]
                && !place.starts_with("---")
                && place != "in the paper"
            {
                rows.push(Row { paper, word, item: item.trim_matches('`') });
            }
        }
        rows
    }

    /// The file that defines `path`, and the name it defines there; none for a path that is a module itself.
    fn file_of(path: &str) -> Option<(PathBuf, Option<&str>)> {
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
        let file = |path: &str| Some(source.join(path.replace("::", "/") + ".rs")).filter(|f| f.exists());
        if let Some(module) = file(path) {
            return Some((module, None));
        }
        let (module, name) = path.rsplit_once("::")?;
        Some((file(module)?, Some(name)))
    }

    /// The text of a file in lower case, comment marks and line breaks taken out.
    fn words(text: &str) -> String {
        let marks = |l: &str| l.trim().trim_start_matches(['/', '!']).trim().to_lowercase();
        text.lines().map(marks).collect::<Vec<_>>().join(" ").replace(['`', '*'], "")
    }

    #[test]
    fn every_item_exists_and_its_file_has_the_papers_word() {
        for Row { word, item, .. } in rows().iter().filter(|r| r.item != "not built") {
            let (file, name) = file_of(item).unwrap_or_else(|| panic!("there is no module of {item}"));
            let text = std::fs::read_to_string(&file).unwrap();
            if let Some(name) = name {
                let kinds = ["fn", "struct", "enum", "const", "trait"];
                let defined = kinds.iter().any(|kind| {
                    text.match_indices(&format!("{kind} {name}")).any(|(at, found)| {
                        !text[at + found.len()..].starts_with(|c: char| c.is_alphanumeric() || c == '_')
                    })
                });
                assert!(defined, "{} does not define {name}", file.display());
            }
            for word in word.split(", ") {
                let has = words(&text).contains(&word.to_lowercase());
                assert!(has, "a search for \"{word}\" does not find {item} in {}", file.display());
            }
        }
    }

    #[test]
    fn each_paper_has_ten_terms_that_are_built() {
        for paper in 1..=4 {
            let built = rows().iter().filter(|r| r.paper == paper && r.item != "not built").count();
            assert!(built >= 10, "paper {paper} has {built}");
        }
    }
}
