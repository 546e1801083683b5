//! Parameters, declared once: a field of a struct with its doc comment, default, range, symbol and
//! unit. The command line's flags, sweep axes, report columns and the tables in the documents all
//! come from that declaration.
//!
//! ```
//! use interreflect_scene::params::{self, Value};
//! use schemars::JsonSchema;
//! use serde::{Deserialize, Serialize};
//! use smart_default::SmartDefault;
//!
//! #[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
//! struct Blur {
//!     /// Standard deviation of the Gaussian.
//!     #[default(10.0)]
//!     #[schemars(range(min = 0.0, max = 90.0), extend("symbol" = "σ", "unit" = "°"))]
//!     angle_deg: f32,
//!     /// What is blurred.
//!     target: Target,
//! }
//!
//! #[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
//! #[serde(rename_all = "snake_case")]
//! enum Target {
//!     /// The environment map.
//!     #[default]
//!     Environment,
//!     /// The rendered image.
//!     Image,
//! }
//!
//! let mut blur = Blur::default();
//! params::set(&mut blur, "angle_deg", "2.5")?;
//! assert_eq!(params::values(&blur)[0].1, Value::F32(2.5));
//! assert_eq!(params::fields::<Blur>()[1].domain.to_string(), "environment, image");
//! # Ok::<(), params::ParamError>(())
//! ```
//!
//! - A field is a `u32`, `f32`, `bool` or an enum of unit variants.
//! - The first paragraph of its doc comment is its description.
//! - `range(min, max)` bounds a number; without it every finite value of the type is allowed.
//! - `extend` takes `"symbol"`, `"unit"` and `"scale"` (`"linear"` or `"log"`); any other key is refused.
//! - `#[serde(rename = "receiver.gap")]` gives a field another name, `#[serde(flatten)]` takes in the
//!   fields of another declaration.

mod choice;
mod error;
mod field;
mod schema;
#[cfg(test)]
mod tests;

pub use choice::Choice;
pub use error::{ParamError, nearest};
pub use field::{Domain, FieldInfo, Scale, Value};

use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::fmt;

/// A set of parameters: any struct that is declared as the module says. The default is the paper's
/// value where a paper gives one.
pub trait Params:
    Default
    + Clone
    + fmt::Debug
    + PartialEq
    + Serialize
    + DeserializeOwned
    + JsonSchema
    + Send
    + Sync
    + 'static
{
}

impl<P> Params for P where
    P: Default
        + Clone
        + fmt::Debug
        + PartialEq
        + Serialize
        + DeserializeOwned
        + JsonSchema
        + Send
        + Sync
        + 'static
{
}

/// The paper literally, errata included, or what it meant.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    Hash,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Fidelity {
    /// The paper's own formula or shader, errata included.
    #[default]
    Published,
    /// What the paper meant, with the mathematics right.
    Corrected,
}

impl Choice for Fidelity {}

/// Name of the parameter that chooses a [`Fidelity`], the same for every method that has one.
pub const FIDELITY: &str = "fidelity";

/// Every parameter, in the order in which it is declared and shown.
///
/// # Panics
/// If a field is declared in a way that the module does not allow.
pub fn fields<P: Params>() -> &'static [FieldInfo] {
    schema::fields::<P>()
}

/// Every parameter of a set with its value.
///
/// # Panics
/// As [`fields`].
pub fn values<P: Params>(params: &P) -> Vec<(FieldInfo, Value)> {
    let written = written(params);
    let value = |field: &FieldInfo| {
        let value = field.value(&written[field.name]);
        value.expect("a field is serialized as its schema declares")
    };
    fields::<P>().iter().map(|f| (*f, value(f))).collect()
}

/// Parses and sets a parameter by name.
///
/// # Errors
/// [`ParamError`] if there is no such parameter or the text is not a value of it.
///
/// # Panics
/// As [`fields`], and if another parameter was given a value that is not finite.
pub fn set<P: Params>(params: &mut P, name: &str, text: &str) -> Result<(), ParamError> {
    let fields = fields::<P>();
    let field = fields
        .iter()
        .find(|f| f.name == name)
        .ok_or_else(|| ParamError::unknown(name, fields.iter().map(|f| f.name)))?;
    let mut written = written(params);
    written[field.name] = serde_json::json!(field.parse(text)?);
    *params = serde_json::from_value(written).expect("a value of its domain fits its field");
    Ok(())
}

/// A set of parameters as a JSON object; an `f32` is exact in it.
fn written<P: Params>(params: &P) -> serde_json::Value {
    serde_json::to_value(params).expect("plain fields can be serialized")
}
