//! Parameters as a record keeps them.

use interreflect_estimators::Configured;
use interreflect_scene::params::Value;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de, ser::SerializeMap};
use std::fmt;

/// A parameter's value as JSON has it: a number, a truth value or a name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ParamValue {
    /// A whole number.
    U32(u32),
    /// A real number.
    F32(f32),
    /// A truth value.
    Bool(bool),
    /// A name.
    Name(String),
}

impl From<Value> for ParamValue {
    fn from(value: Value) -> Self {
        match value {
            Value::U32(v) => Self::U32(v),
            Value::F32(v) => Self::F32(v),
            Value::Bool(v) => Self::Bool(v),
            Value::Name(v) => Self::Name(v.into()),
        }
    }
}

impl fmt::Display for ParamValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::U32(v) => v.fmt(f),
            Self::F32(v) => v.fmt(f),
            Self::Bool(v) => v.fmt(f),
            Self::Name(v) => v.fmt(f),
        }
    }
}

/// Parameters by name, in the order in which the method declares them; a JSON object.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ParamMap(pub Vec<(String, ParamValue)>);

impl ParamMap {
    /// All parameters of a method.
    pub fn of(method: &dyn Configured) -> Self {
        let values = method.values().into_iter();
        values.map(|(field, value)| (field.name, value)).collect()
    }

    /// Whether it has no parameter.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The value of a parameter.
    pub fn get(&self, name: &str) -> Option<&ParamValue> {
        self.0.iter().find(|(n, _)| n == name).map(|(_, v)| v)
    }
}

impl<N: Into<String>, V: Into<ParamValue>> FromIterator<(N, V)> for ParamMap {
    fn from_iter<I: IntoIterator<Item = (N, V)>>(entries: I) -> Self {
        let entry = |(n, v): (N, V)| (n.into(), v.into());
        Self(entries.into_iter().map(entry).collect())
    }
}

impl fmt::Display for ParamMap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, (name, value)) in self.0.iter().enumerate() {
            let space = if i == 0 { "" } else { " " };
            write!(f, "{space}{name}={value}")?;
        }
        Ok(())
    }
}

impl Serialize for ParamMap {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (name, value) in &self.0 {
            map.serialize_entry(name, value)?;
        }
        map.end()
    }
}

impl<'de> Deserialize<'de> for ParamMap {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Entries;
        impl<'de> de::Visitor<'de> for Entries {
            type Value = ParamMap;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object of parameters by name")
            }
            fn visit_map<A: de::MapAccess<'de>>(self, mut map: A) -> Result<ParamMap, A::Error> {
                let mut entries = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    entries.push(entry);
                }
                Ok(ParamMap(entries))
            }
        }
        deserializer.deserialize_map(Entries)
    }
}
