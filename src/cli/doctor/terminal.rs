//! The terminal: its size, what it can show, and what lies between it and the program.

use std::process::Command;

use super::finding::{DoctorFinding, Surroundings};
use seacable_display::chart::Glyphs;
use seacable_tui::recovery::remembered_glyphs;
use seacable_tui::settings::UserSettings;
use seacable_tui::terminal::capabilities::{decide, synchronizes};
use seacable_tui::view::layout::SMALLEST;

const TOPIC: &str = "terminal";

pub(super) fn findings(around: &Surroundings<'_>) -> Vec<DoctorFinding> {
    let mut found = vec![
        size(around),
        term(around),
        colour(around),
        locale(around),
        glyphs(around),
    ];
    found.extend(multiplexer(around));
    found.push(synchronized(around));
    found.push(clipboard(around));
    found.push(editor(around));
    found
}

fn size(around: &Surroundings<'_>) -> DoctorFinding {
    let (columns, rows) = SMALLEST;
    match around.size {
        None => DoctorFinding::fine(TOPIC, "size", "no terminal")
            .note("the workbench needs one; `seacable run`, `validate` and `report` do not"),
        Some((width, height)) => {
            let found =
                DoctorFinding::fine(TOPIC, "size", format!("{width} columns, {height} rows"));
            if width < columns || height < rows {
                found.problem(format!(
                    "the workbench needs {columns} columns and {rows} rows"
                ))
            } else if width < 80 || height < 24 {
                found.note("from 80x24 on everything is in sight")
            } else {
                found
            }
        }
    }
}

fn term(around: &Surroundings<'_>) -> DoctorFinding {
    match around.set("TERM") {
        None => DoctorFinding::fine(TOPIC, "TERM", "not set")
            .note("set TERM to the name of your terminal"),
        Some(term) if term == "dumb" => DoctorFinding::fine(TOPIC, "TERM", term)
            .note("it says that the terminal can only print lines: the workbench does not open"),
        Some(term) => DoctorFinding::fine(TOPIC, "TERM", term),
    }
}

fn colour(around: &Surroundings<'_>) -> DoctorFinding {
    let palette = UserSettings::load()
        .config
        .palette
        .unwrap_or_default()
        .name();
    let value = match around.set("NO_COLOR") {
        Some(_) => "none: NO_COLOR is set".to_owned(),
        None => format!("the terminal's own sixteen, theme {palette}"),
    };
    DoctorFinding::fine(TOPIC, "colour", value)
}

/// The variable that says which characters there are.
fn effective_locale(around: &Surroundings<'_>) -> Option<(&'static str, String)> {
    let names = ["LC_ALL", "LC_CTYPE", "LANG"];
    names
        .into_iter()
        .find_map(|name| Some((name, around.set(name)?)))
}

fn locale(around: &Surroundings<'_>) -> DoctorFinding {
    match effective_locale(around) {
        None => DoctorFinding::fine(TOPIC, "locale", "none is set: ASCII is drawn")
            .note("set LANG, such as to C.UTF-8, where your terminal shows UTF-8; SSH passes it on with SendEnv"),
        Some((name, value)) => DoctorFinding::fine(TOPIC, "locale", format!("{name}={value}")),
    }
}

/// The characters that are drawn, and why.
fn glyphs(around: &Surroundings<'_>) -> DoctorFinding {
    let config = UserSettings::load().config.glyphs;
    let remembered = remembered_glyphs();
    let found = decide(None, config.or(remembered), &|name| (around.var)(name));
    let name = match found.glyphs {
        Glyphs::Braille => "braille",
        Glyphs::Ascii => "ASCII",
    };
    let why = match (config, remembered, effective_locale(around)) {
        (Some(_), ..) => "config.toml says so".to_owned(),
        (None, Some(_), _) => "chosen in an earlier session".to_owned(),
        (None, None, Some((name, _))) if found.glyphs == Glyphs::Braille => {
            format!("{name} says UTF-8")
        }
        (None, None, Some((name, _))) => {
            format!("{name} does not say UTF-8, or TERM is a console without such characters")
        }
        (None, None, None) => "no locale is set".to_owned(),
    };
    DoctorFinding::fine(TOPIC, "characters", format!("{name}: {why}"))
}

/// The terminal in the terminal, with its limits.
fn multiplexer(around: &Surroundings<'_>) -> Option<DoctorFinding> {
    if around.set("TMUX").is_some() {
        let version = version_of(around, "tmux", "-V").unwrap_or_else(|| "tmux".to_owned());
        let found = DoctorFinding::fine(TOPIC, "multiplexer", version.clone());
        return Some(found.note(tmux_limits(&version)));
    }
    if around.set("STY").is_some() {
        let version = version_of(around, "screen", "--version");
        let found = DoctorFinding::fine(
            TOPIC,
            "multiplexer",
            version.unwrap_or_else(|| "screen".to_owned()),
        );
        return Some(found.note(
            "it passes no copies on to the clipboard; what is copied is in the file below as well",
        ));
    }
    around
        .set("ZELLIJ")
        .map(|_| DoctorFinding::fine(TOPIC, "multiplexer", "zellij"))
}

fn tmux_limits(version: &str) -> String {
    let number = version.trim_start_matches(|c: char| !c.is_ascii_digit());
    let mut parts = number.split(|c: char| !c.is_ascii_digit());
    let mut part = || parts.next().and_then(|part| part.parse::<u32>().ok());
    let is_old = (part(), part()) < (Some(3), Some(4));
    let clipboard = "`set -g set-clipboard on` in its configuration passes copies on; `set -sg escape-time 20` makes Esc quick";
    match is_old {
        true => format!("{clipboard}; before 3.4 it shows frames in parts"),
        false => clipboard.to_owned(),
    }
}

/// The first line by which a program says its version.
fn version_of(around: &Surroundings<'_>, program: &str, option: &str) -> Option<String> {
    let file = around.program(program)?;
    let output = Command::new(file).arg(option).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    Some(text.lines().next()?.trim().to_owned())
}

fn synchronized(around: &Surroundings<'_>) -> DoctorFinding {
    let value = match synchronizes(&|name| (around.var)(name)) {
        true => "asked for: frames appear whole where the terminal knows it",
        false => "not asked for: TERM names an old terminal or none",
    };
    DoctorFinding::fine(TOPIC, "synchronized output", value)
}

fn clipboard(around: &Surroundings<'_>) -> DoctorFinding {
    let file = seacable_base::places::state_dir()
        .map(|dir| seacable_base::visible::path(&dir.join("copied.txt")));
    let file = file.unwrap_or_else(|error| error.to_string());
    let found = DoctorFinding::fine(
        TOPIC,
        "clipboard",
        format!("OSC 52 to the terminal, and {file}"),
    );
    match around.set("TERM") {
        Some(term) if term == "linux" || term.starts_with("vt") => {
            found.note("this terminal takes no copies; the file has them")
        }
        _ => found,
    }
}

fn editor(around: &Surroundings<'_>) -> DoctorFinding {
    let named = ["VISUAL", "EDITOR"]
        .into_iter()
        .find_map(|name| Some((name, around.set(name)?)));
    let (from, words) = named.unwrap_or(("neither VISUAL nor EDITOR is set", "vi".to_owned()));
    let program = words.split_whitespace().next().unwrap_or("vi").to_owned();
    match around.program(&program) {
        Some(path) => DoctorFinding::fine(
            TOPIC,
            "editor",
            format!("{words} ({from}): {}", seacable_base::visible::path(&path)),
        ),
        None => DoctorFinding::fine(TOPIC, "editor", format!("{words} ({from}): not found"))
            .note("set EDITOR to an editor that is installed"),
    }
}
