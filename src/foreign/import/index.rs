//! Rows of tables by their identifiers, so that a file of many rows is read in proportion to them.

use std::collections::HashMap;

/// Places in a list by identifier, of which `01` and 1 are the same, and letters of either case.
#[derive(Debug, Clone, Default)]
pub struct Index {
    places: HashMap<String, usize>,
}

impl Index {
    /// The index of a list of identifiers; of two that are the same the first counts.
    pub fn of_identifiers<'a>(ids: impl Iterator<Item = &'a str>) -> Self {
        let mut places = HashMap::new();
        for (place, id) in ids.enumerate() {
            places.entry(folded(id)).or_insert(place);
        }
        Self { places }
    }

    /// The place of an identifier.
    #[must_use]
    pub fn find(&self, id: &str) -> Option<usize> {
        self.places.get(&folded(id)).copied()
    }
}

/// Names of types by which rows refer to them: in the same letters, or else in letters of either case.
#[derive(Debug, Clone, Default)]
pub struct TypeIndex<'n> {
    names: Vec<&'n str>,
    exact: HashMap<&'n str, usize>,
    folded: HashMap<String, usize>,
}

impl<'n> TypeIndex<'n> {
    /// The index of a list of names.
    pub fn of_names(names: impl Iterator<Item = &'n str>) -> Self {
        let mut index = Self::default();
        for (place, name) in names.enumerate() {
            index.names.push(name);
            index.exact.entry(name).or_insert(place);
            let folded = name.to_ascii_lowercase();
            index.folded.entry(folded).or_insert(place);
        }
        index
    }

    /// The place of a name.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<usize> {
        let folded = || self.folded.get(&name.to_ascii_lowercase());
        self.exact.get(name).or_else(folded).copied()
    }

    /// The names, in their order.
    #[must_use]
    pub fn names(&self) -> &[&'n str] {
        &self.names
    }
}

fn folded(id: &str) -> String {
    match id.parse::<u64>() {
        Ok(number) => number.to_string(),
        Err(_) => id.to_ascii_lowercase(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identifiers_are_numbers_or_words() {
        let index = Index::of_identifiers(["01", "A1", "1", "anchor"].into_iter());
        let found = ["1", "001", "a1", "ANCHOR", "2"].map(|id| index.find(id));
        assert_eq!(found, [Some(0), Some(0), Some(1), Some(3), None]);
        let types = TypeIndex::of_names(["Chain", "chain", "rope"].into_iter());
        let found = ["chain", "CHAIN", "Rope", "wire"].map(|name| types.find(name));
        assert_eq!(found, [Some(1), Some(0), Some(2), None]);
    }
}
