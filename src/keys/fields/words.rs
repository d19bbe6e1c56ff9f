//! Key paths, and the words of a message about a key that nobody knows.

use strsim::osa_distance;

use super::{Field, Schema, either, unit_suffix};

/// A key path as its parts; parts with dots stand in quotes. Nothing when it is malformed.
pub fn split(path: &str) -> Option<Vec<String>> {
    let mut parts = vec![String::new()];
    let mut quote: Option<char> = None;
    for letter in path.trim().chars() {
        match quote {
            Some(q) if letter == q => quote = None,
            Some(_) => parts.last_mut()?.push(letter),
            None if letter == '"' || letter == '\'' => quote = Some(letter),
            None if letter == '.' => parts.push(String::new()),
            None => parts.last_mut()?.push(letter),
        }
    }
    let whole = quote.is_none() && parts.iter().all(|part| !part.is_empty());
    whole.then_some(parts)
}

/// The key path of these parts.
pub fn join<S: AsRef<str>>(parts: &[S]) -> String {
    let quoted = parts.iter().map(|part| {
        let part = part.as_ref();
        let plain = !part.is_empty() && part.chars().all(is_name_letter);
        if plain {
            part.to_owned()
        } else {
            format!("\"{part}\"")
        }
    });
    quoted.collect::<Vec<_>>().join(".")
}

/// Longest name \[characters\].
pub(super) const LONGEST_NAME: usize = 100;

/// Whether a word may be the name of a part: of a section, an end, a material.
pub fn is_name(word: &str) -> bool {
    !word.is_empty() && word.chars().count() <= LONGEST_NAME && word.chars().all(is_name_letter)
}

/// Letters of names that become part of channel names and key paths.
pub(super) fn is_name_letter(letter: char) -> bool {
    letter.is_alphanumeric() || matches!(letter, '-' | '_')
}

/// No word that is meant is longer \[characters\].
const LONGEST_WORD: usize = 64;

/// The candidate that was probably meant, if one is near enough.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    // The distance of two words takes time and memory by the product of their lengths.
    let length = word.chars().take(LONGEST_WORD + 1).count();
    if length > LONGEST_WORD {
        return None;
    }
    let lower = word.to_lowercase();
    let allowed = (length / 3).max(1);
    candidates
        .into_iter()
        .filter(|candidate| candidate.len() <= 4 * LONGEST_WORD)
        .map(|candidate| (osa_distance(&lower, &candidate.to_lowercase()), candidate))
        .filter(|(distance, _)| *distance <= allowed)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// What to say about a key that its table does not know.
pub struct UnknownKey {
    pub problem: String,
    pub remedy: String,
    /// The key that was meant, when that is clear; it is then not reported as missing too.
    pub meant: Option<&'static str>,
}

/// A key that the table of this pattern does not know. `known` are the fields it may have here.
pub fn unknown_key(
    schema: &Schema,
    key: &str,
    known: &[&'static Field],
    tables: &[&str],
) -> UnknownKey {
    if let Some(field) = with_unit(schema, key, known) {
        return unit_slip(key, field);
    }
    let names = known
        .iter()
        .map(|field| field.key())
        .chain(tables.iter().copied());
    if let Some(near) = nearest(key, names) {
        let meant = known
            .iter()
            .map(|field| field.key())
            .find(|name| *name == near);
        return UnknownKey {
            problem: "is not a known key".to_owned(),
            remedy: format!("did you mean `{near}`?"),
            meant,
        };
    }
    let remedy = elsewhere(schema, key).unwrap_or_else(|| {
        let names: Vec<&str> = known
            .iter()
            .map(|field| field.key())
            .chain(tables.iter().copied())
            .collect();
        format!(
            "the keys known here are {}",
            either(&names).replace(" or ", " and ")
        )
    });
    UnknownKey {
        problem: "is not a known key".to_owned(),
        remedy,
        meant: None,
    }
}

/// The field meant by a key that lacks its unit or has another one.
fn with_unit(schema: &Schema, key: &str, known: &[&'static Field]) -> Option<&'static Field> {
    let has_unit = |field: &&&'static Field| field.stem() != field.key();
    let bare = known
        .iter()
        .filter(has_unit)
        .find(|field| field.stem() == key);
    let other = || {
        known
            .iter()
            .filter(has_unit)
            .filter(|field| {
                let rest = key.strip_prefix(field.stem());
                rest.and_then(|rest| rest.strip_prefix('_'))
                    .is_some_and(|suffix| is_unit(schema, suffix))
            })
            .max_by_key(|field| field.stem().len())
    };
    bare.or_else(other).copied()
}

/// Units people put into key names, the right ones among them.
fn is_unit(schema: &Schema, suffix: &str) -> bool {
    const OTHERS: &str = "mm cm km ft in inch min h ms kn mn gn lbf kgf tf t te g lb mt rad degrees knots kt \
        km_per_h cm2 mm2 cm3 l t_per_m g_per_m n_per_m kn_per_m kn_s ns mps seconds metres \
        meters newton newtons pa gpa mpa g_per_cm3 t_per_m3";
    let known = schema
        .fields
        .iter()
        .any(|field| unit_suffix(field.unit) == Some(suffix));
    known || OTHERS.split(' ').any(|other| other == suffix)
}

fn unit_slip(key: &str, field: &'static Field) -> UnknownKey {
    let (right, unit) = (field.key(), field.unit);
    let problem = if key == field.stem() {
        "has no unit in its name".to_owned()
    } else {
        "has the wrong unit in its name".to_owned()
    };
    UnknownKey {
        problem,
        remedy: format!("write `{right}`, with the value in {unit}"),
        meant: Some(right),
    }
}

/// Where else a key of this name belongs.
fn elsewhere(schema: &Schema, key: &str) -> Option<String> {
    let field = schema.fields.iter().find(|field| field.key() == key)?;
    Some(format!(
        "`{key}` belongs in `{}`",
        field.table().replace(".*", "")
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_split_and_join() {
        let parts = split("marks.\"payload.drag_area_m2\".status").unwrap();
        assert_eq!(parts, ["marks", "payload.drag_area_m2", "status"]);
        assert_eq!(join(&parts), "marks.\"payload.drag_area_m2\".status");
        assert_eq!(split("a..b"), None);
        assert_eq!(split("a.\"b"), None);
        assert_eq!(split(""), None);
    }

    #[test]
    fn near_words() {
        assert_eq!(nearest("chian", ["chain", "wire"]), Some("chain"));
        assert_eq!(
            nearest("lenght_m", ["length_m", "segments"]),
            Some("length_m")
        );
        assert_eq!(nearest("colour", ["chain", "wire"]), None);
    }
}
