//! Messages that fit a screen.

use crate::ensure;
use crate::variants::Outcome;

/// Lines of a message at most.
const LINES: usize = 20;

/// Characters of a message at most: twenty more lines of a screen, where all stand on one.
const CHARACTERS: usize = 2000;

/// A message as it is, or its beginning and how much is left out.
pub(crate) fn brief(message: &str) -> String {
    let lines = message.split_inclusive('\n').take(LINES);
    let by_lines: usize = lines.map(str::len).sum();
    let by_characters = message.char_indices().nth(CHARACTERS);
    let end = by_characters.map_or(by_lines, |(at, _)| at.min(by_lines));
    match message[end..].chars().count() {
        0 => message.to_owned(),
        more => format!(
            "{}\n… and {more} characters more",
            message[..end].trim_end()
        ),
    }
}

/// Whatever is said, forty lines of a hundred characters hold it, and short messages stay whole.
pub(super) fn messages_fit_a_screen() -> Outcome {
    for message in ["", "one line", "two\nlines\n", "ä → b"] {
        ensure!(brief(message) == message, "`{message}` is changed");
    }
    for message in [
        "1.25, ".repeat(10_000),
        "→".repeat(5000),
        "a line\n".repeat(300),
    ] {
        let told = brief(&message);
        let rows: usize = told.lines().map(|l| 1 + l.chars().count() / 100).sum();
        ensure!(rows <= 42, "{rows} rows of a screen");
        let begins: String = message.chars().take(100).collect();
        ensure!(told.starts_with(&begins), "the beginning is missing");
        ensure!(
            told.ends_with("characters more"),
            "nothing tells of the rest"
        );
    }
    Ok(())
}
