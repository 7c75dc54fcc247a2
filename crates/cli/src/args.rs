//! The command line as typed, one file for each command. Checks that need more than the text come later.

mod apply;
mod classify;
mod clean;
mod completions;
mod evaluate;
mod extract;
mod groups;
mod info;
mod man;
mod params;
mod parse;
mod patches;
mod render;
mod report;
mod section;
mod slices;

pub use apply::{Enrich, Graph, Mesh};
pub use classify::Classify;
pub use clean::Clean;
pub use completions::Completions;
pub use evaluate::Evaluate;
pub use extract::Extract;
pub use groups::{Reading, Running, Settings, Source, Tuning, Work};
pub use info::Info;
pub use man::Man;
pub use params::Params;
pub use patches::Patches;
pub use render::{HiddenLines, LineColor, PictureStyle, PointColor, Render};
pub use report::Report;
pub use section::{Section, Slicing};
pub use slices::Slices;

use clap::{Parser, Subcommand};

const HELP: &str = "\
Examples:
  lineament extract --sample bracket -o bracket.html    lines of a generated scan in a browser, to try it out
  lineament extract part.ply                            writes part.lines.json and part.lines.obj
  lineament extract part.ply -o part.dxf -o part.json   several formats, by extension
  lineament report part.ply                             part.html: scan, lines and patches in a browser
  lineament render part.ply -o part.png                 a picture of scan and lines
  lineament evaluate part.lines.json --truth part.dxf   figures against known lines
  lineament params > tuning.toml                        every parameter, with its meaning

`lineament help COMMAND` begins with examples of the command.

Exit codes:
  0    everything asked for was done
  1    of several inputs one or more failed, the others have their results
  2    the command line does not make sense
  3    an input cannot be read, or is malformed
  4    refused: a parameter is out of range, or the points have no surface
  5    an output could not be written
  130  interrupted; no file is left half-written";

/// Feature lines from point clouds: creases, borders and corners as ordered curves.
///
/// Reads a scan of a surface and writes the lines where faces meet (creases) and where the surface ends (borders),
/// joined in junctions and corners. No parameter needs to be set.
#[derive(Debug, Parser)]
#[command(name = "lineament", version, after_long_help = HELP, max_term_width = 110)]
pub struct Args {
    #[command(subcommand)]
    pub command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Find the feature lines of a scan and write them as curves
    #[command(long_about = extract::ABOUT)]
    Extract(Extract),
    /// Classify each point: 0 smooth, 1 crease, 2 border, 3 corner, 4 clutter
    #[command(long_about = classify::ABOUT)]
    Classify(Classify),
    /// Leave out the points that lie on no surface
    #[command(long_about = clean::ABOUT)]
    Clean(Clean),
    /// Divide a scan into its smooth patches and write their points, boundary loops and surfaces
    #[command(long_about = patches::ABOUT)]
    Patches(Patches),
    /// Write the neighbour graph of a scan without the edges that cross a crease
    #[command(long_about = apply::GRAPH)]
    Graph(Graph),
    /// Add points along the creases and borders of a scan, and at its corners
    #[command(long_about = apply::ENRICH)]
    Enrich(Enrich),
    /// Make a mesh of a scan whose edges follow its creases
    #[command(long_about = apply::MESH)]
    Mesh(Mesh),
    /// Draw a scan and its lines as a PNG picture, or the lines alone as SVG
    #[command(long_about = render::ABOUT)]
    Render(Render),
    /// Write a report of a scan and its lines that a browser opens
    #[command(long_about = report::ABOUT)]
    Report(Report),
    /// Cut a scan by planes and write the curves in which they meet its surface
    #[command(long_about = section::ABOUT)]
    Section(Section),
    /// Cut a scan by planes and write a picture of each slice
    #[command(long_about = slices::ABOUT)]
    Slices(Slices),
    /// Score lines against known ones, or compare two results
    #[command(long_about = evaluate::ABOUT)]
    Evaluate(Evaluate),
    /// Describe the content of a scan file
    #[command(long_about = info::ABOUT)]
    Info(Info),
    /// Print every parameter as a commented TOML file
    #[command(long_about = params::ABOUT)]
    Params(Params),
    /// Print a completion script for a shell
    #[command(long_about = completions::ABOUT)]
    Completions(Completions),
    /// Write the manual pages into a folder
    #[command(hide = true)]
    Man(Man),
}

/// An error of the command line, with the commands that take a file where a file stands in place of a command.
pub fn explained(error: clap::Error) -> clap::Error {
    use clap::error::{ContextKind, ContextValue, ErrorKind};
    let Some(ContextValue::String(word)) = error.get(ContextKind::InvalidSubcommand) else { return error };
    let path = std::path::Path::new(word);
    if error.kind() != ErrorKind::InvalidSubcommand || path.extension().is_none() && !path.exists() {
        return error;
    }
    let message = format!(
        "`{word}` is no command: `lineament extract {word}` finds its lines, `lineament section {word} -o OUT` cuts it, \
         `lineament info {word}` tells what it holds"
    );
    <Args as clap::CommandFactory>::command()
        .error(ErrorKind::InvalidSubcommand, crate::failure::shown(&message))
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Args::command().debug_assert();
    }
}
