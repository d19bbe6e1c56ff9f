//! Whatever stands in a file, reading and editing it ends with a case or with diagnostics.

use proptest::prelude::*;
use seacable::case::{self, CASE, Case, edit, kind};

const MANIFOLD: &str = include_str!("../../cases/pendulous/manifold.toml");
const MODULE: &str = include_str!("../../cases/pendulous/module.toml");

/// Pieces that a slip of the hand, or a tired evening, puts into a case.
const PIECES: &[&str] = &[
    "",
    "\n",
    "=",
    "[",
    "]",
    "[[",
    "]]",
    "{",
    "}",
    "\"",
    "'",
    "\"\"\"",
    "#",
    ".",
    ",",
    "-",
    "nan",
    "inf",
    "1e400",
    "-0",
    "0",
    "\u{e9}",
    "\u{feff}",
    "\r",
    "\0",
    "[line]",
    "[[line]]",
    "[ends.b]",
    "name = \"wire\"\n",
    "kind = \"free\"\n",
    "[payload]\n",
    "true",
    "1979-05-27",
    "99999999999999999999",
    "position_m = [0, 0]\n",
    "depth_m = []\n",
    "line = 5\n",
    "[materials]\n",
    "[[materials]]\n",
];

fn boundary(text: &str, at: usize) -> usize {
    (0..=at.min(text.len()))
        .rev()
        .find(|&at| text.is_char_boundary(at))
        .unwrap_or(0)
}

/// A case with stretches cut out and pieces put in.
fn mutated() -> impl Strategy<Value = String> {
    let cut = (
        any::<prop::sample::Index>(),
        0usize..40,
        prop::sample::select(PIECES),
    );
    (
        prop::sample::select(&[MANIFOLD, MODULE][..]),
        prop::collection::vec(cut, 1..5),
    )
        .prop_map(|(text, cuts)| {
            cuts.into_iter()
                .fold(text.to_owned(), |text, (at, length, piece)| {
                    let from = boundary(&text, at.index(text.len() + 1));
                    let to = boundary(&text, from + length).max(from);
                    [&text[..from], piece, &text[to..]].concat()
                })
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn mutated_text_is_read_or_refused(text in mutated()) {
        match case::parse(&text, "mutated") {
            Ok(_) => prop_assert!(!kind::rows::<Case>(&text).is_empty()),
            Err(faults) => {
                prop_assert!(!faults.is_empty());
                for fault in &faults {
                    prop_assert!(fault.line >= 1 && fault.column >= 1);
                    prop_assert!(text.get(fault.span.clone()).is_some());
                    prop_assert!(!fault.problem.is_empty() && !fault.remedy.is_empty());
                    prop_assert!(!fault.to_string().contains('\n'), "{}", fault);
                    prop_assert!(!fault.render(false).is_empty());
                }
            }
        }
    }

    #[test]
    fn any_value_for_any_key_is_set_or_refused(
        field in prop::sample::select(CASE.fields.to_vec()),
        name in prop::sample::select(&["chain", "polyester", "wire", "payload.drag_area_m2", "current"][..]),
        value in prop_oneof!["\\PC{0,12}", "-?[0-9]{1,4}(\\.[0-9]{1,3})?", "\\[[0-9., ]{0,12}\\]"],
    ) {
        let quoted = if name.contains('.') { format!("\"{name}\"") } else { name.to_owned() };
        let path = field.path.replace('*', &quoted);
        if let Ok(edited) = edit::set(MODULE, &path, &value) {
            prop_assert!(case::parse(&edited, "edited").is_ok(), "{} = {}", path, value);
            let held = edit::get(&edited, &path).unwrap_or_default();
            prop_assert!(held == value.trim() || value.contains('"') || value.contains('\'') || value.contains('#'), "{} for {}", held, value);
        }
    }

    #[test]
    fn any_text_is_read_or_refused(text in "\\PC{0,200}") {
        prop_assert!(case::parse(&text, "any").is_err());
    }
}
