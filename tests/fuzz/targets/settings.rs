//! What the user sets, what sessions left, and lines of commands.

use seacable::tui::bindings::{file, listing};
use seacable::tui::command_line::typed;
use seacable::tui::fuzzy::FuzzyFilter;
use seacable::tui::screen_memory::ScreenMemory;
use seacable::tui::screen_memory::file::{SessionMemory, of_text};
use seacable::tui::settings::config;

use super::Target;
use super::cases::shown;

pub(super) const ALL: &[Target] = &[
    Target {
        name: "keys",
        run: keys,
        seeds: || {
            let whole = listing::default_file();
            let in_force = whole.replace("\n# ", "\n");
            vec![whole.into_bytes(), in_force.into_bytes()]
        },
        share: 2,
    },
    Target {
        name: "looks",
        run: |data| {
            let (_, faults) = config::read(&text(data), "config.toml");
            faults.is_empty() || shown(&faults)
        },
        seeds: || vec![b"theme = \"light\"\nglyphs = \"ascii\"\nkeep_screen = true\n".to_vec()],
        share: 10,
    },
    Target {
        name: "screen",
        run: |data| {
            let text = text(data);
            let screen = of_text::<ScreenMemory>(&text).is_ok();
            of_text::<SessionMemory>(&text).is_ok() && screen
        },
        seeds: || {
            let screen = "pane = \"runs\"\ntab = 1\n[charts]\nchart = \"Path\"\nx = [0.0, 1.0]\n[[tables]]\ntable = \"nodes\"\nsort = \"x [m]\"\n";
            vec![screen.as_bytes().to_vec()]
        },
        share: 10,
    },
    Target {
        name: "command_line",
        run: |data| {
            let text = text(data);
            let filter = FuzzyFilter::new(&text);
            let lines = [vec![text.as_str()], vec!["current speed", "m/s"]];
            assert!(filter.places(&lines).len() <= lines.len());
            typed(&text).is_some()
        },
        seeds: || {
            vec![
                b"set current.speed_m_per_s=0.4".to_vec(),
                b"save as a b".to_vec(),
            ]
        },
        share: 10,
    },
];

fn text(data: &[u8]) -> String {
    String::from_utf8_lossy(data).into_owned()
}

fn keys(data: &[u8]) -> bool {
    let (_, faults) = file::read(&text(data), "keys.toml");
    faults.is_empty() || shown(&faults)
}
