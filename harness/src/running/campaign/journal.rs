//! Every finished task on disk at once: a campaign that was killed goes on where it was.

use crate::domain::files::FileError;
use crate::domain::machine::Machine;
use crate::domain::record::{ErrorBreakdown, Floor, Run};
use crate::running::error::JournalError;
use crate::running::warning::Warning;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read as _, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};

/// Name of the file in its folder.
const NAME: &str = "journal.jsonl";

/// What a task gave.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Done {
    Run(Box<Run>),
    Baseline(Box<Run>),
    Floor(Box<Floor>),
    Split(Box<ErrorBreakdown>),
}

impl Done {
    /// What is remarkable about a run.
    pub(crate) fn warning(&self) -> Option<Warning> {
        let Self::Run(run) = self else { return None };
        let apart = run.backends_apart?;
        Some(Warning::BackendsApart {
            scene: run.scene.clone(),
            label: run.label(),
            estimator: run.estimator.clone(),
            quantity: run.quantity.clone(),
            percent: 100.0 * apart,
        })
    }
}

/// A finished task.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Entry {
    /// Digest of all that the result depends on.
    pub(crate) key: String,
    /// Number of the task in its campaign: the order of results.
    pub(crate) at: usize,
    pub(crate) done: Done,
}

/// A line of the file.
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Line {
    /// Before the first task of a process: where what follows was measured.
    Machine(Box<Machine>),
    Task(Box<Entry>),
}

/// What was done, in memory and, if there is a folder, in its file.
#[derive(Default)]
pub(crate) struct Journal {
    file: Option<(PathBuf, File)>,
    /// By key, of this campaign or another.
    known: BTreeMap<String, Done>,
    /// What this campaign has, by its number.
    entries: BTreeMap<usize, Entry>,
    machines: Vec<Machine>,
}

impl Drop for Journal {
    /// Gives the lock up at once: a process that is being started holds a copy of the file until it has begun, and
    /// with it a lock that closing alone does not end.
    fn drop(&mut self) {
        if let Some((_, file)) = &self.file {
            file.unlock().ok();
        }
    }
}

impl Journal {
    /// A journal that is kept in memory alone.
    pub(crate) fn in_memory() -> Self {
        Self::default()
    }

    /// Opens the journal of a folder, or begins it. What a killed process left half-written at its end
    /// is dropped.
    ///
    /// # Errors
    /// [`JournalError`] if it can't be used.
    pub(crate) fn open(folder: &Path) -> Result<Self, JournalError> {
        let path = folder.join(NAME);
        let refused = |source| FileError::Write {
            path: path.clone(),
            source,
        };
        fs::create_dir_all(folder).map_err(refused)?;
        let open = OpenOptions::new()
            .read(true)
            .write(true)
            .create(true)
            .truncate(false)
            .open(&path);
        let mut file = open.map_err(refused)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(JournalError::InUse { path }),
            Err(TryLockError::Error(source)) => return Err(refused(source).into()),
        }
        let mut journal = Self::default();
        let whole = journal.read(&path, &mut file)?;
        file.set_len(whole).map_err(refused)?;
        file.seek(SeekFrom::End(0)).map_err(refused)?;
        journal.file = Some((path, file));
        Ok(journal)
    }

    /// The entries of a folder's journal, as they were written, and where they were measured.
    ///
    /// # Errors
    /// [`JournalError`] if there is none or it can't be read.
    pub(crate) fn entries_of(folder: &Path) -> Result<(Vec<Entry>, Vec<Machine>), JournalError> {
        let path = folder.join(NAME);
        let open = File::open(&path);
        let mut file = open.map_err(|source| JournalError::Read {
            path: path.clone(),
            source,
        })?;
        let mut text = String::new();
        let read = file.read_to_string(&mut text);
        read.map_err(|source| JournalError::Read {
            path: path.clone(),
            source,
        })?;
        let (mut entries, mut machines) = (Vec::new(), Vec::new());
        for line in lines(&path, &text)? {
            match line {
                Line::Machine(machine) => machines.push(*machine),
                Line::Task(entry) => entries.push(*entry),
            }
        }
        Ok((entries, machines))
    }

    /// Takes in what is there; the length of its whole lines in bytes.
    fn read(&mut self, path: &Path, file: &mut File) -> Result<u64, JournalError> {
        let mut bytes = Vec::new();
        let read = file.read_to_end(&mut bytes);
        read.map_err(|source| JournalError::Read {
            path: path.into(),
            source,
        })?;
        let whole = bytes
            .iter()
            .rposition(|b| *b == b'\n')
            .map_or(0, |at| at + 1);
        let text = String::from_utf8_lossy(&bytes[..whole]);
        for line in lines(path, &text)? {
            match line {
                Line::Machine(machine) => self.machines.push(*machine),
                Line::Task(entry) => {
                    self.known.insert(entry.key, entry.done);
                }
            }
        }
        Ok(whole as u64)
    }

    /// Says where what follows is measured.
    ///
    /// # Errors
    /// [`JournalError`] if it can't be written.
    pub(crate) fn on(&mut self, machine: Machine) -> Result<(), JournalError> {
        if self.machines.last() != Some(&machine) {
            self.write(&Line::Machine(Box::new(machine.clone())))?;
            self.machines.push(machine);
        }
        Ok(())
    }

    /// Whether a task was done, now or before; if so it counts as this campaign's number `at`.
    pub(crate) fn has(&mut self, key: &str, at: usize) -> bool {
        let Some(done) = self.known.get(key) else {
            return false;
        };
        let (key, done) = (key.to_owned(), done.clone());
        self.entries.insert(at, Entry { key, at, done });
        true
    }

    /// Keeps what a task gave.
    ///
    /// # Errors
    /// [`JournalError`] if it can't be written.
    pub(crate) fn keep(&mut self, entry: Entry) -> Result<(), JournalError> {
        let line = Line::Task(Box::new(entry));
        self.write(&line)?;
        if let Line::Task(entry) = line {
            self.remember(*entry);
        }
        Ok(())
    }

    /// As [`Journal::keep`], but not on disk: what failed is tried again next time.
    pub(crate) fn remember(&mut self, entry: Entry) {
        self.entries.insert(entry.at, entry);
    }

    /// What this campaign has so far, in its order.
    pub(crate) fn done(&self) -> impl Iterator<Item = &Done> {
        self.entries.values().map(|e| &e.done)
    }

    /// Results of other campaigns, builds or settings that the file holds too.
    pub(crate) fn others(&self) -> usize {
        let ours: BTreeSet<&str> = self.entries.values().map(|e| &*e.key).collect();
        let others = self.known.keys().filter(|key| !ours.contains(&***key));
        others.count()
    }

    /// All machines that took part.
    pub(crate) fn machines(&self) -> &[Machine] {
        &self.machines
    }

    /// A line is on the disk before the next task begins.
    fn write(&mut self, line: &Line) -> Result<(), JournalError> {
        let Some((path, file)) = &mut self.file else {
            return Ok(());
        };
        let written = serde_json::to_string(line)
            .map_err(io::Error::from)
            .and_then(|text| {
                file.write_all((text + "\n").as_bytes())?;
                file.sync_data()
            });
        Ok(written.map_err(|source| FileError::Write {
            path: path.clone(),
            source,
        })?)
    }
}

/// Every line; an error names the first that can't be read.
fn lines(path: &Path, text: &str) -> Result<Vec<Line>, JournalError> {
    let parse = |(number, line)| {
        serde_json::from_str(line).map_err(|source| JournalError::Line {
            path: path.into(),
            number: number + 1,
            source,
        })
    };
    let whole = text.rfind('\n').map_or("", |end| &text[..end]);
    whole.lines().enumerate().map(parse).collect()
}

#[cfg(test)]
mod tests;
