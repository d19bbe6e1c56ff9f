//! The line as a whole: materials its sections name, names of sections, ends and bodies, floats and bodies inside their
//! section or on the line.

use super::{unknown, used_twice};
use crate::case::diagnostic::Finding;
use crate::case::fields::quantity;
use crate::case::model::{CaseKeys, ClumpKeys, FloatsKeys, ModulesKeys};
use crate::case::schema::{Key, KeyValue};
use crate::limits::SEGMENTS;

/// Checks of sections and of what sits on them.
pub(super) fn check(case: &CaseKeys<'_>) -> Vec<Finding> {
    let mut found = materials(case);
    found.extend(names(case));
    let sections: Vec<CheckedSection<'_>> = case
        .line
        .iter()
        .map(|(name, section)| (Some(name.as_str()), section.length_m.value()))
        .collect();
    let attached = (&case.floats[..], &case.modules[..], &case.clumps[..]);
    found.extend(of_attachments(&sections, "case", attached));
    found.extend(travels(case));
    found.extend(segments(case));
    found
}

/// A drag area or added mass that a body has whichever way it is passed, beside those across and along its line.
pub fn stated_twice<T: KeyValue>(
    what: &str,
    all_around: &Key<'_, T>,
    aligned: [&Key<'_, f64>; 2],
) -> Option<Finding> {
    let beside = aligned.into_iter().find(|key| key.is_given())?;
    let problem = format!("is given beside `{}`", beside.name());
    let remedy =
        format!("leave it out for {what} across and along the line, or leave these two out");
    all_around.if_given(problem, remedy)
}

/// More segments than a scene may have.
fn segments(case: &CaseKeys<'_>) -> Option<Finding> {
    let counts = case
        .line
        .iter()
        .filter_map(|(_, section)| section.segments.value());
    let total = counts.sum::<usize>() as f64;
    let (_, last) = case.line.last()?;
    SEGMENTS.is_exceeded_by(total).then(|| {
        let problem = format!("the line has {total} segments in all");
        let remedy = SEGMENTS.remedy("divide it into fewer", total);
        last.segments.finding(problem, remedy)
    })
}

/// Unstretched length of the line \[m\], where that of every section is known.
pub(super) fn length(case: &CaseKeys<'_>) -> Option<f64> {
    let lengths = case
        .line
        .iter()
        .map(|(_, section)| section.length_m.value());
    let lengths: Option<Vec<f64>> = lengths.collect();
    lengths.map(|lengths| lengths.iter().sum())
}

fn materials(case: &CaseKeys<'_>) -> Vec<Finding> {
    // A case without materials has a finding of its own.
    if case.place.node.get("materials").is_none() {
        return Vec::new();
    }
    let known = super::names(case.place.node, "materials");
    let sections = case.line.iter();
    sections
        .filter_map(|(_, section)| unknown(&section.material, &known, "material", "case"))
        .collect()
}

/// Sections, ends and bodies share channel names, so no two of them may be called the same.
fn names(case: &CaseKeys<'_>) -> Vec<Finding> {
    let sections = case.line.iter().map(|(_, section)| &section.name);
    let clumps = case.clumps.iter().map(|(_, clump)| &clump.name);
    let all = sections
        .chain(case.each_end().map(|end| &end.name))
        .chain(clumps)
        .chain(case.traveller.iter().map(|traveller| &traveller.name));
    used_twice(
        all,
        "give every section, every end and every body on the line a name of its own",
    )
}

/// A section that something may be attached to: its name, where it has one, and its length \[m\], where that is known.
pub type CheckedSection<'k> = (Option<&'k str>, Option<f64>);

/// Tables of a list, by their names.
type NamedTable<K> = [(String, K)];

/// Checks of floats, modules and bodies on the sections of a line of a kind of file.
pub fn of_attachments(
    sections: &[CheckedSection<'_>],
    of: &str,
    (floats, modules, clumps): (
        &NamedTable<FloatsKeys<'_>>,
        &NamedTable<ModulesKeys<'_>>,
        &NamedTable<ClumpKeys<'_>>,
    ),
) -> Vec<Finding> {
    let line = CheckedLine { sections, of };
    let floats = floats.iter().map(|(_, f)| (&f.section, &f.from_m, &f.to_m));
    let modules = modules
        .iter()
        .map(|(_, m)| (&m.section, &m.from_m, &m.to_m));
    let stretches = floats.chain(modules);
    let mut found: Vec<Finding> = stretches
        .filter_map(|(section, from, to)| line.stretch(section, from, to))
        .collect();
    for (_, clump) in clumps {
        found.extend(line.place(&clump.section, &clump.at_m));
        let aligned = [&clump.drag_area_normal_m2, &clump.drag_area_tangential_m2];
        found.extend(stated_twice("drag", &clump.drag_area_m2, aligned));
        let aligned = [&clump.added_mass_normal_kg, &clump.added_mass_tangential_kg];
        found.extend(stated_twice("added mass", &clump.added_mass_kg, aligned));
    }
    found
}

/// The sections of a line, and the kind of file that they are in.
struct CheckedLine<'k> {
    sections: &'k [CheckedSection<'k>],
    of: &'k str,
}

impl CheckedLine<'_> {
    /// The length of the section that a key names \[m\], or of the only one; a finding where there is no such section.
    fn section_length(&self, key: &Key<'_, String>) -> Result<Option<f64>, Finding> {
        let known: Vec<&str> = self.sections.iter().filter_map(|(name, _)| *name).collect();
        if !key.is_given() {
            return match self.sections {
                [] => Ok(None),
                [(_, length)] => Ok(*length),
                _ => Err(key.missing(match known.as_slice() {
                    [] => "give the sections of the line names, and name one".to_owned(),
                    known => format!("name one of the sections: {}", known.join(", ")),
                })),
            };
        }
        if let Some(finding) = unknown(key, &known, "section", self.of) {
            return Err(finding);
        }
        let mut sections = self.sections.iter();
        let section = sections.find(|(name, _)| *name == key.get().map(String::as_str));
        Ok(section.and_then(|(_, length)| *length))
    }

    /// A body hangs inside its section.
    fn place(&self, section: &Key<'_, String>, at: &Key<'_, f64>) -> Option<Finding> {
        let length = match self.section_length(section) {
            Ok(length) => length?,
            Err(finding) => return Some(finding),
        };
        let place = at.value().filter(|place| *place > length)?;
        let problem = format!("it hangs beyond its section: at {}", quantity(place, "m"));
        Some(at.finding(problem, inside(section, length)))
    }

    /// The stretch that floats or modules sit on is not empty, and inside its section.
    fn stretch(
        &self,
        section: &Key<'_, String>,
        from: &Key<'_, f64>,
        to: &Key<'_, f64>,
    ) -> Option<Finding> {
        let length = match self.section_length(section) {
            Ok(length) => length?,
            Err(finding) => return Some(finding),
        };
        let begin = from.value()?;
        let end = if to.is_given() { to.value()? } else { length };
        if end > length {
            let problem = format!("they reach beyond their section: {}", quantity(end, "m"));
            return Some(to.finding(problem, inside(section, length)));
        }
        (begin >= end).then(|| {
            let key = if from.is_given() { from } else { to };
            let problem = format!(
                "the stretch is empty: it begins at {} and ends at {}",
                quantity(begin, "m"),
                quantity(end, "m")
            );
            key.finding(
                problem,
                format!("let it begin before it ends; {}", inside(section, length)),
            )
        })
    }
}

fn inside(section: &Key<'_, String>, length: f64) -> String {
    let length = quantity(length, "m");
    match section.get() {
        Some(name) => format!("section \"{name}\" is {length} long"),
        None => format!("its section is {length} long"),
    }
}

/// A body that travels along the line stays on it, and its way does not end where it begins.
fn travels(case: &CaseKeys<'_>) -> Vec<Finding> {
    let (Some(body), Some(whole)) = (&case.traveller, length(case)) else {
        return Vec::new();
    };
    let beyond = |key: &Key<'_, f64>| {
        let place = *key.given().filter(|place| **place > whole)?;
        let problem = format!("lies beyond the line: {place} m of {whole} m");
        let remedy =
            format!("give {whole} m or less, measured along the unstretched line from end A");
        Some(key.finding(problem, remedy))
    };
    let goes_nowhere = || {
        let from = body.from_m.value()?;
        let to = if body.to_m.is_given() {
            body.to_m.value()?
        } else {
            whole
        };
        let speed = body.speed_m_per_s.value()?;
        (from == to && speed > 0.0).then(|| {
            let key = if body.to_m.is_given() {
                &body.to_m
            } else {
                &body.from_m
            };
            let problem = format!("its way ends where it begins, at {}", quantity(from, "m"));
            key.finding(
                problem,
                "let it end elsewhere, or give a speed of 0 to a body that stays",
            )
        })
    };
    let found = [beyond(&body.from_m), beyond(&body.to_m), goes_nowhere()];
    found.into_iter().flatten().collect()
}
