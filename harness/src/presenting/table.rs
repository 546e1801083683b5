//! Tables that conclude something from runs.

use serde::Serialize;

/// Tables of one scene and quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Tables {
    /// Name of the scene.
    pub scene: String,
    /// Name of the quantity, in snake case.
    pub quantity: String,
    /// The tables, in their order.
    pub tables: Vec<Table>,
}

/// A table of words and numbers that are written as they are.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Table {
    /// What it shows.
    pub caption: String,
    /// The columns; the first names the rows and stays in sight.
    pub head: Vec<String>,
    /// A cell for each column.
    pub rows: Vec<Vec<String>>,
    /// How to read it. May be empty.
    pub note: String,
}
