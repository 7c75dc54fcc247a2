//! A small reader of DXF for these tests: groups, and entities in world coordinates.

use std::collections::{BTreeMap, BTreeSet};

pub type Point = [f64; 3];

/// A drawing as it was written.
pub struct Drawing {
    pub groups: Vec<(u16, String)>,
    pub entities: Vec<Entity>,
}

/// An entity: its kind, layer and other groups.
#[derive(Debug)]
pub struct Entity {
    pub kind: String,
    pub layer: String,
    groups: Vec<(u16, String)>,
}

impl Drawing {
    pub fn parse(text: &str) -> Drawing {
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines.len().is_multiple_of(2));
        let group = |pair: &[&str]| (pair[0].parse().unwrap(), pair[1].to_string());
        let groups: Vec<(u16, String)> = lines.chunks(2).map(group).collect();
        assert_eq!(groups.last(), Some(&(0, "EOF".into())));
        let at = |name: &str| groups.iter().position(|g| *g == (2, name.into())).unwrap();
        let inside = &groups[at("ENTITIES") + 1..at("OBJECTS") - 2];
        let entities = inside.chunk_by(|_, b| b.0 != 0).map(|own| Entity {
            kind: own[0].1.clone(),
            layer: own.iter().find(|g| g.0 == 8).unwrap().1.clone(),
            groups: own[1..].to_vec(),
        });
        Drawing { entities: entities.collect(), groups: groups.clone() }
    }

    /// The groups of a variable of the header.
    pub fn variable(&self, name: &str) -> Option<Vec<(u16, &str)>> {
        let at = self.groups.iter().position(|g| *g == (9, name.into()))?;
        let rest = self.groups[at + 1..].iter().take_while(|g| g.0 != 9 && g.0 != 0);
        Some(rest.map(|(code, value)| (*code, value.as_str())).collect())
    }

    pub fn corner(&self, name: &str) -> Point {
        let values: Vec<f64> =
            self.variable(name).unwrap().iter().map(|(_, value)| value.parse().unwrap()).collect();
        values.try_into().unwrap()
    }

    pub fn of_kind(&self, kind: &str) -> Vec<&Entity> {
        self.entities.iter().filter(|e| e.kind == kind).collect()
    }

    /// Every handle once, the seed beyond all of them, and no pointer to what is not there.
    pub fn check_handles(&self) {
        let number = |text: &str| u64::from_str_radix(text, 16).unwrap();
        let header = self.groups.iter().position(|g| *g == (0, "ENDSEC".into())).unwrap();
        let mut own = BTreeSet::new();
        for (_, text) in self.groups[header..].iter().filter(|g| [5, 105].contains(&g.0)) {
            assert!(own.insert(number(text)), "{text} stands twice");
        }
        let seed = number(self.variable("$HANDSEED").unwrap()[0].1);
        assert!(own.iter().all(|&handle| handle < seed), "{seed:X}");
        let pointers = self.groups.iter().filter(|g| [330, 340, 350, 390].contains(&g.0));
        for handle in pointers.map(|g| number(&g.1)) {
            assert!(handle == 0 || own.contains(&handle), "nothing is {handle:X}");
        }
    }

    /// Tables with the number of entries that each states, and those that it has.
    pub fn tables(&self) -> BTreeMap<String, [usize; 2]> {
        let mut found = BTreeMap::new();
        for (i, _) in self.groups.iter().enumerate().filter(|(_, g)| **g == (0, "TABLE".into())) {
            let rest = &self.groups[i + 1..];
            let name = &rest[0].1;
            let end = rest.iter().position(|g| *g == (0, "ENDTAB".into())).unwrap();
            let stated = rest.iter().find(|g| g.0 == 70).unwrap().1.parse().unwrap();
            let has = rest[..end].iter().filter(|g| *g == &(0, name.clone())).count();
            found.insert(name.clone(), [stated, has]);
        }
        found
    }
}

impl Entity {
    pub fn reals(&self, code: u16) -> Vec<f64> {
        self.groups.iter().filter(|g| g.0 == code).map(|g| g.1.parse().unwrap()).collect()
    }

    pub fn real(&self, code: u16) -> f64 {
        let found = self.reals(code);
        assert_eq!(found.len(), 1, "{code} in {self:?}");
        found[0]
    }

    /// Positions in groups from `code` on, as they stand.
    pub fn places(&self, code: u16) -> Vec<Point> {
        let [x, y, z] = [0, 10, 20].map(|step| self.reals(code + step));
        (0..x.len()).map(|i| [x[i], y[i], z[i]]).collect()
    }

    pub fn place(&self, code: u16) -> Point {
        self.places(code)[0]
    }

    /// World coordinates of object coordinates.
    pub fn world(&self, [x, y, z]: Point) -> Point {
        let n = self.place(210);
        let small = n[0].abs() < 1.0 / 64.0 && n[1].abs() < 1.0 / 64.0;
        let ax = unit(cross(if small { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] }, n));
        let ay = unit(cross(n, ax));
        [0, 1, 2].map(|k| x * ax[k] + y * ay[k] + z * n[k])
    }

    /// The point of a circle or an arc at an angle in degrees.
    pub fn on_circle(&self, degrees: f64) -> Point {
        let ([x, y, z], r) = (self.place(10), self.real(40));
        let (sin, cos) = degrees.to_radians().sin_cos();
        self.world([x + r * cos, y + r * sin, z])
    }

    /// Vertices of a polyline in a plane, and the bulge after each.
    pub fn bends(&self) -> Vec<(Point, f64)> {
        let elevation = self.real(38);
        let mut found: Vec<(Point, f64)> = Vec::new();
        for (code, value) in &self.groups {
            let number = || value.parse().unwrap();
            match (code, found.last_mut()) {
                (10, _) => found.push(([number(), 0.0, elevation], 0.0)),
                (20, Some((at, _))) => at[1] = number(),
                (42, Some((_, bulge))) => *bulge = number(),
                _ => {}
            }
        }
        found.into_iter().map(|(at, bulge)| (self.world(at), bulge)).collect()
    }
}

fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: Point) -> Point {
    let norm = a.iter().map(|x| x * x).sum::<f64>().sqrt();
    a.map(|x| x / norm)
}

/// Whether two points are the same to 1e-6.
pub fn near(a: Point, b: Point) -> bool {
    (0..3).all(|k| (a[k] - b[k]).abs() < 1e-6)
}
