//! Pads text to a width of any size: the formats of the standard library (`{:>width$}`) panic where it is above 65,535.

/// So many blanks.
pub fn blanks(count: usize) -> String {
    " ".repeat(count)
}

/// The text at the left of so many characters; as it is where it is longer.
pub fn at_left(text: &str, width: usize) -> String {
    let after = width.saturating_sub(text.chars().count());
    format!("{text}{}", blanks(after))
}

/// The text at the right of so many characters; as it is where it is longer.
pub fn at_right(text: &str, width: usize) -> String {
    let before = width.saturating_sub(text.chars().count());
    format!("{}{text}", blanks(before))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::read::tests::sources;
    use std::path::Path;

    #[test]
    fn any_width_is_padded() {
        assert_eq!(at_left("é", 3), "é  ");
        assert_eq!(at_right("é", 3), "  é");
        assert_eq!(at_right("long", 3), "long");
        assert_eq!(at_left("a", 100_000).len(), 100_000);
        assert_eq!(at_right("a", 100_000).len(), 100_000);
    }

    /// The width that a format takes from a name, `{:>width$}` or `{:1$}`; not the decimals, `{:.decimals$}`, which are few.
    fn width_by_name(format: &str) -> Option<&str> {
        let (_, rules) = format.split_once(':')?;
        let (rules, _) = rules.split_once('$')?;
        let is_format = rules
            .chars()
            .all(|c| c.is_alphanumeric() || "_<>^+-#. ".contains(c));
        (is_format && !rules.contains('.')).then_some(rules)
    }

    #[test]
    fn no_format_takes_its_width_from_a_number() {
        let mut all = Vec::new();
        sources(
            Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap(),
            &mut all,
        );
        // Digits of a number of load cases.
        let known = ["src/studies/study/sweep/runs.rs"];
        for (file, text) in all {
            let code = text
                .lines()
                .filter(|line| !line.trim_start().starts_with("//"));
            for part in code.flat_map(|line| line.split('{').skip(1)) {
                let inner = part.split('}').next().unwrap_or_default();
                let is_known = known.iter().any(|known| file.ends_with(known));
                assert!(
                    is_known || width_by_name(inner).is_none(),
                    "{file}: {{{inner}}}: use `padding`"
                );
            }
        }
    }
}
