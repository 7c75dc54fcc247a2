//! A small reader of STEP for these tests: instances with their parameters, and points along their curves.

use lineament::curve::BSpline;
use std::collections::BTreeMap;

pub type Point = [f64; 3];

/// A parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    Instance(usize),
    Number(f64),
    Text(String),
    /// `.T.`, `.MILLI.`, `$` or `*`.
    Word(String),
    List(Vec<Value>),
    Typed(String, Vec<Value>),
}

/// The instances of a file, complex ones as the list of their parts; and its header.
pub struct File {
    pub header: String,
    pub instances: BTreeMap<usize, Vec<(String, Vec<Value>)>>,
}

struct Reader<'a>(&'a str);

impl Reader<'_> {
    fn take(&mut self, token: &str) -> bool {
        let rest = self.0.strip_prefix(token);
        self.0 = rest.unwrap_or(self.0);
        rest.is_some()
    }

    fn word(&mut self) -> String {
        let end = self.0.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap();
        let (word, rest) = self.0.split_at(end);
        self.0 = rest;
        word.into()
    }

    fn list(&mut self) -> Vec<Value> {
        assert!(self.take("("), "{}", &self.0[..20]);
        let mut values = Vec::new();
        while !self.take(")") {
            values.push(self.value());
            self.take(",");
        }
        values
    }

    fn value(&mut self) -> Value {
        match self.0.as_bytes()[0] {
            b'(' => Value::List(self.list()),
            b'#' => {
                self.take("#");
                Value::Instance(self.word().parse().unwrap())
            }
            b'\'' => {
                let doubled = self.0.replacen("\'\'", "  ", self.0.len());
                let end = if self.0.starts_with("\'\'") { 1 } else { 1 + doubled[1..].find('\'').unwrap() };
                let text = self.0[1..end].into();
                self.0 = &self.0[end + 1..];
                Value::Text(text)
            }
            b'.' => {
                let end = 1 + self.0[1..].find('.').unwrap();
                let text = self.0[1..end].into();
                self.0 = &self.0[end + 1..];
                Value::Word(text)
            }
            b'$' | b'*' => {
                let text = self.0[..1].into();
                self.0 = &self.0[1..];
                Value::Word(text)
            }
            b'A'..=b'Z' => {
                let name = self.word();
                Value::Typed(name, self.list())
            }
            _ => {
                let end = self.0.find([',', ')']).unwrap();
                let (text, rest) = self.0.split_at(end);
                assert!(!text.contains('e') && (text.contains('.') || text.parse::<i64>().is_ok()), "{text}");
                self.0 = rest;
                Value::Number(text.parse().unwrap())
            }
        }
    }
}

impl File {
    pub fn parse(text: &str) -> File {
        let (header, data) = text.split_once("DATA;\n").unwrap();
        assert!(header.starts_with("ISO-10303-21;\nHEADER;\n") && text.is_ascii());
        let data = data.strip_suffix("ENDSEC;\nEND-ISO-10303-21;\n").unwrap();
        let mut instances = BTreeMap::new();
        for line in data.lines() {
            let (id, rest) = line.strip_prefix('#').unwrap().split_once('=').unwrap();
            let mut reader = Reader(rest);
            let mut parts = Vec::new();
            let complex = reader.take("(");
            while !(complex && reader.take(")") || reader.take(";")) {
                parts.push((reader.word(), reader.list()));
            }
            assert!(instances.insert(id.parse().unwrap(), parts).is_none(), "{id} stands twice");
        }
        let file = File { header: header.into(), instances };
        file.check_references();
        file
    }

    /// Every instance that is named stands before, so that there is no circle.
    fn check_references(&self) {
        fn named(value: &Value, take: &mut dyn FnMut(usize)) {
            match value {
                Value::Instance(id) => take(*id),
                Value::List(values) | Value::Typed(_, values) => values.iter().for_each(|v| named(v, take)),
                _ => {}
            }
        }
        for (id, parts) in &self.instances {
            for value in parts.iter().flat_map(|p| &p.1) {
                named(value, &mut |other| assert!(other < *id && other > 0, "#{id} names #{other}"));
            }
        }
    }

    /// The parameters of a simple instance.
    pub fn of(&self, id: usize) -> (&str, &[Value]) {
        let [(name, values)] = &self.instances[&id][..] else { panic!("#{id} is complex") };
        (name, values)
    }

    pub fn all(&self, keyword: &str) -> Vec<&[Value]> {
        let parts = self.instances.values().flatten().filter(|p| p.0 == keyword);
        parts.map(|p| p.1.as_slice()).collect()
    }

    pub fn id(value: &Value) -> usize {
        let Value::Instance(id) = value else { panic!("{value:?}") };
        *id
    }

    pub fn ids(value: &Value) -> Vec<usize> {
        let Value::List(values) = value else { panic!("{value:?}") };
        values.iter().map(File::id).collect()
    }

    pub fn number(value: &Value) -> f64 {
        match value {
            Value::Number(x) => *x,
            Value::List(values) | Value::Typed(_, values) => File::number(&values[0]),
            _ => panic!("{value:?}"),
        }
    }

    /// A point or a direction.
    pub fn triple(&self, value: &Value) -> Point {
        let Value::List(numbers) = &self.of(File::id(value)).1[1] else { panic!("{value:?}") };
        [0, 1, 2].map(|k| File::number(&numbers[k]))
    }

    /// The type of a curve, and points along it from end to end.
    pub fn along(&self, id: usize) -> (&str, Vec<Point>) {
        let (name, values) = self.of(id);
        let number = |k: usize| File::number(&values[k]);
        if name == "TRIMMED_CURVE" {
            let basis = File::id(&values[1]);
            return (self.of(basis).0, self.points(basis, [number(2), number(3)]));
        }
        let range = match name {
            "B_SPLINE_CURVE_WITH_KNOTS" => {
                let Value::List(knots) = &values[7] else { panic!() };
                [File::number(&knots[0]), File::number(&knots[knots.len() - 1])]
            }
            _ => [0.0, std::f64::consts::TAU],
        };
        (name, self.points(id, range))
    }

    fn points(&self, id: usize, [from, to]: [f64; 2]) -> Vec<Point> {
        let (name, values) = self.of(id);
        if name == "POLYLINE" {
            let Value::List(points) = &values[1] else { panic!() };
            return points.iter().map(|p| self.triple(p)).collect();
        }
        let at: Box<dyn Fn(f64) -> Point + '_> = match name {
            "LINE" => {
                let start = self.triple(&values[1]);
                let vector = self.of(File::id(&values[2])).1;
                let along = self.triple(&vector[1]).map(|x| x * File::number(&vector[2]));
                Box::new(move |t| [0, 1, 2].map(|k| start[k] + t * along[k]))
            }
            "CIRCLE" => {
                let [centre, z, x] = self.axes(File::id(&values[1]));
                let y = cross(z, x);
                let r = File::number(&values[2]);
                Box::new(move |t| [0, 1, 2].map(|k| centre[k] + r * (t.cos() * x[k] + t.sin() * y[k])))
            }
            "ELLIPSE" => {
                let [centre, z, x] = self.axes(File::id(&values[1]));
                let y = cross(z, x);
                let (a, b) = (File::number(&values[2]), File::number(&values[3]));
                Box::new(move |t| [0, 1, 2].map(|k| centre[k] + a * t.cos() * x[k] + b * t.sin() * y[k]))
            }
            _ => {
                let curve = self.spline(values);
                Box::new(move |t| curve.point(t))
            }
        };
        (0..=32).map(|k| at(from + (to - from) * f64::from(k) / 32.0)).collect()
    }

    /// The location, the axis and the first direction of a placement.
    pub fn axes(&self, id: usize) -> [Point; 3] {
        let (name, values) = self.of(id);
        assert_eq!(name, "AXIS2_PLACEMENT_3D");
        [1, 2, 3].map(|k| self.triple(&values[k]))
    }

    fn spline(&self, values: &[Value]) -> BSpline {
        let list = |k: usize| match &values[k] {
            Value::List(values) => values,
            other => panic!("{other:?}"),
        };
        let knots = list(6).iter().zip(list(7));
        let knots = knots.flat_map(|(n, k)| vec![File::number(k); File::number(n) as usize]).collect();
        let controls: Vec<Point> = list(2).iter().map(|p| self.triple(p)).collect();
        let curve = BSpline { degree: File::number(&values[1]) as usize, knots, controls, periodic: false };
        assert_eq!(curve.knots.len(), curve.controls.len() + curve.degree + 1);
        curve
    }
}

fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
