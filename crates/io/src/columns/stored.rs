//! Numbers as bytes of a file.

use super::half;

/// The order of the bytes of a number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Endian {
    #[default]
    Little,
    Big,
}

/// A number of fixed size in a file.
pub(crate) trait Stored: Copy + Send {
    /// From little or big endian bytes; 0 if they are too few.
    fn from_bytes(bytes: &[u8], endian: Endian) -> Self;
    /// As f64, rounded where it does not fit.
    fn to_f64(self) -> f64;
}

/// A number that columns hold too.
pub(crate) trait Number: Stored {
    /// As little endian bytes.
    fn put(self, out: &mut Vec<u8>);
    /// From f64, if the type holds that value; f32 rounds.
    fn narrow(value: f64) -> Option<Self>;
}

macro_rules! numbers {
    ($narrow:ident: $($t:ty)*) => {$(
        impl Stored for $t {
            #[inline]
            fn from_bytes(bytes: &[u8], endian: Endian) -> Self {
                match (bytes.first_chunk(), endian) {
                    (Some(&bytes), Endian::Little) => <$t>::from_le_bytes(bytes),
                    (Some(&bytes), Endian::Big) => <$t>::from_be_bytes(bytes),
                    (None, _) => <$t>::default(),
                }
            }
            #[inline]
            fn to_f64(self) -> f64 {
                self as f64
            }
        }
        impl Number for $t {
            fn put(self, out: &mut Vec<u8>) {
                out.extend_from_slice(&self.to_le_bytes());
            }
            fn narrow(value: f64) -> Option<Self> {
                let narrowed = value as $t;
                $narrow(value, narrowed as f64).then_some(narrowed)
            }
        }
    )*};
}

/// An integer type holds a value that comes back the same.
fn same(value: f64, back: f64) -> bool {
    value == back
}

/// A float type holds every value, rounded.
fn rounded(_: f64, _: f64) -> bool {
    true
}

numbers!(same: i8 u8 i16 u16 i32 u32 i64 u64);
numbers!(rounded: f32 f64);

/// The bits of a number of half precision.
#[derive(Clone, Copy)]
pub(crate) struct Half(u16);

impl Half {
    pub fn single(self) -> f32 {
        half::single(self.0)
    }
}

impl Stored for Half {
    fn from_bytes(bytes: &[u8], endian: Endian) -> Self {
        Half(u16::from_bytes(bytes, endian))
    }
    fn to_f64(self) -> f64 {
        self.single().into()
    }
}

/// The number that the first bytes spell; 0 if they are too few.
#[inline]
pub(crate) fn number<T: Stored>(bytes: &[u8], endian: Endian) -> T {
    T::from_bytes(bytes, endian)
}
