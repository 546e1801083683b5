//! What is known of a parameter without its set, and its values.

use super::ParamError;
use serde::Serialize;
use std::fmt;

/// Which values a parameter takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Domain {
    /// Whole numbers from `min` to `max`.
    U32 {
        /// Smallest value.
        min: u32,
        /// Largest value.
        max: u32,
        /// How a sweep steps.
        scale: Scale,
    },
    /// Finite real numbers from `min` to `max`.
    F32 {
        /// Smallest value.
        min: f32,
        /// Largest value.
        max: f32,
        /// How a sweep steps.
        scale: Scale,
    },
    /// `true` or `false`.
    Bool,
    /// One of these names.
    OneOf(&'static [&'static str]),
}

impl fmt::Display for Domain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::U32 { min, max, .. } => write!(f, "{min} to {max}"),
            Self::F32 { min, max, .. } => write!(f, "{min} to {max}"),
            Self::Bool => f.write_str("true, false"),
            Self::OneOf(names) => f.write_str(&names.join(", ")),
        }
    }
}

/// How a range is stepped through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// By equal differences.
    Linear,
    /// By equal ratios.
    Log,
}

/// What is known of a parameter without its set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldInfo {
    /// Name in code, on the command line and in reports.
    pub name: &'static str,
    /// The paper's symbol, or "".
    pub symbol: &'static str,
    /// Unit, or "" for a pure number.
    pub unit: &'static str,
    /// What it does: the first paragraph of its doc comment, on one line.
    pub doc: &'static str,
    /// Which values it takes.
    pub domain: Domain,
}

/// A parameter's value.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// A whole number.
    U32(u32),
    /// A real number.
    F32(f32),
    /// A truth value.
    Bool(bool),
    /// A name.
    Name(&'static str),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::U32(v) => v.fmt(f),
            Self::F32(v) => v.fmt(f),
            Self::Bool(v) => v.fmt(f),
            Self::Name(v) => v.fmt(f),
        }
    }
}

impl FieldInfo {
    /// Parses a value of this parameter.
    ///
    /// # Errors
    /// [`ParamError`] if the text is not a value of the domain.
    pub fn parse(&self, text: &str) -> Result<Value, ParamError> {
        let wrong = |expected: &'static str| ParamError::WrongType {
            name: self.name.into(),
            value: text.into(),
            expected,
        };
        let outside = |min: String, max: String| ParamError::OutOfRange {
            name: self.name.into(),
            value: text.into(),
            min,
            max,
        };
        match &self.domain {
            Domain::U32 { min, max, .. } => {
                let v: u32 = text.parse().map_err(|_| wrong("a whole number"))?;
                match (min..=max).contains(&&v) {
                    true => Ok(Value::U32(v)),
                    false => Err(outside(min.to_string(), max.to_string())),
                }
            }
            Domain::F32 { min, max, .. } => {
                let v: f32 = text.parse().map_err(|_| wrong("a number"))?;
                match (min..=max).contains(&&v) {
                    true => Ok(Value::F32(v)),
                    false => Err(outside(min.to_string(), max.to_string())),
                }
            }
            Domain::Bool => text
                .parse()
                .map(Value::Bool)
                .map_err(|_| wrong("true or false")),
            Domain::OneOf(names) => match names.iter().find(|n| **n == text) {
                Some(name) => Ok(Value::Name(name)),
                None => Err(ParamError::NotOneOf {
                    name: self.name.into(),
                    value: text.into(),
                    options: names.join(", "),
                }),
            },
        }
    }

    /// The parameter's value as serde wrote it; `None` if that is of another kind.
    pub(super) fn value(&self, written: &serde_json::Value) -> Option<Value> {
        match self.domain {
            Domain::U32 { .. } => {
                let whole = written.as_u64()?;
                whole.try_into().ok().map(Value::U32)
            }
            // JSON writes what is not finite as null.
            Domain::F32 { .. } if written.is_null() => Some(Value::F32(f32::NAN)),
            Domain::F32 { .. } => Some(Value::F32(written.as_f64()? as f32)),
            Domain::Bool => written.as_bool().map(Value::Bool),
            Domain::OneOf(names) => {
                let name = written.as_str()?;
                names.iter().find(|n| **n == name).map(|n| Value::Name(n))
            }
        }
    }
}
