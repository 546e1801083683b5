//! Shaders, composed of parts.

use crate::GpuError;
use std::hash::{DefaultHasher, Hash, Hasher};

/// A WGSL shader: the concatenation of its parts, shared ones (see [`crate::wgsl`]) first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shader {
    /// Name in messages, in the pipeline cache and in graphics debuggers.
    pub label: &'static str,
    /// WGSL sources.
    pub parts: &'static [&'static str],
}

/// A shader that was parsed and validated, without any GPU.
pub(crate) struct Parsed {
    pub(crate) module: naga::Module,
    info: naga::valid::ModuleInfo,
}

impl Shader {
    /// The whole source.
    pub fn source(&self) -> String {
        self.parts.join("\n")
    }

    /// Hash of the whole source.
    pub(crate) fn source_hash(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.parts.hash(&mut hasher);
        hasher.finish()
    }

    pub(crate) fn parse(&self) -> Result<Parsed, GpuError> {
        let source = self.source();
        let invalid = |reason: String| GpuError::Shader {
            label: self.label,
            reason,
        };
        let module = naga::front::wgsl::parse_str(&source)
            .map_err(|e| invalid(e.emit_to_string_with_path(&source, self.label)))?;
        let info = naga::valid::Validator::new(
            naga::valid::ValidationFlags::all(),
            naga::valid::Capabilities::empty(),
        )
        .validate(&module)
        .map_err(|e| invalid(e.emit_to_string_with_path(&source, self.label)))?;
        Ok(Parsed { module, info })
    }
}

/// A variable in `@group(0)`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Slot {
    /// `@binding(index)`.
    pub(crate) index: u32,
    /// The variable's name.
    pub(crate) name: String,
}

impl Parsed {
    /// The slots that some entry points use, ascending; `Err` with the names of all entry points
    /// if one of them does not exist.
    pub(crate) fn slots(&self, entries: &[&str]) -> Result<Vec<Slot>, String> {
        let mut slots = Vec::new();
        for entry in entries {
            let index = self
                .module
                .entry_points
                .iter()
                .position(|e| e.name == *entry);
            let uses = self
                .info
                .get_entry_point(index.ok_or_else(|| self.entry_points())?);
            let used = self
                .module
                .global_variables
                .iter()
                .filter(|(h, _)| !uses[*h].is_empty());
            slots.extend(used.filter_map(|(_, variable)| {
                Some(Slot {
                    index: variable.binding.as_ref()?.binding,
                    name: variable.name.clone().unwrap_or_default(),
                })
            }));
        }
        slots.sort();
        slots.dedup();
        Ok(slots)
    }

    /// Names of the entry points.
    fn entry_points(&self) -> String {
        let names: Vec<_> = self
            .module
            .entry_points
            .iter()
            .map(|e| e.name.as_str())
            .collect();
        names.join(", ")
    }
}

/// Composes and validates a shader without any GPU.
///
/// # Errors
/// The validator's message, with the place in the source.
pub fn validate(shader: &Shader) -> Result<(), String> {
    shader.parse().map(drop).map_err(|e| e.to_string())
}
