//! Re-exporting the bindings is what keeps Box2D's C functions in the static library.
pub use boxdd_sys::*;
