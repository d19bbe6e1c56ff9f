//! Lists of names in words, shortened where they are long.

use super::yaml::tree::shortened;

/// Names that a message lists at most.
const LISTED: usize = 12;

/// The first of these names with commas between, and how many there are more.
pub fn listed<T: AsRef<str>>(names: &[T]) -> String {
    let first = names.iter().take(LISTED);
    let some: Vec<String> = first.map(|one| shortened(one.as_ref())).collect();
    let more = match names.len() > LISTED {
        true => format!(" and {} more", names.len() - LISTED),
        false => String::new(),
    };
    format!("{}{more}", some.join(", "))
}
