//! Point clouds as they are read, with their attributes.

/// A point cloud in the world frame, in the order of its input.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cloud {
    /// `(N, 3)` f64, world frame, in the unit of the input. May hold non-finite rows and duplicates:
    /// `Frame::localise` drops and merges them, and counts both.
    pub positions: Vec<[f64; 3]>,
    /// Further columns of the input, each with one value for each point. No stage reads them; they are carried through by index
    /// for the outputs.
    pub attributes: Vec<Attribute>,
}

/// One named column of a [`Cloud`].
#[derive(Clone, Debug, PartialEq)]
pub struct Attribute {
    /// The name in the input, such as `red` or `intensity`.
    pub name: String,
    /// `(N)` values in the type of the input.
    pub values: Column,
}

/// The values of an [`Attribute`], in the type of the input.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // the variants are the number types themselves
pub enum Column {
    I8(Vec<i8>),
    U8(Vec<u8>),
    I16(Vec<i16>),
    U16(Vec<u16>),
    I32(Vec<i32>),
    U32(Vec<u32>),
    I64(Vec<i64>),
    U64(Vec<u64>),
    F32(Vec<f32>),
    F64(Vec<f64>),
}

impl Cloud {
    /// A cloud of bare positions, `(N, 3)` f64 in the world frame.
    pub fn new(positions: Vec<[f64; 3]>) -> Self {
        Self { positions, attributes: Vec::new() }
    }

    /// The number of points.
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// The points of these indices with their attributes, in this order; indices beyond the last point are left out.
    pub fn select(&self, indices: &[u32]) -> Cloud {
        let attribute = |a: &Attribute| Attribute { name: a.name.clone(), values: a.values.select(indices) };
        Cloud {
            positions: selected(&self.positions, indices),
            attributes: self.attributes.iter().map(attribute).collect(),
        }
    }
}

fn selected<T: Copy>(values: &[T], indices: &[u32]) -> Vec<T> {
    indices.iter().filter_map(|&i| values.get(i as usize).copied()).collect()
}

impl AsRef<[[f64; 3]]> for Cloud {
    /// `(N, 3)` the positions.
    fn as_ref(&self) -> &[[f64; 3]] {
        &self.positions
    }
}

impl From<Vec<[f64; 3]>> for Cloud {
    fn from(positions: Vec<[f64; 3]>) -> Self {
        Self::new(positions)
    }
}

impl Column {
    /// The number of values.
    pub fn len(&self) -> usize {
        match self {
            Column::I8(v) => v.len(),
            Column::U8(v) => v.len(),
            Column::I16(v) => v.len(),
            Column::U16(v) => v.len(),
            Column::I32(v) => v.len(),
            Column::U32(v) => v.len(),
            Column::I64(v) => v.len(),
            Column::U64(v) => v.len(),
            Column::F32(v) => v.len(),
            Column::F64(v) => v.len(),
        }
    }

    fn select(&self, indices: &[u32]) -> Column {
        match self {
            Column::I8(v) => Column::I8(selected(v, indices)),
            Column::U8(v) => Column::U8(selected(v, indices)),
            Column::I16(v) => Column::I16(selected(v, indices)),
            Column::U16(v) => Column::U16(selected(v, indices)),
            Column::I32(v) => Column::I32(selected(v, indices)),
            Column::U32(v) => Column::U32(selected(v, indices)),
            Column::I64(v) => Column::I64(selected(v, indices)),
            Column::U64(v) => Column::U64(selected(v, indices)),
            Column::F32(v) => Column::F32(selected(v, indices)),
            Column::F64(v) => Column::F64(selected(v, indices)),
        }
    }

    /// Whether there is no value.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
