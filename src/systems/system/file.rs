//! The system as a kind of file: its result, its keys in reading order.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use super::build::sea_of;
use super::check::check;
use super::connected::Loose;
use super::model::{BodyInputs, PointKind, SystemFile, SystemKeys};
use super::motion::responses::wave_response;
use super::potential_flow::PotentialFlow;
use super::potential_flow::wave_loads::uncovered;
use super::rest::UnsolvedSystem;
use super::solved::{SolvedSystem, solve};
use crate::case::attachments::{FileSource, places};
use crate::case::fields::{AbsentKey, POSITION, Schema};
use crate::case::file_kind::{FileContent, FileKind};
use crate::case::schema::schema_of;
use crate::case::{Attachment, Diagnostic, FieldLister, FieldRow, Finding};

/// Keys of a clump on a line that go with the direction of that.
const OF_DIRECTION: [AbsentKey; 4] = {
    const fn of_point(key: &'static str) -> AbsentKey {
        AbsentKey {
            table: "points.*",
            key,
            problem: "goes with the direction of a line, and a point, at which several may meet, has none",
            remedy: "hang a clump on the line near its end ([[lines.clumps]]), or leave it out",
        }
    }
    [
        of_point("drag_area_normal_m2"),
        of_point("drag_area_tangential_m2"),
        of_point("added_mass_normal_kg"),
        of_point("added_mass_tangential_kg"),
    ]
};

/// The system file.
pub static SYSTEM: LazyLock<Schema> = LazyLock::new(|| {
    let least = "a system has at least [system] with a title, and [materials.<name>], [points.<name>] and [[lines]], or a body or rod";
    schema_of::<SystemFile>("system", least)
        .with_parameters()
        .without_keys(&OF_DIRECTION)
        .with_coordinates("points.*.position_m", POSITION.0, POSITION.1)
        .with_coordinates(
            "points.*.amplitude_m",
            [
                "amplitude along x",
                "amplitude along y",
                "amplitude along z",
            ],
            "Amplitude of the prescribed motion along one axis.",
        )
});

impl FileContent for SystemFile {
    type Computed = SolvedSystem;
}

impl FileKind for SystemFile {
    fn schema() -> &'static Schema {
        &SYSTEM
    }

    fn check(keys: &SystemKeys<'_>) -> Vec<Finding> {
        check(keys)
    }

    fn take_files(&mut self, source: &FileSource<'_>) -> Result<(), Diagnostic> {
        for (name, body) in &self.bodies {
            let named = [
                ("response_file", &body.response_file),
                ("radiation_file", &body.radiation_file),
                ("excitation_file", &body.excitation_file),
                ("drift_file", &body.drift_file),
            ];
            for (key, file) in named {
                if let Some(file) = file {
                    let key = ["bodies", name.as_str(), key];
                    source.take(&mut self.files, file, &key)?;
                }
            }
        }
        source.take_curves(&mut self.files, &mut self.published_curve)?;
        let until = self.in_time().map(|solver| solver.duration_s);
        for (name, point) in &self.points {
            let moved = point.kind == PointKind::Moved;
            if let Some(file) = point.motion_file.as_ref().filter(|_| moved) {
                let key = ["points", name, "motion_file"];
                let shown = source.take(&mut self.files, file, &key)?;
                let rows = places(&self.files[file].text, &shown)?;
                covered(&rows, until, (&key, source))?;
            }
        }
        source.take_load_cases(&mut self.files, &self.load_cases, &SYSTEM)?;
        source.take_checks(&mut self.files, &self.checks)?;
        if let Some(bed) = &self.seabed {
            source.take_depths(&mut self.files, bed.depths(), "seabed")?;
        }
        if let Some(current) = &self.current {
            let grid = source.take_current(&mut self.files, current)?;
            let varies = grid.is_some_and(|grid| grid.varies_in_time());
            let loaded = self.bodies.iter();
            let mut loaded = loaded.filter(|(_, body)| !body.current_loads.is_empty());
            if let Some((name, _)) = loaded.next().filter(|_| varies) {
                return Err(changes_with_time(name, source));
            }
        }
        let sea = sea_of(self);
        for body in self.bodies.values() {
            let flow = PotentialFlow::of_body(self, body)?;
            let Some(sea) = &sea else { continue };
            wave_response(self, body, sea)?;
            let uncovered = flow.and_then(|flow| uncovered(&flow, sea, body.yaw_deg.to_radians()));
            if let Some(heading) = uncovered {
                return Err(not_covered(body, heading, source));
            }
        }
        Ok(())
    }

    fn files(&self) -> Option<&BTreeMap<String, Attachment>> {
        Some(&self.files)
    }

    fn files_mut(&mut self) -> Option<&mut BTreeMap<String, Attachment>> {
        Some(&mut self.files)
    }

    fn compute(self, keys: &SystemKeys<'_>) -> Result<SolvedSystem, Finding> {
        solve(self).map_err(|refusal| located(&refusal, keys))
    }

    fn list(lister: &FieldLister<'_>) -> Vec<FieldRow> {
        let mut rows = lister.always("system");
        rows.extend(lister.always("environment"));
        rows.extend(lister.if_given(&["seabed"], "seabed"));
        rows.extend(lister.if_given(&["current"], "current"));
        rows.extend(lister.named("waves", "waves"));
        rows.extend(lister.if_given(&["wind"], "wind"));
        rows.extend(lister.named("lines", "line"));
        rows.extend(nested(lister, ("lines", "line"), ("sections", "section")));
        rows.extend(nested(lister, ("lines", "line"), ("floats", "floats on")));
        rows.extend(nested(lister, ("lines", "line"), ("modules", "modules on")));
        rows.extend(nested(lister, ("lines", "line"), ("clumps", "clump")));
        rows.extend(lister.named("points", "point"));
        rows.extend(lister.named("bodies", "body"));
        rows.extend(nested(lister, ("bodies", "body"), ("members", "member")));
        rows.extend(nested(lister, ("bodies", "body"), ("wind_loads", "wind")));
        rows.extend(nested(
            lister,
            ("bodies", "body"),
            ("current_loads", "current"),
        ));
        rows.extend(nested(lister, ("bodies", "body"), ("drift_loads", "drift")));
        rows.extend(lister.named("rods", "rod"));
        rows.extend(lister.named("materials", "material"));
        rows.extend(lister.named("payouts", "payout"));
        rows.extend(lister.named("sliding_points", "sliding point"));
        rows.extend(lister.named("goals", "goal"));
        rows.extend(lister.named("offset_curves", "offset curve"));
        rows.extend(lister.named("watch_circles", "watch circle"));
        rows.extend(lister.if_given(&["damage"], "damage"));
        rows.extend(lister.if_given(&["start"], "start"));
        rows.extend(lister.if_given(&["solver"], "solver"));
        rows.extend(lister.if_given(&["output"], "output"));
        rows.extend(lister.if_given(&["ageing"], "ageing"));
        for of in ["growth", "corrosion"] {
            rows.extend(ageing(lister, of));
        }
        rows
    }
}

/// Rows of a motion by time that do not cover the run, which ends at a time \[s\].
fn covered(
    rows: &[Vec<f64>],
    until: Option<f64>,
    (key, source): (&[&str], &FileSource<'_>),
) -> Result<(), Diagnostic> {
    let [first, last] = [rows.first(), rows.last()].map(|row| row.map_or(0.0, |row| row[0]));
    let until = until.unwrap_or(0.0);
    if first <= 0.0 && last >= until * (1.0 - 1e-9) {
        return Ok(());
    }
    let span = source.root.find(key).map_or(0..0, |node| node.span.clone());
    let problem =
        format!("its times go from {first} s to {last} s, and the run from 0 s to {until} s");
    let remedy = "give rows from 0 s or before to the end of the run, or a shorter duration_s";
    Err(Finding::new(&span, key.join("."), problem, remedy).at(source.file, source.text))
}

/// Loads by the heading of a current that changes with time.
fn changes_with_time(body: &str, source: &FileSource<'_>) -> Diagnostic {
    let loads = source.root.find(&["bodies", body, "current_loads"]);
    let span = loads.map_or(0..0, |loads| loads.span.clone());
    let problem = "are of a steady current, and that of current.file changes with time";
    let remedy = "give the body drag areas or members, or a steady current";
    let key = format!("bodies.{body}.current_loads");
    Finding::new(&span, key, problem, remedy).at(source.file, source.text)
}

/// Waves from a heading that the coefficients of a body do not have.
fn not_covered(body: &BodyInputs, heading: f64, source: &FileSource<'_>) -> Diagnostic {
    let files = [&body.excitation_file, &body.drift_file];
    let names: Vec<&str> = files.into_iter().flatten().map(String::as_str).collect();
    Diagnostic::whole_file(
        source.file,
        format!(
            "waves run towards {:.1} deg from the bow of a body, which {} {} not cover",
            heading.to_degrees(),
            names.join(" and "),
            if names.len() == 1 { "does" } else { "do" },
        ),
        "give files with headings on both sides of it, or turn the waves",
    )
}

/// The rows of a list that every table of a kind has: the sections of each line.
fn nested(
    lister: &FieldLister<'_>,
    (tables, one): (&str, &str),
    (lists, item): (&str, &str),
) -> Vec<FieldRow> {
    let Some(parents) = lister.root.get(tables) else {
        return Vec::new();
    };
    let mut rows = Vec::new();
    for name in parents.names() {
        let Some(list) = lister.root.find(&[tables, &*name, lists]) else {
            continue;
        };
        for entry in list.names() {
            let path = [tables, &*name, lists, &*entry];
            let group = format!("{one} {name}, {item} {entry}");
            rows.extend(lister.table(&format!("{tables}.*.{lists}.*"), &path, &group));
        }
    }
    rows
}

/// The rows of every table of marine growth, or of corrosion.
fn ageing(lister: &FieldLister<'_>, of: &str) -> Vec<FieldRow> {
    let Some(tables) = lister.root.find(&["ageing", of]) else {
        return Vec::new();
    };
    let names = tables.names();
    let each = names.iter().flat_map(|name| {
        let pattern = format!("ageing.{of}.*");
        lister.table(&pattern, &["ageing", of, name], &format!("{of} {name}"))
    });
    each.collect()
}

/// A refusal at the key that it is about.
fn located(refusal: &UnsolvedSystem, keys: &SystemKeys<'_>) -> Finding {
    let problem = refusal.problem.as_str();
    let remedy = refusal.remedy.as_str();
    // A copy stands where its original does.
    let original = |name: &str| name.split('@').next().unwrap_or(name).to_owned();
    if let Some(name) = refusal.line.as_deref().map(original)
        && let Some((_, line)) = keys.lines.iter().find(|(known, _)| *known == name)
    {
        return line.place.finding(problem, remedy);
    }
    match &refusal.part {
        Some((Loose::Point(_), name)) => {
            let name = original(name);
            let point = keys.points.iter().find(|(known, _)| *known == name);
            point.map_or(&keys.place, |(_, point)| &point.place)
        }
        Some((Loose::Body(_), name)) => {
            let body = keys.bodies.iter().find(|(known, _)| known == name);
            let rod = keys.rods.iter().find(|(known, _)| known == name);
            let rod = rod.map(|(_, rod)| &rod.place);
            body.map(|(_, body)| &body.place)
                .or(rod)
                .unwrap_or(&keys.place)
        }
        None => keys
            .about
            .as_ref()
            .map_or(&keys.place, |about| &about.place),
    }
    .finding(problem, remedy)
}
