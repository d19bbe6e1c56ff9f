//! Why random systems are refused, by how often.

/// Reasons without their numbers and names, and how often each is given, the most frequent first.
pub(super) fn frequent<'a>(reasons: impl Iterator<Item = &'a str>) -> Vec<(String, usize)> {
    let mut found: Vec<(String, usize)> = Vec::new();
    for reason in reasons {
        let plain = without_numbers(reason);
        match found.iter_mut().find(|(known, _)| *known == plain) {
            Some((_, many)) => *many += 1,
            None => found.push((plain, 1)),
        }
    }
    found.sort_by_key(|(_, many)| std::cmp::Reverse(*many));
    found
}

fn without_numbers(reason: &str) -> String {
    let words = reason.split(' ').map(|word| {
        let named = word.starts_with('"');
        if named || word.chars().any(|c| c.is_ascii_digit()) {
            "#"
        } else {
            word
        }
    });
    words.collect::<Vec<_>>().join(" ")
}
