//! Inputs of valid framing with arbitrary headers: what counts, sizes, places and names ask for, which bytes changed at random
//! hardly reach.

mod e57;
mod gltf;
mod npz;
mod parquet;

pub use e57::E57;
pub use gltf::Gltf;
pub use npz::Npz;
pub use parquet::Parquet;

use arbitrary::{Arbitrary, Unstructured};

/// Numbers at which counts and sizes go wrong.
const EDGES: [u64; 9] =
    [0, 1, 0x7fff_ffff, 0x8000_0000, 0xffff_ffff, 1 << 32, i64::MAX as u64, 1 << 63, u64::MAX];

/// A count, size or place: mostly small, as otherwise nothing behind it would be tried.
#[derive(Clone, Copy, Debug)]
pub struct Number(pub u64);

impl<'a> Arbitrary<'a> for Number {
    fn arbitrary(u: &mut Unstructured<'a>) -> arbitrary::Result<Self> {
        Ok(Self(match u.int_in_range(0..=15)? {
            0 => *u.choose(&EDGES)?,
            1 => u.arbitrary::<u32>()?.into(),
            2 => u.arbitrary::<u16>()?.into(),
            _ => u.int_in_range(0..=40)?,
        }))
    }
}

/// A number as it is, unless the input asks for another.
fn or(given: Option<Number>, right: usize) -> u64 {
    given.map_or(right as u64, |number| number.0)
}
