//! The input that gives a wanted result.

use std::collections::BTreeMap;

use super::super::model::SystemFile;
use super::super::quantities::{unit, value};
use crate::case::{Attachment, Diagnostic, ReadFile, kind};

/// A wanted result met.
#[derive(Debug, Clone, PartialEq)]
pub struct Sought {
    /// The input's value.
    pub value: f64,
    /// The result there.
    pub result: f64,
    /// Systems solved.
    pub solved: usize,
    /// The file with the input.
    pub text: String,
}

/// Values tried on the way from one bound to the other, for a change of sign.
const TRIED: u32 = 24;

/// Searches a key between two values for one with which a result is as wanted: to 1e-10 of the greater of the two.
///
/// # Errors
/// Why there is none, in words: the results between the bounds do not reach it, or nothing can be solved there.
pub fn seek(
    text: &str,
    key: &str,
    (low, high): (f64, f64),
    quantity: &str,
    wanted: f64,
) -> Result<Sought, String> {
    let mut search = KeySearch {
        text,
        key,
        quantity,
        wanted,
        files: BTreeMap::new(),
        solved: 0,
        refusal: None,
    };
    let mut before: Option<(f64, f64)> = None;
    let mut range: Option<(f64, f64)> = None;
    for step in 0..=TRIED {
        let x = low + (high - low) * f64::from(step) / f64::from(TRIED);
        let Some(off) = search.off(x) else {
            before = None;
            continue;
        };
        range = Some(range.map_or((off, off), |(least, most)| (off.min(least), off.max(most))));
        if off == 0.0 {
            return search.found(x, off);
        }
        if let Some((from, at_from)) = before
            && at_from * off < 0.0
        {
            return search.between((from, at_from), (x, off));
        }
        before = Some((x, off));
    }
    let unit = unit(quantity);
    Err(match (range, search.refusal) {
        (Some((least, most)), _) => format!(
            "{quantity} comes to between {:.6} and {:.6} {unit} for {key} between {low} and {high}; {wanted} {unit} is not among these",
            wanted + least,
            wanted + most
        ),
        (None, Some(why)) => {
            format!("no system can be solved for {key} between {low} and {high}: {why}")
        }
        (None, None) => format!("no system can be solved for {key} between {low} and {high}"),
    })
}

struct KeySearch<'a> {
    text: &'a str,
    key: &'a str,
    quantity: &'a str,
    wanted: f64,
    /// The files that the text carries, with what was parsed of them.
    files: BTreeMap<String, Attachment>,
    solved: usize,
    /// Why a value could not be solved.
    refusal: Option<String>,
}

impl KeySearch<'_> {
    /// The file with the key at a value.
    fn read(&mut self, x: f64) -> Result<ReadFile<SystemFile>, String> {
        let edits = [(self.key, &*format!("{x:?}"))];
        let read = kind::read_variant::<SystemFile>(self.text, &edits, &self.files);
        let read = read.map_err(first)?;
        self.files.clone_from(&read.content.files);
        Ok(read)
    }

    /// The result less that wanted.
    fn off(&mut self, x: f64) -> Option<f64> {
        self.solved += 1;
        let solved = self.read(x).and_then(|read| read.compute().map_err(first));
        let found = solved.and_then(|solved| value(&solved, self.quantity));
        match found {
            Ok(result) if result.is_finite() => Some(result - self.wanted),
            Ok(_) => None,
            Err(why) => {
                self.refusal.get_or_insert(why);
                None
            }
        }
    }

    /// Illinois' method between two values of different sign.
    fn between(
        mut self,
        (mut a, mut at_a): (f64, f64),
        (mut b, mut at_b): (f64, f64),
    ) -> Result<Sought, String> {
        let enough = 1e-10 * self.wanted.abs().max(1e-30);
        let mut best = if at_a.abs() < at_b.abs() {
            (a, at_a)
        } else {
            (b, at_b)
        };
        for _ in 0..100 {
            if best.1.abs() <= enough || (b - a).abs() <= 4.0 * f64::EPSILON * b.abs() {
                break;
            }
            let secant = b - at_b * (b - a) / (at_b - at_a);
            let x = if secant.is_finite() && (secant - a) * (secant - b) < 0.0 {
                secant
            } else {
                0.5 * (a + b)
            };
            let Some(off) = self.off(x) else {
                return Err(format!("no system can be solved for {} = {x}", self.key));
            };
            if off.abs() < best.1.abs() {
                best = (x, off);
            }
            if off * at_b < 0.0 {
                (a, at_a) = (b, at_b);
            } else {
                at_a *= 0.5;
            }
            (b, at_b) = (x, off);
        }
        if best.1.abs() > 1e-6 * self.wanted.abs() {
            return Err(format!(
                "{} jumps past {} at {} = {}",
                self.quantity, self.wanted, self.key, best.0
            ));
        }
        self.found(best.0, best.1)
    }

    fn found(mut self, x: f64, off: f64) -> Result<Sought, String> {
        Ok(Sought {
            value: x,
            result: self.wanted + off,
            solved: self.solved,
            text: self.read(x)?.text,
        })
    }
}

/// The first fault, in words.
fn first(all: Vec<Diagnostic>) -> String {
    all.into_iter()
        .next()
        .map_or_else(String::new, |first| first.problem)
}
