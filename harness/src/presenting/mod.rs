//! Shows results: tables on the terminal, images, reports.

pub mod analysis;
pub mod error;
pub mod gallery;
pub mod output;
pub mod overview;
pub mod report;
pub mod reproduce;
pub mod table;
pub mod terminal;
