//! The layers of a chunk.

use laz::decoders::ArithmeticDecoder;
use std::io::Cursor;

/// Layers in the order in which they are stored.
pub(super) const PLACE: usize = 0;
pub(super) const Z: usize = 1;
pub(super) const CLASS: usize = 2;
pub(super) const FLAGS: usize = 3;
pub(super) const INTENSITY: usize = 4;
pub(super) const ANGLE: usize = 5;
pub(super) const USER: usize = 6;
pub(super) const SOURCE: usize = 7;
pub(super) const TIME: usize = 8;
pub(super) const LAYERS: usize = 9;

pub(super) type Decoder = ArithmeticDecoder<Cursor<Vec<u8>>>;

/// A layer: whether it is wanted, its bytes, and whether they are there to be decoded.
pub(super) struct Layer {
    pub wanted: bool,
    pub size: usize,
    pub used: bool,
    pub decoder: Decoder,
}
