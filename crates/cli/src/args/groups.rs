//! Arguments that several commands share.

mod running;
mod source;
mod stated;
mod tuning;
mod work;

pub use running::Running;
pub use source::{Reading, Source};
pub use stated::Cad;
pub use tuning::{Settings, Tuning};
pub use work::Work;
