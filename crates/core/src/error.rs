//! The errors of the library.

use thiserror::Error;

/// Everything that can keep the library from giving a result. Each variant carries the offending value.
#[derive(Debug, Error, Clone, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A parameter is unknown or outside its range.
    #[error("parameter `{key}` = `{value}`: {expected}")]
    Parameter {
        /// The full key, such as `spanning.rho`.
        key: String,
        /// The value as it was given.
        value: String,
        /// The values that are accepted.
        expected: String,
    },
    /// Too few distinct, finite points for any surface.
    #[error("{distinct} distinct finite points of {read} read: a surface needs at least {needed}")]
    TooFewPoints {
        /// Points given.
        read: usize,
        /// Points that remain after non-finite ones are dropped and exact duplicates merged.
        distinct: usize,
        /// The least number that can lie on a surface.
        needed: usize,
    },
    /// All points lie on one straight line, to rounding.
    #[error("all {distinct} distinct points lie on one straight line: there is no surface to find lines on")]
    Collinear {
        /// Distinct finite points.
        distinct: usize,
    },
    /// A point lies beyond the bounds that were given for the cloud.
    #[error("{value} on axis {axis} lies beyond the bounds {min} to {max} given for the cloud")]
    OutOfBounds {
        /// 0 for x, 1 for y, 2 for z.
        axis: usize,
        /// The coordinate.
        value: f64,
        /// Least coordinate of the bounds on the axis.
        min: f64,
        /// Greatest coordinate of the bounds on the axis.
        max: f64,
    },
    /// The points of a cloud that is read in parts cannot be read.
    #[error("the points cannot be read: {fault}")]
    Points {
        /// What the source says.
        fault: String,
    },
    /// A detector's measure does not match the points.
    #[error("the measure of the detector: {fault}")]
    Measure {
        /// The column and its length, or the candidate at fault.
        fault: String,
    },
    /// More points than the 32-bit point index can number.
    #[error("{read} points are more than the {limit} that one cloud can hold: split it into tiles")]
    TooManyPoints {
        /// Points given.
        read: usize,
        /// The greatest number possible.
        limit: usize,
    },
    /// Coordinates so far apart, or so close together, that squares of their differences leave the range of f64.
    #[error(
        "coordinates span from {min:e} to {max:e} on axis {axis}: squares of such lengths leave the range of f64: scale the cloud"
    )]
    Extent {
        /// 0 for x, 1 for y, 2 for z.
        axis: usize,
        /// Least coordinate on the axis.
        min: f64,
        /// Greatest coordinate on the axis.
        max: f64,
    },
}
