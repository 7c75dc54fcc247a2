//! Feature lines from point clouds: creases, borders and corners as ordered, closed curves.
//!
//! No parameter needs a guess; [`Params`] lists what can be set.
//!
//! # Lines
//! [`extract()`] is the whole pipeline, and [`Extraction`] keeps every stage of it. [`extract_with`] takes a detector of one's
//! own.
//! ```
//! use lineament::{NodeKind, Params, extract, shapes};
//!
//! // A scan with a known answer: the surface points of a 9 x 9 x 9 grid.
//! let scan = shapes::cube_386();
//! let found = extract(&scan.cloud, &Params::default())?;
//! assert_eq!(found.network.strips.len(), 12);
//! assert_eq!(found.network.count(NodeKind::Junction), 8);
//! for strip in &found.network.strips {
//!     println!("{} of length {:.2}, fold {:?} degrees", strip.kind.name(), strip.length(), strip.fold_deg);
//! }
//! # Ok::<(), lineament::Error>(())
//! ```
//!
//! # Classes of points
//! ```
//! use lineament::{Class, Params, extract, shapes};
//!
//! let found = extract(&shapes::cube_386().cloud, &Params::default())?;
//! let smooth = found.classes().iter().filter(|&&class| class == Class::Smooth).count();
//! assert_eq!(smooth, 6 * 7 * 7);
//! # Ok::<(), lineament::Error>(())
//! ```
//! [`detect::points::mark`] marks points by one measure alone, without lines. [`clean()`] tells points on surfaces from leaves,
//! stray returns and veils.
//!
//! # Patches
//! ```
//! use lineament::params::Auto;
//! use lineament::shapes::{Sampling, Scan, cube};
//! use lineament::{Method, Params, extract};
//!
//! let cloud = cube(10.0).sample(&Scan::new(Sampling::Area { count: 8000 }).seed(1)).cloud;
//! let mut params = Params { method: Method::Segments, ..Params::default() };
//! params.patches.find = Auto::Given(true);
//! let found = extract(&cloud, &params)?;
//! let patches = found.patches.unwrap();
//! assert_eq!((patches.patches.len(), patches.separating()), (6, 12));
//! # Ok::<(), lineament::Error>(())
//! ```
//!
//! # Sections
//! ```
//! use lineament::section::{Axis, Planes, SectionParams, section};
//! use lineament::shapes::{Sampling, Scan, cube};
//!
//! let cloud = cube(2.0).sample(&Scan::new(Sampling::Area { count: 5000 }).seed(1)).cloud;
//! let params = SectionParams { axis: Axis::Coordinate(2), planes: Planes::Count(3), ..SectionParams::default() };
//! let sections = section(&cloud, &params)?;
//! assert_eq!(sections.contours().filter(|(_, contour)| contour.closed).count(), 3);
//! # Ok::<(), lineament::Error>(())
//! ```
//!
//! # Pictures
//! ```
//! use lineament::apply::render::{Scene, Settings, View, render, surfels};
//!
//! let cloud = lineament::shapes::cube_386().cloud;
//! let (surfels, spacing) = surfels(&cloud)?;
//! let scene = Scene { surfels: &surfels, spacing, ..Scene::default() };
//! let settings = Settings { views: vec![View::Best], width: 160, height: 120, ..Settings::default() };
//! assert_eq!(render(&scene, &settings)?.rgb.len(), 3 * 160 * 120);
//! # Ok::<(), lineament::Error>(())
//! ```
//!
//! [`shapes`] makes scans with known networks, [`check`] says whether a network is sound, and [`evaluate`] scores it.
//! [`papers`] leads from the terms of the papers to the code.

pub mod apply;
pub mod check;
mod classify;
mod clean;
mod cloud;
pub mod curve;
pub mod delaunay;
pub mod detect;
mod error;
pub mod evaluate;
mod extract;
mod frame;
pub mod inspect;
mod link;
pub mod math;
mod measure;
pub mod mesh;
mod method;
pub mod neighbors;
mod network;
pub mod papers;
mod parallel;
pub mod params;
pub mod patch;
mod pattern;
mod prepare;
mod reach;
mod recover;
pub mod relation;
mod report;
mod resolution;
pub mod section;
pub mod shapes;
mod stages;
pub mod surface;
pub mod tile;

pub use clean::{Cleaned, clean, clean_observed};
pub use cloud::{Attribute, Cloud, Column};
pub use detect::segments::{Segmentation, Segmented};
pub use error::Error;
pub use extract::{Extraction, extract, extract_observed, extract_sampled, extract_staged, extract_with};
pub use frame::{Frame, Localised};
pub use link::clusters::GraphStage;
pub use link::{LineSteps, WeighedEdge};
pub use math::eigen3::Eigen3;
pub use math::tensor::Ellipsoid;
pub use measure::{Class, Direction, Evidence, Measure, Penalties, Row};
pub use method::ClusterStages;
pub use neighbors::Neighbors;
pub use network::{Blend, Network, Node, NodeKind, Strip, StripKind};
pub use params::{Entry, Method, Params};
pub use patch::{Patch, Patches};
pub use pattern::{LineGraph, Pattern};
pub use recover::{Grouped, RecoveredPlace, Recovery};
pub use relation::{Regularised, Related, Relation, RelationKind};
pub use report::{Progress, Report, Stage};
pub use resolution::Resolution;
pub use stages::Stages;
