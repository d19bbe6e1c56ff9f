//! The sections of the line as a system has them: cut where floats or modules begin and end, and where clumps hang between the ends.

use super::source::{BESIDE, LETTERS, LINE, LineSource};
use crate::case::{Case, Clump, EndKind, Floats, Modules, Section};
use crate::import::fault::Fault;

/// Share of a segment by which a place may be off a node.
const OFF_NODE: f64 = 1e-6;

/// A part of a section.
pub(super) struct Stretch<'c> {
    /// The number of its section.
    pub(super) section: usize,
    /// Unstretched length \[m\].
    pub(super) length_m: f64,
    /// Segments.
    pub(super) segments: usize,
    /// Whether it is the whole section.
    pub(super) is_whole: bool,
    /// Floats on it.
    pub(super) floats: Vec<&'c Floats>,
    /// Modules on it.
    pub(super) modules: Vec<&'c Modules>,
    /// The body at its end towards B.
    pub(super) clump: Option<&'c Clump>,
    /// Whether the body that travels begins at its end towards B, where the line becomes two.
    pub(super) meets_traveller: bool,
}

impl Stretch<'_> {
    /// Whether it is of the material of its section as it is.
    pub(super) fn is_bare(&self) -> bool {
        self.floats.is_empty() && self.modules.is_empty()
    }
}

/// Fewest segments of a line that does not state those of its sections.
const FEWEST: usize = 8;

/// Whether the line is of one section that needs no table of its own.
pub(super) fn is_one(line: &[Stretch<'_>]) -> bool {
    matches!(line, [only] if only.segments >= FEWEST)
}

/// The lines of the system with their names and the numbers of their first stretches: one, or two that meet at the body that travels.
pub(super) fn lines<'l, 'c>(
    line: &'l [Stretch<'c>],
) -> Vec<(&'static str, usize, &'l [Stretch<'c>])> {
    match line.iter().position(|stretch| stretch.meets_traveller) {
        Some(last) => {
            let (before, behind) = line.split_at(last + 1);
            vec![(BESIDE[0], 0, before), (BESIDE[1], last + 1, behind)]
        }
        None => vec![(LINE, 0, line)],
    }
}

/// The name of the line that a stretch is of, and its number there, from 1, by that of all, from 0.
pub(super) fn in_lines(line: &[Stretch<'_>], number: usize) -> (&'static str, usize) {
    let lines = lines(line).into_iter().rev();
    let mut begun = lines.filter(|(_, first, _)| *first <= number);
    begun.next().map_or((LINE, number + 1), |(name, first, _)| {
        (name, number - first + 1)
    })
}

/// The name of the line at an end, by its letter.
pub(super) fn line_at(line: &[Stretch<'_>], letter: &str) -> &'static str {
    let all = lines(line);
    let at = if letter == LETTERS[0] {
        all.first()
    } else {
        all.last()
    };
    at.map_or(LINE, |(name, _, _)| name)
}

/// The stretches of the line from end A to end B.
///
/// # Errors
/// What does not begin or end at a node of the mesh, or hangs where another body does.
pub(super) fn stretches<'c>(source: &'c LineSource<'_>) -> Result<Vec<Stretch<'c>>, Vec<Fault>> {
    let case = &source.case;
    let mut faults = Vec::new();
    let mut found: Vec<Stretch<'c>> = Vec::new();
    for (number, section) in case.line.iter().enumerate() {
        let mut nodes = vec![0, section.segments];
        for (path, place) in borders(case, section) {
            match node(section, place) {
                Some(node) => nodes.push(node),
                None => faults.push(off_node(source, &path)),
            }
        }
        let hung = case
            .clumps
            .iter()
            .filter(|clump| clump.section == section.name && end_of(case, clump).is_none());
        let hung: Vec<(usize, &Clump)> =
            hung.map(|clump| (nearest(section, clump), clump)).collect();
        nodes.extend(hung.iter().map(|(node, _)| *node));
        nodes.sort_unstable();
        nodes.dedup();
        if nodes.len() > 2 {
            let keys = ["length_m", "segments"].map(|key| ["line", section.name.as_str(), key]);
            faults.extend(
                keys.iter()
                    .filter_map(|path| source.fault_of_expression(path)),
            );
        }
        for (node, clump) in &hung {
            if let (0, Some(before)) = (*node, found.last_mut()) {
                faults.extend(hang(source, before, clump));
            }
        }
        for pair in nodes.windows(2) {
            let mut stretch = part(case, (number, section), pair[0], pair[1]);
            for (_, clump) in hung.iter().filter(|(node, _)| *node == pair[1]) {
                faults.extend(hang(source, &mut stretch, clump));
            }
            found.push(stretch);
        }
    }
    match faults.is_empty() {
        true => Ok(found),
        false => Err(faults),
    }
}

/// Where floats and modules of a section begin and end \[m\], with their keys.
fn borders(case: &Case, section: &Section) -> Vec<([String; 3], f64)> {
    let floats = case
        .floats
        .iter()
        .map(|of| ("floats", &of.section, of.from_m, of.to_m));
    let modules = case
        .modules
        .iter()
        .map(|of| ("modules", &of.section, of.from_m, of.to_m));
    let own = floats
        .chain(modules)
        .filter(|(_, of, _, _)| **of == section.name);
    own.flat_map(|(table, of, from, to)| {
        let key = |key: &str| [table.to_owned(), of.clone(), key.to_owned()];
        let to = to.unwrap_or(section.length_m).min(section.length_m);
        [(key("from_m"), from), (key("to_m"), to)]
    })
    .collect()
}

/// The node at a place of a section; nothing where there is none.
fn node(section: &Section, place_m: f64) -> Option<usize> {
    let at = place_m / section.length_m * section.segments as f64;
    let node = at.round();
    ((at - node).abs() <= OFF_NODE).then(|| whole(node, section))
}

/// The letter of the end of the line that a clump hangs at; nothing between the ends.
pub(super) fn end_of(case: &Case, clump: &Clump) -> Option<&'static str> {
    let number = case.line.iter().position(|one| one.name == clump.section)?;
    let section = &case.line[number];
    match nearest(section, clump) {
        0 if number == 0 => Some(LETTERS[0]),
        node if node == section.segments && number + 1 == case.line.len() => Some(LETTERS[1]),
        _ => None,
    }
}

/// The clumps at an end, by its letter.
pub(super) fn at_end<'c>(
    source: &'c LineSource<'_>,
    letter: &'static str,
) -> impl Iterator<Item = &'c Clump> {
    let case = &source.case;
    let clumps = case.clumps.iter();
    clumps.filter(move |clump| end_of(case, clump) == Some(letter))
}

/// The clump that is the body of a free end.
pub(super) fn on_free_end<'c>(source: &'c LineSource<'_>, letter: &str) -> Option<&'c Clump> {
    let ends = &source.case.ends;
    let (letter, end) = match letter == LETTERS[0] {
        true => (LETTERS[0], &ends.a),
        false => (LETTERS[1], &ends.b),
    };
    at_end(source, letter)
        .next()
        .filter(|_| end.kind == EndKind::Free)
}

/// The node that a clump hangs at: the nearest.
fn nearest(section: &Section, clump: &Clump) -> usize {
    whole(
        (clump.at_m / section.length_m * section.segments as f64).round(),
        section,
    )
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a number of a node, between 0 and the segments of its section"
)]
fn whole(node: f64, section: &Section) -> usize {
    (node.max(0.0) as usize).min(section.segments)
}

/// The part of a section between two of its nodes.
fn part<'c>(
    case: &'c Case,
    (number, section): (usize, &'c Section),
    from: usize,
    to: usize,
) -> Stretch<'c> {
    let each = section.length_m / section.segments as f64;
    let middle = 0.5 * each * (from + to) as f64;
    let covers = |of: &str, begin: f64, end: Option<f64>| {
        of == section.name && begin < middle && middle < end.unwrap_or(section.length_m)
    };
    let floats = case.floats.iter();
    let modules = case.modules.iter();
    let segments = to - from;
    Stretch {
        section: number,
        length_m: section.length_m * segments as f64 / section.segments as f64,
        segments,
        is_whole: segments == section.segments,
        floats: floats
            .filter(|of| covers(&of.section, of.from_m, of.to_m))
            .collect(),
        modules: modules
            .filter(|of| covers(&of.section, of.from_m, of.to_m))
            .collect(),
        clump: None,
        meets_traveller: false,
    }
}

/// Hangs a clump at the end of a stretch, where none hangs yet.
fn hang<'c>(source: &LineSource<'_>, stretch: &mut Stretch<'c>, clump: &'c Clump) -> Option<Fault> {
    if stretch.clump.is_some() {
        let path = ["clumps", &clump.name, "at_m"];
        let problem = "hangs where another body does, and a system has one there";
        return Some(source.fault(&path, problem, "make one body of both"));
    }
    stretch.clump = Some(clump);
    None
}

fn off_node(source: &LineSource<'_>, path: &[String; 3]) -> Fault {
    let path = [&*path[0], &*path[1], &*path[2]];
    let problem = "lies between two nodes of the mesh, and a section of a system begins at one";
    source.fault(
        &path,
        problem,
        "choose the segments of the section so that a node lies there",
    )
}
