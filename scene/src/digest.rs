//! A name for what a scene holds.

use crate::Scene;
use std::fmt::{self, Write};

/// Digits of a digest: 64 bits, so that two scenes of one study share it by no accident.
const DIGITS: usize = 16;

impl Scene {
    /// Hexadecimal digits that stand for all that is in the scene: two scenes have the same if every
    /// number, name and text in them is the same.
    pub fn digest(&self) -> String {
        digest(self)
    }
}

/// Hexadecimal digits that stand for all that `Debug` shows of a value, floating-point numbers to their
/// last bit.
pub fn digest(value: &impl fmt::Debug) -> String {
    let mut hasher = Hasher(blake3::Hasher::new());
    // Hashing can't fail.
    let _ = write!(hasher, "{value:?}");
    hasher.0.finalize().to_hex()[..DIGITS].to_owned()
}

/// Hexadecimal digits that stand for these bytes.
pub fn digest_of_bytes(bytes: &[u8]) -> String {
    blake3::hash(bytes).to_hex()[..DIGITS].to_owned()
}

struct Hasher(blake3::Hasher);

impl Write for Hasher {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.update(text.as_bytes());
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load::{SceneRequest, open};

    fn room(set: &[(&str, &str)]) -> Scene {
        let set = set.iter().map(|(n, v)| ((*n).to_owned(), (*v).to_owned()));
        let request = SceneRequest {
            source: "colored-room".into(),
            set: set.collect(),
            ..SceneRequest::default()
        };
        open(&request).expect("a scene of the library")
    }

    #[test]
    fn digests_tell_scenes_apart() {
        let usual = room(&[]).digest();
        assert_eq!(usual, room(&[]).digest());
        assert_eq!(usual.len(), DIGITS);
        assert_ne!(usual, room(&[("glow", "0.2500001")]).digest());
        assert_ne!(usual, room(&[("receiver.size", "0.5")]).digest());
    }

    #[test]
    fn digests_know_the_last_bit() {
        assert_ne!(digest(&1.0_f32), digest(&1.000_000_1_f32));
        assert_ne!(digest(&0.0_f32), digest(&-0.0_f32));
    }
}
