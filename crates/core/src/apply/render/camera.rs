//! Orthographic projection of the world to the picture.

use crate::error::Error;
use crate::math::vec3::{add, add_scaled, cross, dot, norm, scale, sub, unit};

/// The direction of view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum View {
    /// The oblique direction that shows most line and surface.
    Best,
    /// Seen from this world direction: a vector from the object towards the eye, of any length but zero.
    From([f64; 3]),
}

impl View {
    /// Reads a list of views with commas between them, as [`View::parse`] reads each; three numbers in a row are a vector.
    ///
    /// # Errors
    /// As [`View::parse`].
    pub fn parse_list(text: &str) -> Result<Vec<Self>, Error> {
        let words: Vec<&str> = text.split(',').map(str::trim).collect();
        let mut views = Vec::new();
        let mut at = 0;
        while at < words.len() {
            let count = if words[at].parse::<f64>().is_ok() { 3 } else { 1 };
            views.push(View::parse(&words[at..words.len().min(at + count)].join(","))?);
            at += count;
        }
        Ok(views)
    }

    /// The name of a view as [`View::parse`] reads it; of a direction without one its numbers.
    pub fn name(&self) -> String {
        match self {
            View::Best => "auto".into(),
            View::From(from) => NAMED
                .iter()
                .find(|(_, named)| named == from)
                .map_or_else(|| from.map(|x| x.to_string()).join(","), |(name, _)| name.to_string()),
        }
    }

    /// Reads `auto`, `top`, `bottom`, `front`, `back`, `left`, `right`, `iso` or `X,Y,Z`, the vector towards the eye.
    /// The named ones take z as up and look along +y from the front.
    ///
    /// # Errors
    /// [`Error::Parameter`] with the text if it is none of these, or the vector has no direction.
    pub fn parse(text: &str) -> Result<Self, Error> {
        if text == "auto" {
            return Ok(View::Best);
        }
        let named = NAMED.iter().find(|(name, _)| *name == text).map(|(_, from)| *from);
        let from = named.or_else(|| parse_vector(text)).ok_or_else(|| Error::Parameter {
            key: "view".into(),
            value: text.into(),
            expected: "auto, top, bottom, front, back, left, right, iso, or a direction X,Y,Z towards the eye, such as 1,-2,1"
                .into(),
        })?;
        Ok(View::From(from))
    }
}

/// The directions that have names.
const NAMED: [(&str, [f64; 3]); 7] = [
    ("top", [0.0, 0.0, 1.0]),
    ("bottom", [0.0, 0.0, -1.0]),
    ("front", [0.0, -1.0, 0.0]),
    ("back", [0.0, 1.0, 0.0]),
    ("left", [-1.0, 0.0, 0.0]),
    ("right", [1.0, 0.0, 0.0]),
    ("iso", [1.0, -1.0, 1.0]),
];

fn parse_vector(text: &str) -> Option<[f64; 3]> {
    let values: Vec<f64> = text.split(',').map(|t| t.trim().parse().ok()).collect::<Option<_>>()?;
    let vector: [f64; 3] = values.try_into().ok()?;
    let length = norm(vector);
    (length.is_finite() && length > 0.0).then_some(vector)
}

/// An orthonormal frame of the picture: right, up, and towards the eye.
#[derive(Clone, Copy, Debug)]
pub(super) struct Camera {
    axes: [[f64; 3]; 3],
    center: [f64; 3],
    /// Pixels for each world unit.
    pub scale: f64,
    middle: [f64; 2],
}

impl Camera {
    /// A camera that looks from `from` with `up` upwards, not yet fitted: one pixel for each unit, the origin in the corner.
    pub fn looking(from: [f64; 3], up: [f64; 3]) -> Self {
        let toward = unit(from);
        let mut right = cross(unit(up), toward);
        for spare in [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]] {
            if norm(right) > 1e-6 {
                break;
            }
            right = cross(spare, toward);
        }
        let right = unit(right);
        Self { axes: [right, cross(toward, right), toward], center: [0.0; 3], scale: 1.0, middle: [0.0; 2] }
    }

    /// The same camera, moved and scaled so that all `points` lie inside `width` x `height` less `margin` on each side.
    pub fn fitted(
        self,
        points: impl Iterator<Item = [f64; 3]>,
        width: f64,
        height: f64,
        margin: f64,
    ) -> Self {
        let mut bounds = Bounds::default();
        points.for_each(|p| bounds.include(self.rotate(p)));
        let [w, h, _] = bounds.extent();
        let scale_to = |room: f64, extent: f64| {
            if extent > 0.0 { (room - 2.0 * margin).max(1.0) / extent } else { f64::INFINITY }
        };
        let scale = scale_to(width, w).min(scale_to(height, h));
        let middle = bounds.middle();
        let center = (0..3).fold([0.0; 3], |sum, i| add_scaled(sum, self.axes[i], middle[i]));
        let scale = if scale.is_finite() && scale > 0.0 { scale } else { 1.0 };
        Self { center, scale, middle: [0.5 * width, 0.5 * height], ..self }
    }

    /// The position on the picture in pixels, y down, and the depth in pixels, greater nearer to the eye.
    pub fn project(&self, point: [f64; 3]) -> [f32; 3] {
        let [x, y, z] = scale(self.rotate(sub(point, self.center)), self.scale);
        [(self.middle[0] + x) as f32, (self.middle[1] - y) as f32, z as f32]
    }

    /// A line on the picture, closed if it is.
    pub fn line(&self, points: &[[f64; 3]], closed: bool) -> Vec<[f32; 3]> {
        let closing = points.first().filter(|_| closed);
        points.iter().chain(closing).map(|&p| self.project(p)).collect()
    }

    /// The world directions of right, up and towards the eye.
    pub fn axes(&self) -> [[f64; 3]; 3] {
        self.axes
    }

    /// A world vector in the frame of the picture: right, up, towards the eye.
    pub fn rotate(&self, vector: [f64; 3]) -> [f64; 3] {
        self.axes.map(|axis| dot(axis, vector))
    }
}

/// An axis-aligned box that grows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    min: [f64; 3],
    max: [f64; 3],
}

impl Default for Bounds {
    fn default() -> Self {
        Self { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] }
    }
}

impl Bounds {
    /// Grows to hold `point`.
    pub fn include(&mut self, point: [f64; 3]) {
        for (i, x) in point.into_iter().enumerate() {
            self.min[i] = self.min[i].min(x);
            self.max[i] = self.max[i].max(x);
        }
    }

    /// Sides of the box; zero while it is empty.
    pub fn extent(&self) -> [f64; 3] {
        if self.min[0] > self.max[0] { [0.0; 3] } else { sub(self.max, self.min) }
    }

    /// Middle of the box; the origin while it is empty.
    pub fn middle(&self) -> [f64; 3] {
        if self.min[0] > self.max[0] { [0.0; 3] } else { add(scale(self.min, 0.5), scale(self.max, 0.5)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn front_view_has_x_to_the_right_and_z_up() {
        let camera = Camera::looking([0.0, -1.0, 0.0], [0.0, 0.0, 1.0]);
        assert_eq!(camera.rotate([1.0, 0.0, 0.0]), [1.0, 0.0, 0.0]);
        assert_eq!(camera.rotate([0.0, 0.0, 1.0]), [0.0, 1.0, 0.0]);
        assert_eq!(camera.rotate([0.0, -1.0, 0.0]), [0.0, 0.0, 1.0]);
    }

    #[test]
    fn top_view_has_y_up_though_up_is_along_the_eye() {
        let camera = Camera::looking([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
        assert_eq!(camera.rotate([1.0, 0.0, 0.0]), [1.0, 0.0, 0.0]);
        assert_eq!(camera.rotate([0.0, 1.0, 0.0]), [0.0, 1.0, 0.0]);
    }

    #[test]
    fn fitted_points_lie_inside_the_margin_and_touch_it() {
        let points = [[1e7, -3.0, 0.0], [1e7 + 8.0, 1.0, 5.0], [1e7 + 2.0, 0.0, -5.0]];
        let camera = Camera::looking([1.0, -1.0, 1.0], [0.0, 0.0, 1.0]);
        let camera = camera.fitted(points.into_iter(), 400.0, 300.0, 20.0);
        let seen = points.map(|p| camera.project(p));
        let least = seen.iter().map(|p| (p[0] - 20.0).min(380.0 - p[0]).min(p[1] - 20.0).min(280.0 - p[1]));
        assert!(least.fold(f32::INFINITY, f32::min).abs() < 1e-2);
    }

    #[test]
    fn lists_hold_names_and_vectors() {
        let views = View::parse_list("top, 1,-2,1,auto").unwrap();
        let views: [View; 3] = views.try_into().unwrap();
        let expected = [View::From([0.0, 0.0, 1.0]), View::From([1.0, -2.0, 1.0]), View::Best];
        assert_eq!(views, expected);
        assert_eq!(views.map(|v| v.name()), ["top", "1,-2,1", "auto"]);
        for bad in ["", "top,", "1,2,top", "top,1,2"] {
            assert!(View::parse_list(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn views_are_read_by_name_and_by_vector() {
        assert_eq!(View::parse("auto"), Ok(View::Best));
        assert_eq!(View::parse("1, -2,0.5"), Ok(View::From([1.0, -2.0, 0.5])));
        for bad in ["", "up", "1,2", "0,0,0", "nan,0,1", "inf,0,0", "1,2,3,4"] {
            assert!(View::parse(bad).is_err(), "{bad}");
        }
    }
}
