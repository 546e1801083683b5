//! How methods are set for checks that run them hundreds of times.

use interreflect_estimators::Configured;
use interreflect_scene::params::Value;

/// Small captures, small maps and few samples, where the method has them: random box scenes are small,
/// and a check runs many of them. What the user sets is set afterwards.
pub fn quick(method: &mut dyn Configured) {
    let fields = method.values();
    let has = |name: &str| fields.iter().any(|(field, _)| field.name == name);
    let mut at_most = vec![
        ("capture_resolution", 64),
        ("map_resolution", 256),
        ("samples", 64),
    ];
    // Maps that are convolved from other maps cost the product of both.
    if has("map_resolution") && has("resolution") {
        at_most.extend([("resolution", 8), ("map_resolution", 12)]);
    }
    for (name, most) in at_most {
        let larger = |value: &Value| matches!(value, Value::U32(v) if *v > most);
        if fields.iter().any(|(f, v)| f.name == name && larger(v)) {
            // A smaller value than it can have is left as it is.
            method.set(name, &most.to_string()).ok();
        }
    }
}
