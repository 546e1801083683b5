//! What marks in tables mean.

use crate::presenting::terminal;

/// Marks with what they mean.
const NOTES: [(&[&str], &str); 7] = [
    (&["* "], "*: the best within this limit\n"),
    (&["≈ "], "≈: not distinguishable from the best\n"),
    (
        &["? "],
        "?: another sample count, not measured, might be better\n",
    ),
    (
        &[" < "],
        "<: this or better; it is the end of the sample counts that were measured\n",
    ),
    (
        &["n<", "n>"],
        "n<, n>: would take fewer or more samples than were measured; nothing is extrapolated\n",
    ),
    (&[" sw"], terminal::SOFTWARE),
    (&["≲ "], terminal::UPPER_BOUND),
];

/// Explains the marks that a text has.
pub(super) fn notes(text: &str) -> String {
    let has = |marks: &[&str]| marks.iter().any(|m| text.contains(m));
    let of_text = NOTES.iter().filter(|(marks, _)| has(marks));
    of_text.map(|(_, note)| *note).collect()
}
