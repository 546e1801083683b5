//! Why a parameter is refused, and the name that was probably meant.

/// The known name nearest to a misspelt one, if any is near.
pub fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    known
        .into_iter()
        .map(|k| (k, strsim::jaro_winkler(name, k)))
        .filter(|(_, score)| *score > 0.7)
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(k, _)| k)
}

/// Why a parameter was refused.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ParamError {
    /// No parameter has this name.
    #[error("there is no parameter `{name}`{hint}; known: {known}")]
    Unknown {
        /// The name as given.
        name: String,
        /// "; did you mean …?" or "".
        hint: String,
        /// All names.
        known: String,
    },
    /// The text is of another type.
    #[error("`{name}` = `{value}`: expected {expected}")]
    WrongType {
        /// The parameter.
        name: String,
        /// The text as given.
        value: String,
        /// What it should be.
        expected: &'static str,
    },
    /// The number lies outside the parameter's range.
    #[error("`{name}` = `{value}` is out of range: use {min} to {max}")]
    OutOfRange {
        /// The parameter.
        name: String,
        /// The text as given.
        value: String,
        /// Smallest value.
        min: String,
        /// Largest value.
        max: String,
    },
    /// The name is none of the choices.
    #[error("`{name}` = `{value}`: use one of {options}")]
    NotOneOf {
        /// The parameter.
        name: String,
        /// The text as given.
        value: String,
        /// The choices.
        options: String,
    },
}

impl ParamError {
    /// An unknown name, with the nearest known one.
    pub fn unknown<'a>(name: &str, known: impl Iterator<Item = &'a str> + Clone) -> Self {
        Self::Unknown {
            name: name.into(),
            hint: nearest(name, known.clone())
                .map(|n| format!(", did you mean `{n}`?"))
                .unwrap_or_default(),
            known: known.collect::<Vec<_>>().join(", "),
        }
    }
}
