//! References on disk: a campaign that goes on, or runs once more, need not compute them again.

use crate::domain::files::write_atomically;
use glam::Vec3;
use interreflect_conformance::own_model::ModelValues;
use interreflect_scene::Estimate;
use std::fs;
use std::path::PathBuf;

/// Where the references of one scene at one list of points lie.
#[derive(Clone, Debug)]
pub struct Cache {
    folder: PathBuf,
    /// Digest of what all of them depend on: the scene, the points and the program.
    of: String,
}

impl Cache {
    /// References in a folder, for what `of` is the digest of.
    pub fn new(folder: PathBuf, of: String) -> Self {
        Self { folder, of }
    }

    fn path(&self, key: &str) -> PathBuf {
        self.folder.join(format!("{}-{key}.bin", self.of))
    }

    /// What is kept under a key for so many points; `None` too where the file is damaged.
    pub(super) fn get(&self, key: &str, points: usize) -> Option<ModelValues> {
        let bytes = fs::read(self.path(key)).ok()?;
        let end = bytes.iter().position(|b| *b == b'\n')?;
        let description = String::from_utf8(bytes[..end].to_vec()).ok()?;
        let numbers = bytes[end + 1..].chunks_exact(4);
        let numbers: Vec<f32> = numbers
            .map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]]))
            .collect();
        if numbers.len() != 6 * points || bytes.len() - end - 1 != 24 * points {
            return None;
        }
        let (values, error) = numbers.split_at(3 * points);
        Some(ModelValues {
            values: estimate(values),
            error: estimate(error),
            description,
        })
    }

    /// Keeps values. A cache that can't be written is none: the values are there anyway.
    pub(super) fn keep(&self, key: &str, values: &ModelValues) {
        let mut bytes = values.description.replace('\n', " ").into_bytes();
        bytes.push(b'\n');
        for estimate in [&values.values, &values.error] {
            let numbers = estimate.iter().flat_map(|v| v.to_array());
            bytes.extend(numbers.flat_map(f32::to_le_bytes));
        }
        write_atomically(&self.path(key), &bytes).ok();
    }
}

fn estimate(numbers: &[f32]) -> Estimate {
    let mut estimate = Estimate::new(numbers.len() / 3);
    for (i, v) in numbers.chunks_exact(3).enumerate() {
        estimate.set(i, Vec3::from_slice(v));
    }
    estimate
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_come_back_to_the_bit_and_damaged_files_do_not() {
        let folder = tempfile::tempdir().expect("a folder");
        let cache = Cache::new(folder.path().join("references"), "scene".into());
        let numbers = [0.1, -0.0, f32::MIN_POSITIVE, 1e30, 3.0, 4.0];
        let values = ModelValues {
            values: estimate(&numbers),
            error: estimate(&[0.0; 6]),
            description: "path tracing, 32 samples".into(),
        };
        cache.keep("key", &values);
        let back = cache.get("key", 2).expect("what was kept");
        let bits = |e: &Estimate| {
            e.iter()
                .map(|v| v.to_array().map(f32::to_bits))
                .collect::<Vec<_>>()
        };
        assert_eq!(bits(&back.values), bits(&values.values));
        assert_eq!(back.description, values.description);
        assert!(cache.get("key", 3).is_none() && cache.get("other", 2).is_none());
        let path = cache.path("key");
        let bytes = fs::read(&path).expect("the file");
        fs::write(&path, &bytes[..bytes.len() - 1]).expect("written");
        assert!(cache.get("key", 2).is_none());
    }
}
