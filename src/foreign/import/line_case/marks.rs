//! Marks of a case: where its numbers come from, at the keys that its system has them at.

use super::copied::{copy_keys, value_of};
use super::paths;
use super::places::{end_of, on_free_end};
use super::source::{BESIDE, LINE, LineSource};
use super::turning_payload::hang_point;
use crate::case::{TomlEntry, TomlNode};
use crate::import::to_case::case_text::{CaseText, text};

/// A mark of the case with its key path of the system.
struct CarriedMark<'s> {
    path: String,
    mark: &'s TomlEntry,
    /// Whether the key has the value of the case, which its value and tolerances are for.
    is_whole: bool,
}

/// Writes them, each key's once.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>) {
    let Some(node) = source.node(&["marks"]) else {
        return;
    };
    let written = TomlNode::parse(&system.text).ok();
    let mut all: Vec<CarriedMark<'_>> = Vec::new();
    for entry in node.entries() {
        let carried = carried(source, entry, written.as_ref());
        let is_new = |one: &CarriedMark<'_>| all.iter().all(|other| other.path != one.path);
        all.extend(carried.filter(is_new));
    }
    let is_apart = |one: &CarriedMark<'_>| one.mark.node.is_under_header();
    if !all.iter().all(is_apart) {
        system.table("[marks]", Some(&node.span));
    }
    for one in all.iter().filter(|one| !is_apart(one)) {
        system.given(
            &text(&one.path),
            &one.inline(source),
            &one.mark.node.span,
            "",
        );
    }
    for one in all.iter().filter(|one| is_apart(one)) {
        system.table(
            &format!("[marks.{}]", text(&one.path)),
            Some(&one.mark.node.span),
        );
        copy_keys(system, source, &one.mark.node, one.without());
    }
}

impl CarriedMark<'_> {
    /// Keys of it that are of the value of the case alone.
    fn without(&self) -> &'static [&'static str] {
        match self.is_whole {
            true => &[],
            false => &["value", "tolerance_rel", "tolerance_abs"],
        }
    }

    fn inline(&self, source: &LineSource<'_>) -> String {
        if self.is_whole {
            return value_of(source, &self.mark.node);
        }
        let keys = self.mark.node.entries().iter();
        let kept = keys.filter(|entry| !self.without().contains(&&*entry.key));
        let kept: Vec<String> = kept
            .map(|entry| format!("{} = {}", entry.key, value_of(source, &entry.node)))
            .collect();
        format!("{{ {} }}", kept.join(", "))
    }
}

/// A mark by the key of the system that has its value, or else by what the system has of it.
fn carried<'s>(
    source: &LineSource<'_>,
    mark: &'s TomlEntry,
    written: Option<&TomlNode>,
) -> Option<CarriedMark<'s>> {
    if let Some(path) = paths::translated(source, &mark.key) {
        let is_whole = true;
        return Some(CarriedMark {
            path,
            mark,
            is_whole,
        });
    }
    let parts = crate::case::split(&mark.key)?;
    let parts: Vec<&str> = parts.iter().map(String::as_str).collect();
    let is_written = |path: &String| {
        let parts = crate::case::split(path);
        let at = |root: &TomlNode| root.find(&parts?).map(|_| ());
        written.and_then(at).is_some()
    };
    let path = counterparts(source, &parts).into_iter().find(is_written)?;
    let is_whole = false;
    Some(CarriedMark {
        path,
        mark,
        is_whole,
    })
}

/// Key paths of what the system may have of a key whose value it has not, the best first.
fn counterparts(source: &LineSource<'_>, path: &[&str]) -> Vec<String> {
    let case = &source.case;
    let ends = [&case.ends.a, &case.ends.b];
    let body = &case.ends.b.name;
    match path {
        ["start", key] => {
            let free = ends.into_iter().filter(|end| !end.kind.is_held());
            let places = free.map(|end| format!("points.{}.position_m", end.name));
            [format!("lines.{LINE}.start.{key}")]
                .into_iter()
                .chain(places)
                .collect()
        }
        ["ends", letter, "kind"] => {
            let end = if *letter == "a" { ends[0] } else { ends[1] };
            vec![format!("points.{}.kind", end.name)]
        }
        ["payload", "rotation", "centre_of_gravity_m"] => {
            vec![format!("points.{}.position_m", hang_point(source))]
        }
        ["payload", "rotation", key] => {
            let own = match *key {
                "spin_inertia_kg_m2" => "inertia_kg_m2",
                "added_inertia_kg_m2" => "added_mass",
                "start_tilt_deg" => "pitch_deg",
                "start_azimuth_deg" => "yaw_deg",
                "spin_deg_per_s" => "start_angular_velocity_deg_per_s",
                key => key,
            };
            vec![
                format!("bodies.{body}.{own}"),
                format!("bodies.{body}.kind"),
            ]
        }
        ["payload", key] => {
            let own = if *key == "added_mass_kg" {
                "added_mass"
            } else {
                key
            };
            vec![
                format!("bodies.{body}.{own}"),
                format!("bodies.{body}.volume_m3"),
            ]
        }
        ["traveller", "speed_m_per_s"] => vec!["sliding_points.1.rate_m_per_s".to_owned()],
        ["line", section, key] => BESIDE
            .into_iter()
            .flat_map(|line| {
                [
                    format!("lines.{line}.{key}"),
                    format!("lines.{line}.sections.{section}.{key}"),
                ]
            })
            .collect(),
        ["clumps", name, "at_m"] => {
            let clumps = case.clumps.iter().filter(|clump| clump.name == *name);
            let mut letters = clumps.filter_map(|clump| end_of(case, clump));
            let letter = letters
                .next()
                .filter(|letter| on_free_end(source, letter).is_some());
            let end = letter.map(|letter| if letter == "a" { "from" } else { "to" });
            end.map(|end| format!("lines.{LINE}.{end}"))
                .into_iter()
                .collect()
        }
        _ => Vec::new(),
    }
}
