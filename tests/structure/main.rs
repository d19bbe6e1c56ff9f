//! The structure of the program: which file names items of which other.
//!
//! Every file below `src` is parsed; a file that names an item defined in another has an arrow to it. What a file hands on by
//! `pub use`, what only tests name, and links of documentation are no arrows; functions called as methods are not resolved.
//! Arrows point down the floors, and files that a ring ties are few enough to be read together.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

mod arrows;
mod clarity;
mod floors;
mod manifests;
mod names;
mod rings;
mod sources;

use std::path::Path;
use std::sync::LazyLock;

use arrows::Arrows;
use sources::Sources;

/// The most files that a ring may have.
const LARGEST_RING: usize = 4;

/// The most names of types that more than one file may define: in rooms that are never read together.
const MOST_SHARED_NAMES: usize = 4;

/// The most functions that may be called `of`: where a declaration reads as a sentence with it.
const MOST_CALLED_OF: usize = 5;

/// The most lines that a function may have.
const LONGEST_FUNCTION: usize = 60;

static SOURCES: LazyLock<Sources> =
    LazyLock::new(|| Sources::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src")));

static ARROWS: LazyLock<Arrows> = LazyLock::new(|| Arrows::between_files(&SOURCES));

fn describe(rings: &[Vec<String>], arrows: &Arrows) -> String {
    let each = rings.iter().map(|ring| rings::describe(ring, arrows));
    each.collect::<Vec<_>>().join("\n")
}

#[test]
fn every_folder_of_the_sources_is_a_floor() {
    let listed = floors::FLOORS.map(str::to_owned).into_iter().collect();
    assert_eq!(
        SOURCES.floors(),
        listed,
        "`FLOORS` lists the folders of `src` from the lowest up"
    );
}

/// A path that leads nowhere is an arrow that is not seen.
#[test]
fn every_path_is_resolved() {
    let unresolved = arrows::unresolved(&SOURCES);
    assert!(
        unresolved.is_empty(),
        "these paths lead to no item:\n{}",
        unresolved.join("\n")
    );
}

#[test]
fn no_ring_has_more_than_four_files() {
    let mut rings = rings::of(&ARROWS);
    rings.retain(|ring| ring.len() > LARGEST_RING);
    assert!(
        rings.is_empty(),
        "rings of more than {LARGEST_RING} files:\n{}",
        describe(&rings, &ARROWS)
    );
}

#[test]
fn no_file_names_an_item_of_a_higher_floor() {
    let up = floors::arrows_up(&ARROWS);
    assert!(
        up.is_empty(),
        "arrows to a higher floor:\n{}",
        up.join("\n")
    );
}

#[test]
fn no_ring_ties_rooms() {
    let rooms = Arrows::between_rooms(&ARROWS);
    let rings = rings::of(&rooms);
    assert!(
        rings.is_empty(),
        "rings of rooms:\n{}",
        describe(&rings, &rooms)
    );
}

#[test]
fn types_have_names_of_their_own() {
    let shared = clarity::shared_names(&SOURCES);
    assert!(
        shared.len() <= MOST_SHARED_NAMES,
        "names of several types:\n{}",
        shared.join("\n")
    );
}

#[test]
fn functions_say_what_they_return() {
    let mut called_of = clarity::functions(&SOURCES);
    called_of.retain(|function| function.name == "of");
    let places: Vec<&str> = called_of.iter().map(|f| f.place.as_str()).collect();
    assert!(
        places.len() <= MOST_CALLED_OF,
        "functions called `of`:\n  {}",
        places.join("\n  ")
    );
}

#[test]
fn functions_have_sixty_lines_at_most() {
    let functions = clarity::functions(&SOURCES);
    let longest = functions.iter().map(|function| function.lines).max();
    assert!(
        longest.is_some_and(|lines| lines > LONGEST_FUNCTION / 2),
        "functions are found: the longest has {longest:?} lines"
    );
    let long = functions.iter().filter(|f| f.lines > LONGEST_FUNCTION);
    let long: Vec<String> = long
        .map(|f| format!("  {} {}: {} lines", f.place, f.name, f.lines))
        .collect();
    assert!(long.is_empty(), "long functions:\n{}", long.join("\n"));
}
