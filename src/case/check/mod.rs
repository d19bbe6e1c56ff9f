//! Checks of a case file. [`keys`] holds every table and value against the table of fields;
//! [`mod@line`], [`rope`], [`loads`], [`turning`], [`sea`], [`start`], [`claims`] and [`trials`] hold values against each
//! other. Every check works on the tree of the file and passes over what is missing or malformed, so that all faults are told at once,
//! each at its place.

mod claims;
mod keys;
mod line;
mod loads;
mod paths;
mod rope;
mod sea;
mod spans;
mod start;
mod trials;
mod turning;

use super::diagnostic::Finding;
use super::fields::CASE;
use super::tree::Node;

pub(crate) use keys::{check as check_keys, fields_here};
pub(crate) use paths::unknown_path;

/// Everything wrong with the file, in the order of its lines.
pub(crate) fn check(root: &Node) -> Vec<Finding> {
    let mut found = keys::check(&CASE, root);
    found.extend(line::check(root));
    found.extend(rope::check(root));
    found.extend(loads::check(root));
    found.extend(turning::check(root));
    found.extend(sea::check(root));
    found.extend(start::check(root));
    found.extend(claims::check(root));
    found.extend(trials::check(root));
    found.sort_by_key(|finding| finding.span.start);
    found
}
