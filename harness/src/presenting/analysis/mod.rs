//! What records let one conclude, in tables and in text.

mod error_breakdown;
mod notes;
mod tables;
mod text;

pub use error_breakdown::{bias_floors, splits};
pub use tables::Sheet;
pub use text::advice_in_text;

#[cfg(test)]
mod tests;
