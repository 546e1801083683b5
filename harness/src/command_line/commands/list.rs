//! `list`: scenes, estimators with their parameters, adapters.

use super::{print_json, print_line};
use crate::command_line::cli::List;
use crate::command_line::error::CommandError;
use interreflect_estimators::{Configured, Registry};
use interreflect_scene::library::library;
use interreflect_scene::load::{SceneRequest, open};
use interreflect_scene::params::{FieldInfo, Value};
use interreflect_scene::{DirectionalDepthSpec, Needs, Scene};
use serde_json::{Map, Value as Json, json};

/// One line for each method with a figure: its id, scene, quantity and settings.
fn print_figures(methods: &[Box<dyn Configured>]) -> Result<(), CommandError> {
    for info in methods.iter().map(|method| method.info()) {
        let Some(figure) = &info.figure else { continue };
        let words = [info.id, figure.scene, figure.quantity.name()];
        let settings = figure.settings.iter().copied();
        let line: Vec<&str> = words.into_iter().chain(settings).collect();
        print_line(&line.join(" "))?;
    }
    Ok(())
}

pub(super) fn run(command: &List, registry: Registry) -> Result<(), CommandError> {
    let methods: Vec<_> = registry.entries().iter().map(|e| e.configure()).collect();
    if command.figures {
        return print_figures(&methods);
    }
    let needs = match command.needs {
        true => Some(needs_of_all(&methods)?),
        false => None,
    };
    if command.json {
        return print_json(&as_json(&registry, &methods, needs));
    }
    print_line("Scenes")?;
    for scene in library() {
        print_line(&format!("  {:<20} {}", scene.name, scene.summary))?;
        let settings = scene.settings();
        print_fields("scene.", &settings)?;
    }
    print_line("\nEstimators")?;
    for method in &methods {
        let info = method.info();
        print_line(&format!(
            "  {:<20} {}: {}",
            info.id, info.title, info.summary
        ))?;
        for reference in info.references {
            print_line(&format!("      {reference}"))?;
        }
        let quantities: Vec<_> = method.quantities().iter().map(|q| q.name()).collect();
        let backends = backends(&registry, info.id).join(", ");
        print_line(&format!("      {} on {backends}", quantities.join(", ")))?;
        print_fields("", &method.values())?;
    }
    print_line("\nAdapters")?;
    let adapters = interreflect_gpu::adapters();
    for (i, adapter) in adapters.iter().enumerate() {
        let software = if adapter.software { " (software)" } else { "" };
        print_line(&format!(
            "  {i}: {}{software}, {}",
            adapter.name, adapter.driver_info
        ))?;
    }
    if adapters.is_empty() {
        print_line(&format!("  {}", interreflect_gpu::GpuError::NoAdapter))?;
    }
    if let Some(needs) = needs {
        print_line("\nNeeds")?;
        for Needed {
            scene,
            id,
            quantity,
            needs,
        } in needs
        {
            print_line(&format!("  {scene:<14} {id:<20} {quantity:<18} {needs}"))?;
        }
    }
    Ok(())
}

/// The backends that a method runs on.
fn backends(registry: &Registry, id: &str) -> Vec<&'static str> {
    let gpu = registry.get(id).is_ok_and(|entry| entry.gpu().is_ok());
    if gpu { vec!["cpu", "gpu"] } else { vec!["cpu"] }
}

fn print_fields(prefix: &str, fields: &[(FieldInfo, Value)]) -> Result<(), CommandError> {
    for (field, value) in fields {
        let name = format!("{prefix}{}", field.name);
        let domain = &field.domain;
        let unit = if field.unit.is_empty() {
            String::new()
        } else {
            format!(" {}", field.unit)
        };
        print_line(&format!(
            "      {name:<24} {value}{unit} ({domain}): {}",
            field.doc
        ))?;
    }
    Ok(())
}

/// What a method needs for a quantity in a scene.
struct Needed {
    scene: &'static str,
    id: &'static str,
    quantity: &'static str,
    needs: String,
}

fn needs_of_all(methods: &[Box<dyn Configured>]) -> Result<Vec<Needed>, CommandError> {
    let mut all = Vec::new();
    for entry in library() {
        let scene: Scene = open(&SceneRequest::new(entry.name))?;
        for method in methods {
            for quantity in method.quantities() {
                let needs = method.needs(*quantity, &scene.facts());
                all.push(Needed {
                    scene: entry.name,
                    id: method.info().id,
                    quantity: quantity.name(),
                    needs: needs.map_or_else(|why| why.to_string(), |needs| describe(&needs)),
                });
            }
        }
    }
    Ok(all)
}

fn describe(needs: &Needs) -> String {
    let cube = |spec: &interreflect_scene::CubeSpec| {
        let c = spec.channels;
        let named = [
            (c.radiance, "radiance"),
            (c.distance, "distance"),
            (c.normal, "normal"),
        ];
        let channels: Vec<_> = named.iter().filter(|n| n.0).map(|n| n.1).collect();
        let bounces = match spec.bounces {
            0 => String::new(),
            k => format!(", {k} further bounces"),
        };
        format!("cube {}² {}{bounces}", spec.size, channels.join("+"))
    };
    let mut parts: Vec<_> = needs.cubes.iter().map(cube).collect();
    let depths =
        |d: &DirectionalDepthSpec| format!("depth maps of {0}x{0} along directions", d.size);
    parts.extend(needs.directional_depths.iter().map(depths));
    if needs.environment {
        parts.push("the environment at infinity".into());
    }
    parts.extend(needs.rsms.iter().map(|spec| {
        let c = spec.channels;
        let named = [
            (true, "position"),
            (c.radiance, "radiance"),
            (c.normal, "normal"),
            (c.true_colors, "true colours"),
        ];
        let channels: Vec<_> = named.iter().filter(|n| n.0).map(|n| n.1).collect();
        format!("RSMs {}² {}", spec.size, channels.join("+"))
    }));
    if needs.light_transport {
        parts.push("light transport".into());
    }
    parts.join(", ")
}

fn as_json(
    registry: &Registry,
    methods: &[Box<dyn Configured>],
    needs: Option<Vec<Needed>>,
) -> Json {
    let fields = |fields: Vec<(FieldInfo, Value)>| -> Json {
        let of = |(f, v): (FieldInfo, Value)| {
            json!({"name": f.name, "symbol": f.symbol, "unit": f.unit, "doc": f.doc,
                   "default": v.to_string(), "domain": f.domain.to_string()})
        };
        fields.into_iter().map(of).collect()
    };
    let scenes: Vec<_> = library()
        .iter()
        .map(|s| json!({"name": s.name, "summary": s.summary, "settings": fields(s.settings())}))
        .collect();
    let estimators: Vec<_> = methods
        .iter()
        .map(|m| {
            let quantities: Vec<_> = m.quantities().iter().map(|q| q.name()).collect();
            json!({"id": m.info().id, "title": m.info().title, "summary": m.info().summary, "source": m.info().source(),
                   "quantities": quantities, "backends": backends(registry, m.info().id), "params": fields(m.values())})
        })
        .collect();
    let adapters: Vec<_> = interreflect_gpu::adapters()
        .iter()
        .map(|a| json!({"name": a.name, "driver": a.driver_info, "software": a.software}))
        .collect();
    let mut all = Map::new();
    all.insert("scenes".into(), scenes.into());
    all.insert("estimators".into(), estimators.into());
    all.insert("adapters".into(), adapters.into());
    if let Some(needs) = needs {
        let of = |n: Needed| json!({"scene": n.scene, "estimator": n.id, "quantity": n.quantity, "needs": n.needs});
        all.insert("needs".into(), needs.into_iter().map(of).collect());
    }
    Json::Object(all)
}
