//! Parts of a campaign, for several machines.

use std::str::FromStr;

/// One of several parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// From 0.
    index: usize,
    count: usize,
}

impl Shard {
    /// All of it.
    pub const WHOLE: Self = Self { index: 0, count: 1 };

    /// Whether the task of this number belongs to the part: tasks go round.
    pub fn has(&self, task: usize) -> bool {
        task % self.count == self.index
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/');
        let numbers =
            parts.and_then(|(i, n)| Some((i.trim().parse().ok()?, n.trim().parse().ok()?)));
        match numbers {
            Some((part, count)) if (1..=count).contains(&part) => Ok(Self {
                index: part - 1,
                count,
            }),
            _ => Err("expected i/n with i from 1 to n, such as 3/8".into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_task_is_in_one_part() {
        let parts: Vec<Shard> = (1..=3)
            .map(|i| format!("{i}/3").parse().expect("a part"))
            .collect();
        for task in 0..20 {
            assert_eq!(parts.iter().filter(|p| p.has(task)).count(), 1);
            assert!(Shard::WHOLE.has(task));
        }
    }

    #[test]
    fn parts_outside_are_refused() {
        for text in ["0/3", "4/3", "1", "a/b", "1/0", "-1/2"] {
            assert!(text.parse::<Shard>().is_err(), "{text}");
        }
    }
}
