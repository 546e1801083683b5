//! Declarations, read once from the JSON schema of a type.

use super::{Domain, FieldInfo, Params, Scale};
use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value as Json};
use std::any::{TypeId, type_name};
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

/// What the schema of a parameter may hold; any other key is a slip in `extend`.
const KEYS: [&str; 12] = [
    "description",
    "type",
    "format",
    "minimum",
    "maximum",
    "oneOf",
    "anyOf",
    "enum",
    "default",
    "symbol",
    "unit",
    "scale",
];

type Cache<V> = Mutex<BTreeMap<TypeId, &'static [V]>>;

/// The parameters of a type, in the order of declaration.
pub(super) fn fields<P: Params>() -> &'static [FieldInfo] {
    static CACHE: Cache<FieldInfo> = Cache::new(BTreeMap::new());
    once_for::<P, _>(&CACHE, || {
        let schema = schema::<P>();
        let properties = schema["properties"].as_object();
        let read = |(name, schema): (&String, &Json)| {
            field(name, schema).unwrap_or_else(|why| panic!("{}.{name}: {why}", type_name::<P>()))
        };
        properties.into_iter().flatten().map(read).collect()
    })
}

/// The names of an enum's variants, in the order of declaration.
pub(super) fn names<C: JsonSchema + 'static>() -> &'static [&'static str] {
    static CACHE: Cache<&'static str> = Cache::new(BTreeMap::new());
    once_for::<C, _>(&CACHE, || names_in(&schema::<C>()))
}

/// What a type declares, read at the first call and held for the life of the program.
fn once_for<T: 'static, V>(cache: &Cache<V>, read: impl FnOnce() -> Vec<V>) -> &'static [V] {
    let mut cache = cache.lock().unwrap_or_else(PoisonError::into_inner);
    cache
        .entry(TypeId::of::<T>())
        .or_insert_with(|| read().leak())
}

fn schema<T: JsonSchema>() -> Json {
    let settings = SchemaSettings::default().with(|s| s.inline_subschemas = true);
    settings.into_generator().subschema_for::<T>().to_value()
}

/// A parameter from its schema, or what is wrong with its declaration.
fn field(name: &str, schema: &Json) -> Result<FieldInfo, String> {
    let schema = schema.as_object().ok_or("its type has no schema")?;
    if let Some(key) = schema.keys().find(|key| !KEYS.contains(&key.as_str())) {
        return Err(format!("`{key}` is not one of {}", KEYS.join(", ")));
    }
    let text = |key: &str| schema.get(key).and_then(Json::as_str).unwrap_or_default();
    let doc = first_paragraph(text("description"));
    if doc.is_empty() {
        return Err("a doc comment is missing".into());
    }
    Ok(FieldInfo {
        name: kept(name),
        symbol: kept(text("symbol")),
        unit: kept(text("unit")),
        doc: kept(&doc),
        domain: domain(schema)?,
    })
}

fn domain(schema: &Map<String, Json>) -> Result<Domain, String> {
    let text = |key: &str| schema.get(key).and_then(Json::as_str);
    let number = |key: &str| schema.get(key).and_then(Json::as_f64);
    let (min, max) = (number("minimum"), number("maximum"));
    let scale = match text("scale") {
        None | Some("linear") => Scale::Linear,
        Some("log") => Scale::Log,
        Some(other) => return Err(format!("the scale `{other}` is neither linear nor log")),
    };
    match text("format").or(text("type")) {
        Some("uint32") => Ok(Domain::U32 {
            min: min.map_or(u32::MIN, |v| v as u32),
            max: max.map_or(u32::MAX, |v| v as u32),
            scale,
        }),
        Some("float") => Ok(Domain::F32 {
            min: min.map_or(f32::MIN, |v| v as f32),
            max: max.map_or(f32::MAX, |v| v as f32),
            scale,
        }),
        Some("boolean") => Ok(Domain::Bool),
        _ => match names_in(&Json::Object(schema.clone())) {
            names if names.is_empty() => {
                Err("its type is not u32, f32, bool or an enum of unit variants".into())
            }
            names => Ok(Domain::OneOf(names.leak())),
        },
    }
}

/// The names in the schema of an enum: variants with a doc comment stand alone, others together.
fn names_in(schema: &Json) -> Vec<&'static str> {
    let list = |key: &str| schema[key].as_array().into_iter().flatten();
    let own = list("enum").chain(schema.get("const"));
    let own = own.filter_map(Json::as_str).map(kept);
    let nested = list("oneOf").chain(list("anyOf"));
    own.chain(nested.flat_map(names_in)).collect()
}

/// A text for the life of the program: there are as many as declarations.
fn kept(text: &str) -> &'static str {
    String::from(text).leak()
}

/// The first paragraph, on one line.
fn first_paragraph(doc: &str) -> String {
    let first = doc.split("\n\n").next().unwrap_or_default();
    first.split_whitespace().collect::<Vec<_>>().join(" ")
}
