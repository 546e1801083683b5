//! What the papers' experiments found, as records, pictures and a page.

mod page;
mod pictures;
mod record;

pub use page::Page;
pub use record::{Entry, Record, Reproduced};
