//! DXF, release 2000 (AC1015): the first one with splines and light polylines, and a unit of length. A [`Drawing`] is layers and
//! entities; the tables, blocks and objects around them are those that the release requires (`frame`). Group codes, object
//! coordinates and the arbitrary axis algorithm are those of the AutoCAD DXF reference.

mod bounds;
mod entity;
mod frame;
mod group;
mod plane;

use crate::unit::Unit;
use group::{Groups, Handles};
use lineament::curve::{BSpline, Ellipse};
use std::borrow::Cow;
use std::io::{self, Write};

pub(in crate::write) use plane::Bend;

/// A layer: its name and its colour (AutoCAD colour index).
pub(in crate::write) type Layer = (String, u8);

/// A curve, a point or a text in space, world frame.
pub(in crate::write) enum Shape<'a> {
    /// POINT.
    Point([f64; 3]),
    /// LINE.
    Line([[f64; 3]; 2]),
    /// ARC about a normal, counter-clockwise from the first end to the second.
    Arc { centre: [f64; 3], radius: f64, normal: [f64; 3], ends: [[f64; 3]; 2] },
    /// CIRCLE about a normal.
    Circle { centre: [f64; 3], radius: f64, normal: [f64; 3] },
    /// ELLIPSE, from a point of it counter-clockwise about its normal over a part of its parameter, radians.
    Ellipse { ellipse: Ellipse, from: [f64; 3], sweep: f64 },
    /// SPLINE.
    Spline(&'a BSpline),
    /// POLYLINE in space. A closed one does not repeat its first point.
    Polyline { points: Cow<'a, [[f64; 3]]>, closed: bool },
    /// LWPOLYLINE in the plane across a normal: straight segments and arcs.
    Flat { bends: Vec<Bend>, closed: bool, normal: [f64; 3] },
    /// TEXT of this letter height in the plane across a normal.
    Text { at: [f64; 3], height: f64, text: String, normal: [f64; 3] },
}

/// What a file shows.
pub(in crate::write) struct Drawing<'a> {
    /// The unit of the coordinates, if it is known.
    pub unit: Option<Unit>,
    /// The layers beside layer 0, which every drawing has.
    pub layers: Vec<Layer>,
    /// Each entity with the index of its layer.
    pub entities: Vec<(usize, Shape<'a>)>,
}

impl Drawing<'_> {
    /// Writes the file.
    ///
    /// # Errors
    /// Those of the stream.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let taken = self.layers.len() + self.entities.iter().map(|(_, shape)| shape.handles()).sum::<usize>();
        let extent = bounds::extent(&self.entities);
        let mut handles = Handles::default();
        let mut groups = Groups::new(out);
        frame::header(&mut groups, self.unit, extent, handles.after(taken))?;
        frame::tables(&mut groups, &self.layers, extent, &mut handles)?;
        for (layer, shape) in &self.entities {
            shape.write(&mut groups, &self.layers[*layer].0, &mut handles)?;
        }
        frame::objects(&mut groups)
    }
}
