//! The table of formats: README and `docs/formats.md` list its rows, and every written format has a reader or a test of its
//! own.

use lineament_io::{
    FORMATS, FileFormat, Format, format_help, graph_format, mesh_format, network_format, patch_format,
    point_format, section_format,
};
use std::collections::BTreeSet;
use std::path::Path;

const README: &str = include_str!("../../../../README.md");
const PAGE: &str = include_str!("../../../../docs/formats.md");

/// Extensions of the formats with a use.
fn extensions(used: impl Fn(&FileFormat) -> bool) -> BTreeSet<&'static str> {
    FORMATS.iter().filter(|f| used(f)).filter_map(|f| f.extensions.first().copied()).collect()
}

/// The words in backticks.
fn quoted(text: &str) -> BTreeSet<&str> {
    text.split('`').skip(1).step_by(2).collect()
}

/// The words in backticks that begin with a dot, without it.
fn dotted(text: &str) -> BTreeSet<&str> {
    quoted(text).into_iter().filter_map(|word| word.strip_prefix('.')).collect()
}

/// The row of the README's table that begins with `head`.
fn readme_row(head: &str) -> &'static str {
    README
        .lines()
        .find(|line| line.starts_with(&format!("| {head}")))
        .unwrap_or_else(|| panic!("no row {head}"))
}

/// The part of the page under a heading.
fn section(heading: &str) -> &'static str {
    let part = PAGE.split("\n## ").find(|part| part.starts_with(heading));
    part.unwrap_or_else(|| panic!("no section {heading}"))
}

/// The cells of the first table of a text, without its head.
fn cells(text: &str) -> Vec<Vec<&str>> {
    let rows = text.lines().filter(|line| line.starts_with('|')).skip(2);
    rows.map(|row| row.trim_matches('|').split(" | ").map(str::trim).collect()).collect()
}

#[test]
fn the_readme_lists_the_formats_of_the_table() {
    assert_eq!(dotted(readme_row("lines, written")), extensions(|f| f.network.is_some()));
    assert_eq!(dotted(readme_row("points, written")), extensions(|f| f.points.is_some()));
    let row = readme_row("points, read");
    for format in FORMATS.iter().filter(|f| f.read.is_some_and(|read| read != Format::Expe)) {
        assert!(row.contains(format.name), "{}", format.name);
    }
}

#[test]
fn the_page_of_formats_lists_every_extension_that_is_read() {
    let mut listed: Vec<&str> = Vec::new();
    for row in cells(section("Clouds")) {
        listed.extend(row[1].split(' '));
    }
    for format in FORMATS.iter().filter(|f| f.read.is_some()) {
        for extension in format.extensions {
            assert!(listed.contains(extension), "{extension}");
        }
    }
    for extension in listed {
        assert!(Format::parse(extension).is_some(), "{extension}");
    }
}

#[test]
fn the_page_of_formats_lists_every_format_that_is_written() {
    let networks: BTreeSet<&str> = cells(section("Networks")).iter().map(|row| row[0]).collect();
    assert_eq!(networks, extensions(|f| f.network.is_some()));
    let points = quoted(section("Points"));
    for extension in extensions(|f| f.points.is_some()) {
        assert!(points.contains(extension), "{extension}");
    }
    let graphs: BTreeSet<&str> = cells(section("Graphs")).iter().map(|row| row[0]).collect();
    assert_eq!(graphs, extensions(|f| f.graph.is_some()));
    let meshes: BTreeSet<&str> = cells(section("Meshes")).iter().map(|row| row[0]).collect();
    assert_eq!(meshes, extensions(|f| f.mesh.is_some()));
}

#[test]
fn names_and_extensions_stand_in_one_row_each() {
    let mut seen = BTreeSet::new();
    for format in FORMATS {
        for name in format.extensions {
            assert_eq!(*name, name.to_ascii_lowercase());
            assert!(seen.insert(*name), "{name} stands twice");
        }
        let used = format.read.is_some()
            || format.network.is_some()
            || format.points.is_some()
            || format.patches.is_some()
            || format.section.is_some()
            || format.graph.is_some()
            || format.mesh.is_some();
        assert!(used, "{} has no use", format.name);
    }
}

#[test]
fn outputs_are_found_by_extension_and_unknown_ones_are_refused_with_the_known() {
    for format in FORMATS {
        let Some(extension) = format.extensions.first() else { continue };
        let name = format!("out.{}", extension.to_ascii_uppercase());
        let path = Path::new(&name);
        assert_eq!(network_format(path).ok(), format.network.map(|(format, _)| format));
        assert_eq!(point_format(path).ok(), format.points.map(|(format, _)| format));
        assert_eq!(patch_format(path).ok(), format.patches.map(|(format, _)| format));
        assert_eq!(section_format(path).ok(), format.section.map(|(format, _)| format));
        assert_eq!(graph_format(path).ok(), format.graph.map(|(format, _)| format));
        assert_eq!(mesh_format(path).ok(), format.mesh.map(|(format, _)| format));
    }
    let message = section_format(Path::new("a.vtp")).unwrap_err().to_string();
    for extension in extensions(|f| f.section.is_some()) {
        assert!(message.contains(&format!(".{extension}")), "{extension} in {message}");
    }
}

#[test]
fn formats_that_hold_the_same_share_a_line_of_help() {
    let help = format_help(|format| format.points);
    assert_eq!(help.lines().count(), 4, "{help}");
    for extension in extensions(|f| f.points.is_some()) {
        assert!(help.contains(&format!(".{extension}")), "{help}");
    }
}
