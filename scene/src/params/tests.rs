//! Longer than most: one sample struct has a parameter of each kind, and all tests are of it.
#![allow(clippy::unwrap_used, reason = "tests")]

use super::*;
use smart_default::SmartDefault;

/// One parameter of each kind.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
struct Sample {
    /// Texels along
    /// an edge.
    ///
    /// This paragraph is for readers of the code.
    #[default(4)]
    #[schemars(range(min = 1, max = 64))]
    #[schemars(extend("symbol" = "M", "unit" = "texels", "scale" = "log"))]
    resolution: u32,
    /// Gap to the wall.
    #[serde(rename = "receiver.gap")]
    #[default(0.1)]
    #[schemars(range(min = -0.95, max = LONGEST_M), extend("unit" = "m"))]
    gap: f32,
    /// Seed of the sequence.
    seed: u32,
    /// Any number.
    free: f32,
    /// A block stands in the corner.
    #[default(true)]
    block: bool,
    /// The paper as printed, or what it meant.
    #[default(Fidelity::Corrected)]
    fidelity: Fidelity,
    /// How the receiver looks.
    #[serde(flatten)]
    look: Look,
}

const LONGEST_M: f32 = 0.3;

#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
struct Look {
    /// Where the front is.
    #[serde(rename = "receiver.front")]
    front: Front,
    /// Reflections that count.
    #[default(7)]
    #[schemars(range(max = 8))]
    bounces: u32,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Front {
    #[serde(rename = "+x")]
    PositiveX,
    HalfWay,
    #[default]
    Behind2,
    #[serde(untagged)]
    Other(Fidelity),
}

fn field(name: &str) -> FieldInfo {
    let found = fields::<Sample>().iter().find(|f| f.name == name);
    *found.unwrap()
}

fn value(sample: &Sample, name: &str) -> Value {
    let values = values(sample);
    values.into_iter().find(|(f, _)| f.name == name).unwrap().1
}

fn refused(name: &str, text: &str) -> String {
    let mut sample = Sample::default();
    let error = set(&mut sample, name, text).unwrap_err();
    assert_eq!(sample, Sample::default(), "{name}={text}");
    error.to_string()
}

#[test]
fn fields_are_in_the_order_of_declaration_and_those_of_other_declarations_in_their_place() {
    let names: Vec<_> = fields::<Sample>().iter().map(|f| f.name).collect();
    let declared = [
        "resolution",
        "receiver.gap",
        "seed",
        "free",
        "block",
        "fidelity",
        "receiver.front",
        "bounces",
    ];
    assert_eq!(names, declared);
}

#[test]
fn a_field_says_all_that_its_declaration_says() {
    let expected = FieldInfo {
        name: "resolution",
        symbol: "M",
        unit: "texels",
        doc: "Texels along an edge.",
        domain: Domain::U32 {
            min: 1,
            max: 64,
            scale: Scale::Log,
        },
    };
    assert_eq!(field("resolution"), expected);
    let gap = field("receiver.gap");
    assert_eq!((gap.symbol, gap.unit), ("", "m"));
    let domain = Domain::F32 {
        min: -0.95,
        max: 0.3,
        scale: Scale::Linear,
    };
    assert_eq!(gap.domain, domain);
    let bounces = Domain::U32 {
        min: 0,
        max: 8,
        scale: Scale::Linear,
    };
    assert_eq!(field("bounces").domain, bounces);
    assert_eq!(field("block").domain, Domain::Bool);
}

#[test]
fn without_a_range_every_finite_value_is_allowed() {
    let mut sample = Sample::default();
    for text in ["0", "4294967295"] {
        set(&mut sample, "seed", text).unwrap();
        assert_eq!(value(&sample, "seed").to_string(), text);
    }
    for v in [f32::MIN, f32::MAX] {
        set(&mut sample, "free", &v.to_string()).unwrap();
        assert_eq!(sample.free, v);
    }
    assert!(refused("free", "inf").contains("out of range"));
    assert!(refused("free", "NaN").contains("out of range"));
}

#[test]
fn choices_have_the_names_of_their_variants() {
    let names: &[_] = &["published", "corrected"];
    assert_eq!(field("fidelity").domain, Domain::OneOf(names));
    let names: &[_] = &["+x", "half_way", "behind2", "published", "corrected"];
    assert_eq!(field("receiver.front").domain, Domain::OneOf(names));
    let mut sample = Sample::default();
    for (name, front) in [
        ("+x", Front::PositiveX),
        ("half_way", Front::HalfWay),
        ("corrected", Front::Other(Fidelity::Corrected)),
    ] {
        set(&mut sample, "receiver.front", name).unwrap();
        assert_eq!(sample.look.front, front);
        assert_eq!(value(&sample, "receiver.front"), Value::Name(name));
    }
}

#[test]
fn a_choice_is_found_by_name() {
    let all = Fidelity::all();
    let expected = [
        ("published", Fidelity::Published),
        ("corrected", Fidelity::Corrected),
    ];
    assert_eq!(all, expected);
    assert!(all.iter().all(|(name, value)| value.name() == *name));
}

#[test]
fn values_are_the_defaults_until_they_are_set() {
    let texts: Vec<_> = values(&Sample::default())
        .iter()
        .map(|(_, value)| value.to_string())
        .collect();
    let defaults = ["4", "0.1", "0", "0", "true", "corrected", "behind2", "7"];
    assert_eq!(texts, defaults);
    let mut sample = Sample::default();
    set(&mut sample, "resolution", "64").unwrap();
    set(&mut sample, "block", "false").unwrap();
    set(&mut sample, "bounces", "0").unwrap();
    let expected = Sample {
        resolution: 64,
        block: false,
        look: Look {
            bounces: 0,
            ..Look::default()
        },
        ..Sample::default()
    };
    assert_eq!(sample, expected);
}

/// Neighbours of round numbers, the smallest numbers, and −0, which is no 0.
#[test]
fn every_bit_of_a_real_number_is_kept() {
    for v in [
        0.1_f32,
        0.1_f32.next_up(),
        0.3_f32.next_down(),
        1.0 / 3.0,
        f32::MIN_POSITIVE,
        f32::from_bits(1),
        -0.0,
        16_777_217.0,
        f32::MAX.next_down(),
    ] {
        let mut sample = Sample {
            free: v,
            ..Sample::default()
        };
        set(&mut sample, "seed", "5").unwrap();
        assert_eq!(sample.free.to_bits(), v.to_bits(), "{v} beside what is set");
        let Value::F32(read) = value(&sample, "free") else {
            panic!("{v} is no real number");
        };
        assert_eq!(read.to_bits(), v.to_bits(), "{v} is read");
        let mut again = Sample::default();
        set(&mut again, "free", &read.to_string()).unwrap();
        assert_eq!(again.free.to_bits(), v.to_bits(), "{v} is set");
    }
}

/// A bound is that of the type of the field: 0.3 as `f32` is above 0.3 as `f64`.
#[test]
fn bounds_are_included() {
    let mut sample = Sample::default();
    for text in ["-0.95", "0.3"] {
        set(&mut sample, "receiver.gap", text).unwrap();
        assert_eq!(value(&sample, "receiver.gap").to_string(), text);
    }
    let above = 0.3_f32.next_up().to_string();
    assert!(refused("receiver.gap", &above).contains("use -0.95 to 0.3"));
}

#[test]
fn refusals_say_what_would_do() {
    for (name, text, told) in [
        (
            "resolutoin",
            "8",
            "there is no parameter `resolutoin`, did you mean `resolution`?; known: resolution, \
             receiver.gap, seed, free, block, fidelity, receiver.front, bounces",
        ),
        (
            "zzz",
            "8",
            "there is no parameter `zzz`; known: resolution, receiver.gap, seed, free, block, \
             fidelity, receiver.front, bounces",
        ),
        (
            "resolution",
            "65",
            "`resolution` = `65` is out of range: use 1 to 64",
        ),
        (
            "resolution",
            "-1",
            "`resolution` = `-1`: expected a whole number",
        ),
        (
            "receiver.gap",
            "wide",
            "`receiver.gap` = `wide`: expected a number",
        ),
        ("block", "yes", "`block` = `yes`: expected true or false"),
        (
            "fidelity",
            "Published",
            "`fidelity` = `Published`: use one of published, corrected",
        ),
    ] {
        assert_eq!(refused(name, text), told);
    }
}

#[test]
fn a_method_may_have_no_parameters() {
    assert!(fields::<()>().is_empty());
    assert!(values(&()).is_empty());
    assert!(set(&mut (), "any", "1").is_err());
}

/// Why a declaration is refused.
fn fault<P: Params>() -> String {
    let refused = std::panic::catch_unwind(fields::<P>).unwrap_err();
    *refused.downcast::<String>().unwrap()
}

#[test]
fn slips_of_a_declaration_are_told() {
    #[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
    struct Undocumented {
        size: f32,
    }
    #[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
    struct Text {
        /// A text.
        name: String,
    }
    #[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
    struct Misspelt {
        /// A size.
        #[schemars(extend("units" = "m"))]
        size: f32,
    }
    #[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
    struct Scaled {
        /// A size.
        #[schemars(extend("scale" = "log2"))]
        size: f32,
    }
    for (fault, told) in [
        (
            fault::<Undocumented>(),
            "Undocumented.size: a doc comment is missing",
        ),
        (fault::<Text>(), "Text.name: its type is not u32"),
        (fault::<Misspelt>(), "Misspelt.size: `units` is not one of"),
        (fault::<Scaled>(), "Scaled.size: the scale `log2` is"),
    ] {
        assert!(fault.contains(told), "{fault}");
    }
    // One declaration's fault is not another's.
    assert_eq!(fields::<Look>().len(), 2);
}
