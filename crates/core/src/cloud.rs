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

    /// Whether there is no value.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
