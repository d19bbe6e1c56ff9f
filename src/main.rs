//! seacable
fn main() {}
