//! The command `brt`.
fn main() {}
