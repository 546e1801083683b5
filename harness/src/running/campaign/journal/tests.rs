use super::*;
use crate::domain::record::Backend;

fn entry(at: usize) -> Entry {
    let run = Run::new("room", format!("method{at}"), Backend::Cpu, "irradiance");
    Entry {
        key: format!("key{at}"),
        at,
        done: Done::Run(Box::new(run)),
    }
}

#[test]
fn a_half_written_line_is_dropped_and_the_rest_is_there() -> Result<(), JournalError> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(NAME);
    let mut journal = Journal::open(folder.path())?;
    for at in 0..3 {
        journal.keep(entry(at))?;
    }
    drop(journal);
    let whole = fs::read(&path).expect("the file");
    // Wherever the last line breaks off, the two before it are kept, and the next is written whole.
    let second_ends = whole[..whole.len() - 1]
        .iter()
        .rposition(|b| *b == b'\n')
        .expect("lines");
    for end in [
        second_ends + 1,
        second_ends + 2,
        whole.len() - 40,
        whole.len() - 1,
    ] {
        fs::write(&path, &whole[..end]).expect("written");
        let mut journal = Journal::open(folder.path())?;
        assert!(journal.has("key0", 0) && journal.has("key1", 1) && !journal.has("key2", 2));
        journal.keep(entry(2))?;
        drop(journal);
        assert_eq!(fs::read(&path).expect("the file"), whole);
    }
    Ok(())
}

/// A process that is being started holds copies of all files until it has begun.
#[test]
fn a_closed_journal_is_free_though_a_copy_of_its_file_is_open() -> Result<(), JournalError> {
    let folder = tempfile::tempdir().expect("a folder");
    let journal = Journal::open(folder.path())?;
    let (_, file) = journal.file.as_ref().expect("a file");
    let copy = file.try_clone().expect("a copy");
    drop(journal);
    Journal::open(folder.path())?;
    drop(copy);
    Ok(())
}

#[test]
fn a_damaged_line_is_named_and_a_second_writer_refused() -> Result<(), JournalError> {
    let folder = tempfile::tempdir().expect("a folder");
    let journal = Journal::open(folder.path())?;
    assert!(matches!(
        Journal::open(folder.path()),
        Err(JournalError::InUse { .. })
    ));
    drop(journal);
    fs::write(folder.path().join(NAME), "{\"machine\":3}\n{}\n").expect("written");
    let error = Journal::open(folder.path())
        .err()
        .expect("an error")
        .to_string();
    assert!(
        error.contains("journal.jsonl, line 1") && error.contains("delete"),
        "{error}"
    );
    Ok(())
}
