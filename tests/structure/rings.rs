//! Rings: files, or rooms, each of which leads to all others by arrows (strongly connected components, after Tarjan).

use std::collections::BTreeMap;
use std::fmt::Write as _;

use crate::arrows::{Arrows, words};

/// The rings of two or more, the largest first.
pub(crate) fn of(arrows: &Arrows) -> Vec<Vec<String>> {
    let mut search = Search {
        arrows,
        visited: BTreeMap::new(),
        stack: Vec::new(),
        rings: Vec::new(),
    };
    for node in arrows.0.keys() {
        if !search.visited.contains_key(node.as_str()) {
            search.visit(node);
        }
    }
    search
        .rings
        .sort_by_key(|ring| std::cmp::Reverse(ring.len()));
    search.rings
}

/// The members of a ring and the names that tie them.
pub(crate) fn describe(ring: &[String], arrows: &Arrows) -> String {
    let mut text = format!("ring of {}:\n", ring.len());
    for (from, to, names) in arrows
        .each()
        .filter(|(from, to, _)| ring.contains(from) && ring.contains(to))
    {
        writeln!(text, "  {from} -> {to}: {}", words(names)).unwrap();
    }
    text
}

struct Search<'a> {
    arrows: &'a Arrows,
    /// The lowest order of visit that each node reaches; none once its ring is complete.
    visited: BTreeMap<&'a str, Option<usize>>,
    stack: Vec<&'a str>,
    rings: Vec<Vec<String>>,
}

impl<'a> Search<'a> {
    /// Visits a node and what it leads to; returns the lowest order that these reach.
    fn visit(&mut self, node: &'a str) -> usize {
        let order = self.visited.len();
        let place = self.stack.len();
        self.visited.insert(node, Some(order));
        self.stack.push(node);
        let arrows = self.arrows;
        let mut lowest = order;
        for next in arrows.0.get(node).into_iter().flat_map(BTreeMap::keys) {
            match self.visited.get(next.as_str()) {
                None => lowest = lowest.min(self.visit(next)),
                Some(Some(order)) => lowest = lowest.min(*order),
                Some(None) => {}
            }
        }
        if lowest == order {
            self.complete(place);
        }
        lowest
    }

    /// Takes the nodes visited since `place` from the stack: they are a ring.
    fn complete(&mut self, place: usize) {
        let ring = self.stack.split_off(place);
        for node in &ring {
            self.visited.insert(node, None);
        }
        if ring.len() > 1 {
            self.rings
                .push(ring.into_iter().map(str::to_owned).collect());
        }
    }
}
