//! The lines of the system: one, or two that meet at a body that travels along the line.

use super::source::{BESIDE, LINE};
use crate::case::{Case, LineEnd, Section, Traveller};

/// Fewest segments of a line that does not state those of its sections.
const FEWEST: usize = 8;

/// A line of the system.
pub(super) struct ConvertedLine<'c> {
    /// Its name.
    pub(super) name: &'static str,
    /// Its sections from end A to end B.
    pub(super) sections: Vec<ConvertedSection<'c>>,
}

/// A section of a line of the system.
#[derive(Clone, Copy)]
pub(super) struct ConvertedSection<'c> {
    /// The section of the case.
    pub(super) of: &'c Section,
    /// What of it is on this side of the body that travels: length \[m\] and segments; nothing where all of it is.
    pub(super) part: Option<(f64, usize)>,
}

impl ConvertedLine<'_> {
    /// Whether it is one section that needs no table of its own, nor a name.
    pub(super) fn is_one(&self) -> bool {
        let segments =
            |only: &ConvertedSection<'_>| only.part.map_or(only.of.segments, |part| part.1);
        matches!(self.sections.as_slice(), [only] if segments(only) >= FEWEST)
    }

    fn has(&self, section: &str) -> bool {
        self.sections.iter().any(|own| own.of.name == section)
    }
}

/// Where a body that travels parts the line.
pub(super) struct Parting {
    /// The section in which it does, by its number.
    pub(super) section: usize,
    /// Length of that towards end A \[m\], and its segments.
    pub(super) before: (f64, usize),
    /// Arc lengths between which a point hauled within the section stays \[m\].
    pub(super) within: [f64; 2],
}

/// Where a body parts the line; nothing where it begins less than a segment from where a section ends.
pub(super) fn parting(case: &Case, body: &Traveller) -> Option<Parting> {
    let mut begins = 0.0;
    for (number, section) in case.line.iter().enumerate() {
        let ends = begins + section.length_m;
        if body.from_m < ends {
            let each = section.length_m / section.segments as f64;
            let within = [begins + each, ends - each];
            let before = body.from_m - begins;
            let segments = nearest(before / each).clamp(1, section.segments.max(2) - 1);
            let stays = within[0] <= body.from_m && body.from_m <= within[1];
            return stays.then_some(Parting {
                section: number,
                before: (before, segments),
                within,
            });
        }
        begins = ends;
    }
    None
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a count of segments, at most those of the section"
)]
fn nearest(count: f64) -> usize {
    count.round().max(0.0) as usize
}

/// The lines of the system of a case.
pub(super) fn lines(case: &Case) -> Vec<ConvertedLine<'_>> {
    let whole = |of| ConvertedSection { of, part: None };
    let body = case.traveller.as_ref();
    let Some(parting) = body.and_then(|body| parting(case, body)) else {
        return vec![ConvertedLine {
            name: LINE,
            sections: case.line.iter().map(whole).collect(),
        }];
    };
    let of = &case.line[parting.section];
    let (length, segments) = parting.before;
    let part = |part| {
        let part = Some(part);
        std::iter::once(ConvertedSection { of, part })
    };
    let behind = (of.length_m - length, of.segments - segments);
    let before = case.line[..parting.section].iter().map(whole);
    let after = case.line[parting.section + 1..].iter().map(whole);
    vec![
        ConvertedLine {
            name: BESIDE[0],
            sections: before.chain(part(parting.before)).collect(),
        },
        ConvertedLine {
            name: BESIDE[1],
            sections: part(behind).chain(after).collect(),
        },
    ]
}

/// The line that an end of a section of the case is on.
pub(super) fn line_of<'c>(
    case: &'c Case,
    section: &str,
    end: LineEnd,
) -> Option<ConvertedLine<'c>> {
    let mut all = lines(case).into_iter().filter(|line| line.has(section));
    match end {
        LineEnd::A => all.next(),
        LineEnd::B => all.next_back(),
    }
}

/// The name of the line at an end of the case.
pub(super) fn line_at(case: &Case, end: LineEnd) -> &'static str {
    let all = lines(case);
    let at = match end {
        LineEnd::A => all.first(),
        LineEnd::B => all.last(),
    };
    at.map_or(LINE, |line| line.name)
}
