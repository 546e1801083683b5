//! Enums of unit variants by name.

use super::schema;
use schemars::JsonSchema;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// An enum of unit variants, chosen by the names that serde gives them.
pub trait Choice: Copy + Serialize + DeserializeOwned + JsonSchema + 'static {
    /// Every name with its value, in the order of declaration.
    fn all() -> Vec<(&'static str, Self)> {
        let value = |name: &&'static str| {
            let value = serde_json::from_value((*name).into());
            (*name, value.expect("a variant has the name of its schema"))
        };
        schema::names::<Self>().iter().map(value).collect()
    }

    /// Its name on the command line and in records.
    fn name(self) -> &'static str {
        let written = serde_json::to_value(self).ok();
        let mut names = schema::names::<Self>().iter();
        let found = names.find(|name| written.as_ref().is_some_and(|w| w == **name));
        found.expect("a variant has the name of its schema")
    }
}
