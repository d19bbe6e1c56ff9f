//! Floats, modules and bodies on lines as other programs have them: sections of materials that have what is attached to them by length, and bodies
//! where sections meet.

use std::borrow::Cow;

use super::target::Unsayable;
use crate::case::Clump;
use crate::system::model::{LineInputs, LineSection};
use crate::system::parts::{Part, parts, shared};
use crate::system::{SolvedSystem, SystemFile};

/// The system with nothing attached to its lines but bodies where sections meet.
///
/// # Errors
/// Bodies that hang at one place of a line.
pub(super) fn written_out(solved: &SolvedSystem) -> Result<Cow<'_, SolvedSystem>, Vec<Unsayable>> {
    let file = &solved.file;
    let has_any = LineInputs::has_attachments;
    if !file.lines.iter().any(has_any) {
        return Ok(Cow::Borrowed(solved));
    }
    let (mut written, mut refused) = (file.clone(), Vec::new());
    for number in 0..file.lines.len() {
        if has_any(&file.lines[number]) {
            refused.extend(write_out(file, number, &mut written));
        }
    }
    match refused.is_empty() {
        true => Ok(Cow::Owned(SolvedSystem {
            file: written,
            ..solved.clone()
        })),
        false => Err(refused),
    }
}

/// Writes a line in sections of one material each; a body where another hangs.
fn write_out(file: &SystemFile, number: usize, written: &mut SystemFile) -> Option<Unsayable> {
    let line = &file.lines[number];
    let bears = file.seabed.is_some() && line.bed_contact;
    let mut sections = Vec::new();
    for part in parts(file, line) {
        for (piece, stretch) in part
            .uniform(&file.environment, bears)
            .into_iter()
            .enumerate()
        {
            if let [_, second, ..] = stretch.clumps.as_slice() {
                return Some(twice(line, second));
            }
            let is_own = stretch.material == part.material;
            let material = match is_own {
                true => part.name.clone(),
                false => free_name(written, &part.name, &stretch),
            };
            let name = part.section.as_ref();
            let share = stretch.length_m / part.length_m;
            let section = LineSection {
                name: name.map(|name| format!("{name}-{}", piece + 1)),
                material,
                length_m: stretch.length_m,
                segments: part.segments.map(|all| shared(all, share)),
                ..LineSection::default()
            };
            sections.push(match stretch.clumps.first() {
                Some(clump) => section.with_clump(clump),
                None => section,
            });
        }
    }
    written.lines[number] = LineInputs {
        material: None,
        length_m: None,
        sections,
        floats: Vec::new(),
        modules: Vec::new(),
        clumps: Vec::new(),
        ..line.clone()
    };
    None
}

/// The name of a material of a stretch, which is added where it is new.
fn free_name(file: &mut SystemFile, own: &str, stretch: &Part) -> String {
    let mut names = (1..).map(|number| format!("{own}-buoyed-{number}"));
    let is_free = |name: &String| {
        let known = file.materials.get(name);
        known.is_none_or(|known| *known == stretch.material)
    };
    let name = names.find(is_free).unwrap_or_default();
    file.materials
        .insert(name.clone(), stretch.material.clone());
    name
}

fn twice(line: &LineInputs, clump: &Clump) -> Unsayable {
    Unsayable {
        key: format!("lines.{}.clumps.{}.at_m", line.name, clump.name),
        what: "place for two bodies (make one of both)".to_owned(),
    }
}
