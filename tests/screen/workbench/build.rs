//! Models built on the screen: whole scenes from templates and from nothing, by keys alone.

use std::path::PathBuf;

use seacable::case::fields::{Schema, TableShape, split};
use seacable::case::shipped;
use seacable::case::structure::{self, OutlineRow, outline, values_of};
use seacable::case::{self, kind};
use seacable::kinds::FileType;
use seacable::run::RunState;
use seacable::run::job::JobEvent;
use seacable::system::SystemFile;
use seacable::tui::facade;
use seacable::tui::msg::FileRead;
use seacable::tui::pane::PaneId;
use seacable::tui::state::reading::content;
use seacable::tui::state::{DocumentContent, Overlay};
use seacable::tui::{Effect, Msg};

use super::desk::{Desk, run};
use super::{LARGE, SMALL, has, said, snapshot};

/// A scripted client of the screen: keys alone, each of them kept.
struct Client {
    desk: Desk,
    log: Vec<String>,
}

impl Client {
    fn new() -> Self {
        Self {
            desk: Desk::new(SMALL),
            log: Vec::new(),
        }
    }

    fn keys(&mut self, names: &str) {
        self.log.push(names.to_owned());
        self.desk.keys(names);
    }

    fn typed(&mut self, text: &str) {
        self.log.push(format!("\"{text}\""));
        self.desk.type_text(text);
    }

    fn text(&self) -> String {
        self.desk.state.editor().unwrap().text.clone()
    }

    fn kind(&self) -> FileType {
        self.desk
            .state
            .document
            .as_ref()
            .unwrap()
            .content
            .file_type()
    }

    fn schema(&self) -> &'static Schema {
        facade::schema(self.kind())
    }

    fn rows(&self) -> Vec<OutlineRow> {
        self.desk.state.editor().unwrap().model.rows.clone()
    }

    /// A new file of the template of this name.
    fn begin(&mut self, template: &str) {
        self.keys("n");
        self.typed(template);
        self.keys("enter");
        assert!(matches!(self.desk.state.overlay, Some(Overlay::Form(_))));
        self.keys("enter");
        assert!(self.desk.state.overlay.is_none(), "{}", self.desk.screen());
        self.keys("B");
        assert_eq!(self.desk.state.focus(), PaneId::Model);
    }

    /// Moves the cursor of the list to a table.
    fn go(&mut self, path: &str) {
        let rows = self.rows();
        let wanted = rows.iter().position(|row| row.path == path);
        let wanted = wanted.unwrap_or_else(|| panic!("no {path}\n{}", self.text()));
        self.keys("g");
        for _ in 0..wanted {
            self.keys("j");
        }
    }

    /// Fills lines of the open form by key, and takes it. Lines that are folded are shown first.
    fn fill(&mut self, values: &[(String, String)]) {
        let Some(Overlay::Form(form)) = &self.desk.state.overlay else {
            panic!("no form: {}", self.desk.screen());
        };
        if !form.whole {
            self.keys("tab");
        }
        // What decides which lines there are comes first.
        let mut values: Vec<&(String, String)> = values.iter().collect();
        values.sort_by_key(|(key, _)| !matches!(key.as_str(), "kind" | "by"));
        for (key, value) in values {
            let Some(Overlay::Form(form)) = &self.desk.state.overlay else {
                panic!("no form");
            };
            let shown = form.shown();
            let at = shown.iter().position(|n| form.lines[*n].key == *key);
            let at = at.unwrap_or_else(|| panic!("no {key} in {}\n{}", form.title, self.text()));
            let by = at as isize - form.cursor as isize;
            let key = if by < 0 { "up" } else { "down" };
            for _ in 0..by.abs() {
                self.keys(key);
            }
            self.keys("end ctrl+u");
            self.typed(value);
        }
        self.keys("enter");
        if let Some(Overlay::Form(form)) = &self.desk.state.overlay {
            panic!("{}: {}\n{}", form.title, form.problem, self.text());
        }
    }

    /// Adds a table at a path, the cursor on the table that it belongs to.
    fn add(&mut self, table: &str, values: &[(String, String)]) {
        self.keys("a");
        let Some(Overlay::Picker(picker)) = &self.desk.state.overlay else {
            panic!("no list");
        };
        let name = table.replace('_', " ").replace('.', " > ");
        let at = picker.shown().iter().position(|item| item.name == name);
        let at = at.unwrap_or_else(|| panic!("{table} is not offered\n{}", self.text()));
        for _ in 0..at {
            self.keys("down");
        }
        self.keys("enter");
        self.fill(values);
    }

    /// Takes all tables out that are none of the target's, from the last to the first.
    fn remove_all_but(&mut self, paths: &[String]) {
        loop {
            let rows = self.rows();
            let extra = rows
                .iter()
                .rev()
                .find(|row| !row.is_heading && !paths.contains(&row.path));
            let Some(row) = extra else { return };
            let path = row.path.clone();
            self.go(&path);
            self.keys("d");
            assert!(
                self.rows().iter().all(|row| row.path != path),
                "{path}: {}\n{}",
                said(&self.desk),
                self.text()
            );
        }
    }

    /// Builds the file of a text by keys alone.
    fn build(&mut self, target: &str) {
        let schema = self.schema();
        let wanted = outline(schema, target);
        let wanted: Vec<&OutlineRow> = wanted.iter().filter(|row| !row.is_heading).collect();
        // What the template has by the same name is taken out first, where it is one of several.
        let old = self.rows();
        let singles: Vec<String> = old
            .iter()
            .filter(|row| !row.is_heading && !is_one_of_several(schema, &row.path))
            .map(|row| row.path.clone())
            .collect();
        self.remove_all_but(&singles);
        for row in &wanted {
            let parts = split(&row.path).unwrap();
            let several = is_one_of_several(schema, &row.path);
            let table = match several {
                true => structure::parent(&row.path),
                false => row.path.clone(),
            };
            let mut values = values_of(target, &parts);
            if several && is_by_name(schema, &row.path) {
                values.insert(0, ("(name)".to_owned(), parts.last().unwrap().clone()));
            }
            let is_there = self.rows().iter().any(|old| old.path == row.path);
            if is_there {
                self.go(&row.path);
                self.keys("enter");
                // Keys that the target does not have are cleared.
                let now = values_of(&self.text(), &parts);
                let gone = now
                    .into_iter()
                    .filter(|(key, _)| !values.iter().any(|(k, _)| k == key));
                values.extend(
                    gone.map(|(key, _)| (key, String::new()))
                        .collect::<Vec<_>>(),
                );
                self.fill(&values);
                continue;
            }
            let outer = structure::parent(&table);
            if outer.is_empty() {
                self.keys("g");
            } else {
                self.go(&outer);
            }
            self.add(&table, &values);
        }
        let paths: Vec<String> = wanted.iter().map(|row| row.path.clone()).collect();
        self.remove_all_but(&paths);
    }
}

fn is_one_of_several(schema: &'static Schema, path: &str) -> bool {
    structure::is_one_of_several(schema, path)
}

fn is_by_name(schema: &'static Schema, path: &str) -> bool {
    let parts = split(path).unwrap();
    let table = structure::declaration(schema, &parts);
    table.is_some_and(|table| table.shape == TableShape::ByName)
}

fn shipped(name: &str) -> &'static str {
    shipped::text(name).unwrap()
}

/// What a text says, as values by key path, whatever the order and the comments.
fn said_by(schema: &'static Schema, text: &str) -> Vec<(String, Vec<(String, String)>)> {
    let rows = outline(schema, text)
        .into_iter()
        .filter(|row| !row.is_heading);
    rows.map(|row| {
        let mut values = values_of(text, &split(&row.path).unwrap());
        values.sort();
        let bare = |value: String| value.split_whitespace().collect::<String>();
        let values = values.into_iter().map(|(key, value)| (key, bare(value)));
        (row.path, values.collect())
    })
    .collect()
}

/// One shipped case of every kind, built from a template of its kind by keys alone.
#[test]
fn one_shipped_case_of_every_kind_is_rebuilt_by_keys() {
    for (template, name) in [
        ("spread", "systems/bridle_and_buoy.toml"),
        ("line", "basics/steep_wave.toml"),
        ("lowering", "pendulous/manifold.toml"),
        ("cross-section", "umbilical/section_power_cable.toml"),
        ("ropeway", "ropeway/span_40.toml"),
        ("ship", "ship/anchored.toml"),
    ] {
        let target = shipped(name);
        let mut client = Client::new();
        client.begin(template);
        client.build(target);
        let built = client.text();
        let schema = client.schema();
        assert_eq!(
            said_by(schema, &built),
            said_by(schema, target),
            "{name}\n{built}"
        );
        assert!(
            client.desk.state.editor().unwrap().draft.is_none(),
            "{name}"
        );
        // The same scene: what is computed of both is the same.
        let read = |text: &str| {
            let path = PathBuf::from("x.toml");
            content(client.kind(), text, &path, "x.toml").unwrap()
        };
        match (read(&built), read(target)) {
            (DocumentContent::Line(a), DocumentContent::Line(b)) => assert_eq!(a.case, b.case),
            (DocumentContent::System(a), DocumentContent::System(b)) => {
                assert_eq!(a.solved.file, b.solved.file);
                assert_eq!(a.solved.rest.placement, b.solved.rest.placement);
            }
            (DocumentContent::Section(_), DocumentContent::Section(_))
            | (DocumentContent::Ropeway(_), DocumentContent::Ropeway(_))
            | (DocumentContent::Ship(_), DocumentContent::Ship(_)) => {}
            _ => panic!("{name} is of another kind"),
        }
        assert!(client.log.len() > 20, "{name}");
    }
}

/// A three-line mooring: from the template to a report, with one line divided and the depth changed.
#[test]
fn a_three_line_mooring_from_a_template_to_a_report() {
    let mut client = Client::new();
    client.begin("spread");
    snapshot("tui_model_80x24", &client.desk);
    assert_eq!(client.kind(), FileType::System);
    // The depth moves the anchors, the fairleads and the lengths together.
    let solved = |client: &Client| kind::parse::<SystemFile>(&client.text(), "x.toml").unwrap();
    let before = solved(&client).file.lines[0].length_m.unwrap();
    client.go("parameters");
    client.keys("enter");
    client.fill(&[("depth_m".to_owned(), "300".to_owned())]);
    let after = solved(&client);
    assert_eq!(after.file.seabed.as_ref().unwrap().depth_m, 300.0);
    assert_eq!(after.file.points["anchor"].position_m.unwrap()[2], -300.0);
    assert!(after.file.lines[0].length_m.unwrap() > before);
    // Marine growth, and a goal.
    client.keys("g");
    client.add("watch_circles", &[("load_n".to_owned(), "1e6".to_owned())]);
    assert_eq!(solved(&client).file.watch_circles.len(), 1);
    // Saved, and reported.
    client.keys("s");
    assert!(has(
        &client.desk,
        |effect| matches!(effect, Effect::SaveCase { text, .. }
        if text.contains("[[watch_circles]]") && text.contains("depth_m = 300"))
    ));
    let (path, text) = (
        client.desk.state.editor().unwrap().path.clone(),
        client.text(),
    );
    client.desk.tell(Msg::Saved(path, text));
    client.keys("B");
    client.keys("w");
    let report = client
        .desk
        .asked
        .iter()
        .rev()
        .find_map(|effect| match effect {
            Effect::WriteText { text, .. } => Some(text.clone()),
            _ => None,
        });
    let report = report.expect("a report");
    assert!(
        report.contains("Spread mooring") && report.contains("line@120"),
        "{report}"
    );
}

/// A lowering built from a bare line: payload, motion of the upper end, current, sea bed.
#[test]
fn a_lowering_built_from_nothing() {
    let mut client = Client::new();
    client.begin("line");
    let pairs = |values: &[(&str, &str)]| -> Vec<(String, String)> {
        let values = values.iter();
        values
            .map(|(k, v)| ((*k).to_owned(), (*v).to_owned()))
            .collect()
    };
    client.keys("g");
    client.add(
        "payload",
        &pairs(&[
            ("dry_mass_kg", "60e3"),
            ("wet_mass_kg", "48e3"),
            ("drag_area_m2", "60"),
            ("added_mass_kg", "50e3"),
        ]),
    );
    // No end is of kind payload yet: what the file lacks is said, and nothing is computed.
    assert!(
        said(&client.desk).starts_with("Not complete yet: payload"),
        "{}",
        said(&client.desk)
    );
    snapshot("tui_model_draft_80x24", &client.desk);
    client.keys("R");
    assert!(
        said(&client.desk).contains("not complete"),
        "{}",
        said(&client.desk)
    );
    client.go("ends.b");
    client.keys("enter");
    client.fill(&pairs(&[
        ("kind", "payload"),
        ("name", "manifold"),
        ("position_m", ""),
    ]));
    assert!(
        client.desk.state.editor().unwrap().draft.is_none(),
        "{}",
        said(&client.desk)
    );
    client.go("ends.a");
    client.keys("enter");
    client.fill(&pairs(&[
        ("kind", "moving"),
        ("name", "crane"),
        ("position_m", "0 0 0"),
        ("amplitude_m", "0 0 1"),
        ("period_s", "9"),
        ("ramp_s", "18"),
    ]));
    client.keys("g");
    client.add("seabed", &pairs(&[("depth_m", "150")]));
    client.keys("g");
    client.add(
        "current",
        &pairs(&[("speed_m_per_s", "0.6, 0.2"), ("depth_m", "0, 150")]),
    );
    client.go("solver");
    client.keys("enter");
    client.fill(&pairs(&[("method", "alpha"), ("duration_s", "90")]));
    client.go("line.line");
    client.keys("|");
    client.fill(&pairs(&[("at_m", "100")]));
    client.go("line.line-2");
    client.keys("n");
    client.fill(&pairs(&[("(name)", "lower")]));
    let case = case::parse(&client.text(), "x.toml").unwrap();
    assert_eq!(case.line.len(), 2);
    assert_eq!(case.line[1].name, "lower");
    assert_eq!(case.ends.a.amplitude_m, [0.0, 0.0, 1.0]);
    assert_eq!(case.payload.as_ref().unwrap().wet_mass_kg, Some(48e3));
    snapshot("tui_model_lowering_80x24", &client.desk);
    // It runs, and the run is that of the text built.
    client.keys("R");
    let started = client.desk.started();
    let (ticket, request) = started.last().unwrap();
    assert_eq!(request.case, case);
    let done = run(request, RunState::Done);
    client.desk.tell(Msg::Job(
        *ticket,
        Box::new(JobEvent::Finished(Box::new(done))),
    ));
}

#[test]
fn forms_and_lists_as_they_are_seen() {
    let mut desk = Desk::with_system(SMALL);
    desk.keys("B a");
    desk.type_text("lines");
    snapshot("tui_add_80x24", &desk);
    desk.keys("enter");
    snapshot("tui_form_80x24", &desk);
    desk.keys("tab");
    desk.tell(Msg::Resize(LARGE.0, LARGE.1));
    snapshot("tui_form_200x60", &desk);
    let mut desk = Desk::new(SMALL);
    desk.keys("n");
    snapshot("tui_templates_80x24", &desk);
}

#[test]
fn what_a_form_refuses_stays_in_it() {
    let mut desk = Desk::with_system(SMALL);
    let before = desk.state.editor().unwrap().text.clone();
    desk.keys("B a");
    desk.type_text("rods");
    desk.keys("enter enter");
    let problem = |desk: &Desk| match &desk.state.overlay {
        Some(Overlay::Form(form)) => form.problem.clone(),
        _ => panic!("no form"),
    };
    assert!(
        problem(&desk).contains("kind is needed"),
        "{}",
        problem(&desk)
    );
    desk.keys("down right down");
    desk.type_text("0 0 deep");
    desk.keys("down");
    desk.type_text("0 0 -5");
    desk.keys("down");
    desk.type_text("-3");
    desk.keys("down");
    desk.type_text("1");
    desk.keys("enter");
    assert!(problem(&desk).contains("end_a_m"), "{}", problem(&desk));
    desk.keys("esc");
    assert_eq!(desk.state.editor().unwrap().text, before);
    // A taken name.
    desk.keys("c");
    desk.keys("esc");
    assert!(desk.state.overlay.is_none());
}

#[test]
fn a_removed_table_comes_back_with_undo() {
    let mut client = Client::new();
    client.begin("spread");
    let before = client.text();
    client.go("offset_curves.1");
    client.keys("d");
    assert!(!client.text().contains("offset_curves"));
    client.keys("u");
    assert_eq!(client.text(), before);
    // What others need is missed, and said.
    client.go("points.anchor");
    client.keys("d");
    assert!(
        said(&client.desk).contains("lines.line.from"),
        "{}",
        said(&client.desk)
    );
    client.keys("u");
    assert!(client.desk.state.editor().unwrap().draft.is_none());
    assert_eq!(client.text(), before);
}

#[test]
fn a_new_file_is_named_below_the_list_and_a_bad_one_is_refused() {
    let mut desk = Desk::new(SMALL);
    desk.opens_new_files = false;
    desk.keys("n");
    desk.type_text("mooring line");
    desk.keys("enter ctrl+u");
    desk.type_text("../out");
    desk.keys("enter");
    let problem = |desk: &Desk| match &desk.state.overlay {
        Some(Overlay::Form(form)) => form.problem.clone(),
        _ => panic!("no form"),
    };
    assert!(problem(&desk).contains("without `..`"));
    desk.keys("ctrl+u");
    desk.type_text("mine");
    desk.keys("enter");
    assert!(has(
        &desk,
        |effect| matches!(effect, Effect::NewFile { path, .. }
        if path == std::path::Path::new("cases/mine.toml"))
    ));
    desk.tell(Msg::NotMade("The file is not made: it exists.".to_owned()));
    assert!(problem(&desk).contains("it exists"));
}

/// A draft is kept for recovery like any edit, and comes back as one.
#[test]
fn a_draft_is_kept_and_comes_back() {
    let mut client = Client::new();
    client.begin("spread");
    client.go("points.anchor");
    client.keys("d");
    let text = client.text();
    assert!(has(
        &client.desk,
        |effect| matches!(effect, Effect::KeepRecovery { text: Some(kept), .. } if *kept == text)
    ));
    let recovered = seacable::tui::recovery::RecoveredEdits {
        text: text.clone(),
        kept: Vec::new(),
    };
    let saved = client.desk.state.editor().unwrap().saved.clone();
    let path = PathBuf::from("cases/spread_mooring.toml");
    let read = content(FileType::System, &saved, &path, "x.toml").unwrap();
    let mut desk = Desk::new(SMALL);
    desk.tell(Msg::FileRead(Box::new(FileRead::new(
        path,
        saved,
        read,
        Some(recovered),
    ))));
    desk.keys("r");
    assert_eq!(desk.state.editor().unwrap().text, text);
    assert!(desk.state.editor().unwrap().draft.is_some());
}

/// A file that another program changed is read again; the user's edits are never lost by it.
#[test]
fn changes_by_other_programs_are_taken_over() {
    let mut desk = Desk::with_system(SMALL);
    let path = desk.state.editor().unwrap().path.clone();
    assert!(has(
        &desk,
        |effect| matches!(effect, Effect::Watch(watched) if *watched == path)
    ));
    let before = desk.state.editor().unwrap().text.clone();
    let change = |desk: &mut Desk, text: &str| {
        desk.tell(Msg::ChangedOutside(path.clone(), text.to_owned()));
    };
    // The file as it is: nothing happens.
    change(&mut desk, &before);
    assert!(desk.state.editor().unwrap().undo.is_empty());
    let outside = before.replacen("title = \"", "title = \"Changed: ", 1);
    change(&mut desk, &outside);
    assert_eq!(desk.state.editor().unwrap().text, outside);
    assert!(!desk.state.editor().unwrap().unsaved());
    assert!(said(&desk).contains("read again"));
    desk.keys("u");
    assert_eq!(desk.state.editor().unwrap().text, before);
    // With edits that are not saved it is said, and they stay.
    change(&mut desk, &outside.replacen("Changed", "Again", 1));
    assert_eq!(desk.state.editor().unwrap().text, before);
    assert!(
        said(&desk).contains("your edits are kept"),
        "{}",
        said(&desk)
    );
    // A file that lacks something is a draft.
    desk.keys("U");
    change(
        &mut desk,
        &outside.replacen("[points.", "[points.other_", 1),
    );
    assert!(desk.state.editor().unwrap().draft.is_some());
}

#[test]
fn the_list_of_tables_is_filtered() {
    let mut client = Client::new();
    client.begin("spread");
    client.keys("/");
    client.typed("anchor");
    client.keys("enter");
    let screen = client.desk.screen();
    assert!(screen.contains("filter: anchor"), "{screen}");
    let current = |client: &Client| {
        let editor = client.desk.state.editor().unwrap();
        editor.model.current().map(|row| row.path.clone())
    };
    assert_eq!(current(&client).as_deref(), Some("points.anchor"));
    // What is under the cursor is what is edited, and stays under it.
    client.keys("n");
    client.fill(&[("(name)".to_owned(), "anchor_pile".to_owned())]);
    assert!(client.text().contains("[points.anchor_pile]"));
    assert_eq!(current(&client).as_deref(), Some("points.anchor_pile"));
    client.keys("/ esc");
    assert!(!client.desk.screen().contains("filter:"));
    assert_eq!(
        client.rows().len(),
        client.desk.state.editor().unwrap().model.shown().len()
    );
}
