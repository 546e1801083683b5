//! Parameters, declared once: the command line's flags, sweep axes, report columns and the tables
//! in the documents all come from the same list of [`Field`]s.
//!
//! Longer than most: a field, its domain and its access are one idea, and half of it is their docs.

mod error;

pub use error::{ParamError, nearest};

use std::fmt;

/// A set of parameters. The default is the paper's value where a paper gives one.
pub trait Params: Default + Clone + fmt::Debug + PartialEq + Send + Sync + 'static {
    /// Every parameter, in the order in which it is shown.
    fn fields() -> Vec<Field<Self>>;
}

/// A named value out of a short list.
pub trait Choice: Copy + PartialEq + 'static {
    /// Every name with its value.
    const ALL: &'static [(&'static str, Self)];
}

/// The paper as printed, errata included, or what it meant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Fidelity {
    /// The paper's own formula or shader, errata included.
    #[default]
    Published,
    /// What the paper meant, with the mathematics right.
    Corrected,
}

impl Choice for Fidelity {
    const ALL: &'static [(&'static str, Self)] = &[
        ("published", Self::Published),
        ("corrected", Self::Corrected),
    ];
}

/// Name of the parameter that chooses a [`Fidelity`], the same for every method that has one.
pub const FIDELITY: &str = "fidelity";

/// Which values a parameter takes.
#[derive(Clone, Debug, PartialEq)]
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
    OneOf(Vec<&'static str>),
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
#[derive(Clone, Debug, PartialEq)]
pub struct FieldInfo {
    /// Name in code, on the command line and in reports.
    pub name: &'static str,
    /// The paper's symbol, or "".
    pub symbol: &'static str,
    /// Unit, or "" for a pure number.
    pub unit: &'static str,
    /// One line on what it does.
    pub doc: &'static str,
    /// Which values it takes.
    pub domain: Domain,
}

/// A parameter's value.
#[derive(Clone, Copy, Debug, PartialEq)]
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

type Get<P, V> = fn(&P) -> V;
type Set<P, V> = fn(&mut P, V);
type NameOf<P> = Box<dyn Fn(&P) -> &'static str>;
type SetByName<P> = Box<dyn Fn(&mut P, &'static str)>;

enum Access<P> {
    U32(Get<P, u32>, Set<P, u32>),
    F32(Get<P, f32>, Set<P, f32>),
    Bool(Get<P, bool>, Set<P, bool>),
    OneOf(NameOf<P>, SetByName<P>),
}

/// A parameter of the set `P`.
pub struct Field<P> {
    info: FieldInfo,
    access: Access<P>,
}

impl<P: 'static> Field<P> {
    /// A whole number in `range`.
    pub fn u32(
        name: &'static str,
        doc: &'static str,
        range: std::ops::RangeInclusive<u32>,
        get: Get<P, u32>,
        set: Set<P, u32>,
    ) -> Self {
        let domain = Domain::U32 {
            min: *range.start(),
            max: *range.end(),
            scale: Scale::Linear,
        };
        Self::new(name, doc, domain, Access::U32(get, set))
    }

    /// A finite real number in `range`.
    pub fn f32(
        name: &'static str,
        doc: &'static str,
        range: std::ops::RangeInclusive<f32>,
        get: Get<P, f32>,
        set: Set<P, f32>,
    ) -> Self {
        let domain = Domain::F32 {
            min: *range.start(),
            max: *range.end(),
            scale: Scale::Linear,
        };
        Self::new(name, doc, domain, Access::F32(get, set))
    }

    /// A truth value.
    pub fn bool(
        name: &'static str,
        doc: &'static str,
        get: Get<P, bool>,
        set: Set<P, bool>,
    ) -> Self {
        Self::new(name, doc, Domain::Bool, Access::Bool(get, set))
    }

    /// One of a choice's names.
    pub fn choice<C: Choice>(
        name: &'static str,
        doc: &'static str,
        get: Get<P, C>,
        set: Set<P, C>,
    ) -> Self {
        let names = C::ALL.iter().map(|(n, _)| *n).collect();
        let name_of = move |p: &P| {
            let value = get(p);
            let found = C::ALL.iter().find(|(_, v)| *v == value);
            found.expect("a choice lists every value").0
        };
        let set_by_name = move |p: &mut P, name: &'static str| {
            let found = C::ALL.iter().find(|(n, _)| *n == name);
            set(p, found.expect("the name was checked against the domain").1);
        };
        Self::new(
            name,
            doc,
            Domain::OneOf(names),
            Access::OneOf(Box::new(name_of), Box::new(set_by_name)),
        )
    }

    /// The switch between the paper as printed and what it meant.
    pub fn fidelity(get: Get<P, Fidelity>, set: Set<P, Fidelity>) -> Self {
        Self::choice(
            FIDELITY,
            "the paper as printed, errata included, or what it meant",
            get,
            set,
        )
    }

    fn new(name: &'static str, doc: &'static str, domain: Domain, access: Access<P>) -> Self {
        Self {
            info: FieldInfo {
                name,
                symbol: "",
                unit: "",
                doc,
                domain,
            },
            access,
        }
    }

    /// With the paper's symbol.
    pub fn symbol(mut self, symbol: &'static str) -> Self {
        self.info.symbol = symbol;
        self
    }

    /// With a unit.
    pub fn unit(mut self, unit: &'static str) -> Self {
        self.info.unit = unit;
        self
    }

    /// Stepped through by equal ratios.
    pub fn log(mut self) -> Self {
        if let Domain::U32 { scale, .. } | Domain::F32 { scale, .. } = &mut self.info.domain {
            *scale = Scale::Log;
        }
        self
    }

    /// What is known of the parameter.
    pub fn info(&self) -> &FieldInfo {
        &self.info
    }

    /// The parameter's value in a set.
    pub fn get(&self, params: &P) -> Value {
        match &self.access {
            Access::U32(get, _) => Value::U32(get(params)),
            Access::F32(get, _) => Value::F32(get(params)),
            Access::Bool(get, _) => Value::Bool(get(params)),
            Access::OneOf(get, _) => Value::Name(get(params)),
        }
    }

    /// Parses and sets the parameter.
    ///
    /// # Errors
    /// [`ParamError`] if the text is not a value of the domain.
    pub fn set(&self, params: &mut P, text: &str) -> Result<(), ParamError> {
        let value = self.info.parse(text)?;
        match (&self.access, value) {
            (Access::U32(_, set), Value::U32(v)) => set(params, v),
            (Access::F32(_, set), Value::F32(v)) => set(params, v),
            (Access::Bool(_, set), Value::Bool(v)) => set(params, v),
            (Access::OneOf(_, set), Value::Name(v)) => set(params, v),
            _ => unreachable!("a parsed value has the kind of its domain"),
        }
        Ok(())
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
}

/// Sets a parameter by name.
///
/// # Errors
/// [`ParamError`] if there is no such parameter or the text is not a value of it.
pub fn set<P: Params>(params: &mut P, name: &str, text: &str) -> Result<(), ParamError> {
    let fields = P::fields();
    match fields.iter().find(|f| f.info.name == name) {
        Some(field) => field.set(params, text),
        None => Err(ParamError::unknown(
            name,
            fields.iter().map(|f| f.info.name),
        )),
    }
}

/// Every parameter of a set with its value.
pub fn values<P: Params>(params: &P) -> Vec<(FieldInfo, Value)> {
    P::fields()
        .into_iter()
        .map(|f| {
            let value = f.get(params);
            (f.info, value)
        })
        .collect()
}
