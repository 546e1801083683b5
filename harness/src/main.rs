//! The `interreflect` command.
fn main() {}
