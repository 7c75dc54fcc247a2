//! What pictures look like: the arguments as settings, checked before an input is read.

use std::path::Path;

use lineament::apply::render::{Color, Hidden, Settings, Style, View};
use lineament_io as io;

use crate::args::{HiddenLines, LineColor, PictureStyle, PointColor, Render};
use crate::failure::{Code, Failure};

/// The settings of all pictures.
///
/// # Errors
/// Usage for values out of range, and for those that exclude each other.
pub fn settings(args: &Render) -> Result<Settings, Failure> {
    let usage = |e: lineament::Error| Failure { code: Code::Usage, advice: None, ..Failure::from(e) };
    let (width, height) = args.size;
    let unit = args.unit.map_or(String::new(), |unit| unit.sign().into());
    let settings = Settings {
        views: View::parse_list(&args.view).map_err(usage)?,
        width,
        height,
        caption: !args.no_caption,
        style: match args.style {
            PictureStyle::Shaded => Style::Shaded,
            PictureStyle::Lines => Style::Lines,
        },
        hidden: match args.hidden {
            HiddenLines::None => Hidden::None,
            HiddenLines::Dashed => Hidden::Dashed,
            HiddenLines::Solid => Hidden::Solid,
        },
        color: match args.color {
            Some(LineColor::Confidence) => Color::Confidence,
            Some(LineColor::Ink) => Color::Ink,
            _ => Color::Kind,
        },
        transparent: args.background == "none",
        scale_bar: args.scale_bar.then_some(unit),
        ..Settings::default()
    };
    settings.check().map_err(usage)?;
    check_points(args)?;
    Ok(settings)
}

/// Refuses colours of points where there is no surface that has them.
fn check_points(args: &Render) -> Result<(), Failure> {
    let refuse = |what: &str, advice: &str| {
        let name = args.point_color.map_or("", PointColor::name);
        Err(Failure::new(Code::Usage, format!("--point-color {name}: {what}")).advise(advice))
    };
    match args.point_color {
        None => Ok(()),
        Some(_) if args.style == PictureStyle::Lines || args.output.iter().any(|path| is_svg(path)) => {
            refuse("a line drawing has no points", "write a PNG with `--style shaded`")
        }
        Some(_) if args.surface.as_os_str() != "points" => {
            refuse("the points are not drawn", "leave out --surface")
        }
        Some(_) if args.network.as_os_str() != "computed" => {
            refuse("it is found with the lines", "leave out --network")
        }
        Some(_) => Ok(()),
    }
}

/// What the points are coloured by.
pub fn points(args: &Render) -> Option<PointColor> {
    args.point_color
}

/// Whether the points hide what lies behind them.
pub fn hides(args: &Render) -> bool {
    args.surface.as_os_str() == "points"
}

/// The file of the mesh that is the surface.
pub fn mesh_path(args: &Render) -> Option<&Path> {
    (!["points", "none"].iter().any(|name| args.surface.as_os_str() == *name)).then_some(&args.surface)
}

/// The mesh that is the surface.
///
/// # Errors
/// Those of [`io::read_mesh`].
pub fn mesh(args: &Render) -> Result<Option<io::MeshFile>, Failure> {
    Ok(mesh_path(args).map(io::read_mesh).transpose()?)
}

/// A drawing as vectors.
pub fn is_svg(path: &Path) -> bool {
    path.extension().is_some_and(|e| e.eq_ignore_ascii_case("svg"))
}

/// Accepts `-` and names that end in `.png` or `.svg`.
pub fn known(path: &Path) -> Result<(), Failure> {
    let is_png = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("png"));
    if is_png || is_svg(path) || path.as_os_str() == "-" {
        return Ok(());
    }
    let what = "pictures are written as PNG, and line drawings as SVG too: end the name in `.png` or `.svg`";
    Err(Failure::new(Code::Usage, format!("{}: {what}", path.display())))
}
