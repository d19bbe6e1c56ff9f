//! The workbench without a terminal: keys in, screen out, and jobs that answer with a run made by
//! hand, so that a screen does not change with every digit of the solvers.

use std::path::PathBuf;
use std::sync::Arc;

use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::{Buffer, Cell};
use ratatui::style::{Color, Modifier};
use seacable::case;
use seacable::chart::Glyphs;
use seacable::kinds::FileType;
use seacable::run::job::{JobEvent, Request};
use seacable::run::{
    Channel, Cost, History, LineShape, OutputFrame, Profile, Progress, Quantity, QuantityId, Run,
    RunInfo, RunState, Settings, Subject, VERSION, Work,
};
use seacable::tui::key::KeyPress;
use seacable::tui::msg::FileRead;
use seacable::tui::state::reading::content;
use seacable::tui::state::{
    CaseEntry, DocumentContent, JobNumber, JobRequest, LineView, VariantPlan, VariedRuns,
};
use seacable::tui::terminal::capabilities::Capabilities;
use seacable::tui::theme::Palette;
use seacable::tui::{AppState, Effect, Msg, draw, update};

/// A small case with everything the screens show: marks, floats left out, a study, published rows.
pub(crate) const CASE: &str = include_str!("body.toml");

/// The workbench and what it asked of the world.
pub(crate) struct Desk {
    pub(crate) state: AppState,
    pub(crate) asked: Vec<Effect>,
    /// Whether edits are checked as they are asked for.
    pub(crate) checks_at_once: bool,
    /// Whether files of templates are opened as they are asked for.
    pub(crate) opens_new_files: bool,
    /// Whether parts and validation tables are worked out as they are asked for.
    pub(crate) parts_at_once: bool,
}

pub(crate) fn looks(glyphs: Glyphs, colour: bool) -> Capabilities {
    Capabilities {
        glyphs,
        colour,
        palette: Palette::Dark,
        unsure: false,
    }
}

/// A line case as the content of a document.
pub(crate) fn content_of(case: case::Case) -> DocumentContent {
    DocumentContent::Line(Box::new(LineView::new(case)))
}

impl Desk {
    /// The list of cases before it is read.
    pub(crate) fn unread(size: (u16, u16)) -> Self {
        Self {
            state: AppState::new(size, looks(Glyphs::Braille, true)),
            asked: Vec::new(),
            checks_at_once: true,
            opens_new_files: true,
            parts_at_once: true,
        }
    }

    /// The list of cases: one good, one broken.
    pub(crate) fn new(size: (u16, u16)) -> Self {
        let mut desk = Self::unread(size);
        let entry = |name: &str, about| CaseEntry {
            path: PathBuf::from("cases").join(name),
            name: name.to_owned(),
            about,
        };
        let broken = "error: line.chain.length_m: is out of range: -30 m\n --> cases/broken.toml:21:12\n   |\n21 | length_m = -30.0\n   |            ^^^^^\n   = help: give more than 0 m";
        desk.tell(Msg::CasesRead(
            PathBuf::from("cases"),
            vec![
                entry(
                    "body.toml",
                    Ok((
                        "Body lowered on a chain and a rope".to_owned(),
                        "made for the tests".to_owned(),
                    )),
                ),
                entry(
                    "broken.toml",
                    Err((
                        "line 21, column 12: is out of range: -30 m".to_owned(),
                        broken.to_owned(),
                    )),
                ),
            ],
        ));
        desk
    }

    /// The case open, with its live solve complete.
    pub(crate) fn with_case(size: (u16, u16)) -> Self {
        let mut desk = Self::opening(size);
        desk.finish_jobs();
        desk
    }

    /// The case open, with its live solve on its way.
    pub(crate) fn opening(size: (u16, u16)) -> Self {
        let mut desk = Self::new(size);
        desk.tell(Msg::FileRead(Box::new(FileRead::new(
            PathBuf::from("cases/body.toml"),
            CASE.to_owned(),
            content_of(case::parse(CASE, "body.toml").unwrap()),
            None,
        ))));
        desk
    }

    pub(crate) fn tell(&mut self, msg: Msg) {
        let effects = update(&mut self.state, msg);
        self.perform(effects);
    }

    /// Does what can be done without files, threads and solvers; the rest is asked for.
    pub(crate) fn perform(&mut self, effects: Vec<Effect>) {
        for effect in effects {
            match effect {
                Effect::Plan { case, text, file } => {
                    self.tell(Msg::Planned(Box::new(VariantPlan::new(
                        &text, &case, &file,
                    ))));
                }
                Effect::Vary(path, variation) => {
                    self.tell(Msg::Varied(Box::new(VariedRuns::new(path, &variation))));
                }
                Effect::CheckEdits(check) if self.checks_at_once => {
                    self.tell(Msg::EditsChecked(Box::new(check.answer())));
                }
                Effect::MakeReport(request) => {
                    let text = request.text();
                    self.tell(Msg::Report(request, text));
                }
                Effect::WriteMade(request) => {
                    let (path, text, what) = request.text();
                    let written = text.map(|text| Effect::WriteText { path, text, what });
                    self.asked.extend(written);
                }
                Effect::MakePart(request) if self.parts_at_once => {
                    let view = Arc::new(request.view());
                    self.tell(Msg::PartMade(Box::new(request.key), view));
                }
                Effect::CheckValues(check) if self.parts_at_once => {
                    let table = Box::new(check.table());
                    self.tell(Msg::ValuesChecked(check.token, table));
                }
                Effect::NewFile { path, text } if self.opens_new_files => {
                    let content = content(FileType::of_text(&text), &text, &path, "new.toml");
                    let read = FileRead::new(path, text, content.unwrap(), None);
                    self.tell(Msg::FileRead(Box::new(read)));
                }
                effect => self.asked.push(effect),
            }
        }
    }

    /// Presses keys, given by their names with blanks between them.
    pub(crate) fn keys(&mut self, names: &str) {
        for name in names.split_whitespace() {
            let key: KeyPress = name.parse().unwrap();
            self.tell(Msg::Key(key));
        }
    }

    /// Types a text letter by letter.
    pub(crate) fn type_text(&mut self, text: &str) {
        for c in text.chars() {
            self.tell(Msg::Key(KeyPress::Char(c)));
        }
    }

    /// The jobs asked for and not yet answered.
    pub(crate) fn started(&mut self) -> Vec<(JobNumber, Request)> {
        let mut started = Vec::new();
        self.asked.retain(|effect| match effect {
            Effect::Start {
                ticket,
                request: JobRequest::Line(request, _),
                ..
            } => {
                started.push((*ticket, (**request).clone()));
                false
            }
            _ => true,
        });
        started
    }

    /// Answers every job with its whole run, until none is asked for any more.
    pub(crate) fn finish_jobs(&mut self) {
        loop {
            let started = self.started();
            if started.is_empty() {
                return;
            }
            for (ticket, request) in started {
                self.tell(Msg::Stored(
                    ticket,
                    PathBuf::from(format!("runs/body-{ticket}")),
                ));
                let run = run(&request, RunState::Done);
                self.tell(Msg::Job(
                    ticket,
                    Box::new(JobEvent::Finished(Box::new(run))),
                ));
            }
        }
    }

    /// Sends the beginning of a job: channels, and frames up to a time.
    pub(crate) fn stream(&mut self, ticket: JobNumber, request: &Request, until: f64) {
        let whole = run(request, RunState::Done);
        let channels = whole.history.channels.iter();
        let channels = channels.map(|c| c.id.clone()).collect();
        self.tell(Msg::Job(
            ticket,
            Box::new(JobEvent::Started {
                channels,
                lines: Vec::new(),
            }),
        ));
        for (i, time) in whole.history.time.iter().enumerate() {
            if *time > until {
                break;
            }
            let frame = OutputFrame {
                time: *time,
                values: whole.history.channels.iter().map(|c| c.values[i]).collect(),
                shapes: whole
                    .shapes
                    .iter()
                    .find(|s| s.time == *time)
                    .cloned()
                    .into_iter()
                    .collect(),
                progress: Progress {
                    time: *time,
                    duration: 600.0,
                    steps: 10 * i as u64,
                    wall_s: *time / 100.0,
                    ..Progress::default()
                },
            };
            self.tell(Msg::Job(ticket, Box::new(JobEvent::Frame(Box::new(frame)))));
        }
    }

    /// The screen as cells.
    pub(crate) fn buffer(&self) -> Buffer {
        let (width, height) = self.state.size;
        let mut terminal = Terminal::new(TestBackend::new(width, height)).unwrap();
        terminal.draw(|frame| draw(&self.state, frame)).unwrap();
        terminal.backend().buffer().clone()
    }

    /// The screen as text, and below it a map of its styles.
    pub(crate) fn screen(&self) -> String {
        with_styles(&self.buffer())
    }
}

/// The characters, and below them a map of their styles: a letter a colour, capitals for bold, `~`
/// for dim, `#` for reversed, `-` for the terminal's own.
pub(crate) fn with_styles(buffer: &Buffer) -> String {
    let width = usize::from(buffer.area().width);
    let rows = |of: fn(&Cell) -> String| {
        let lines = buffer.content().chunks(width.max(1));
        lines
            .map(|row| row.iter().map(of).collect::<String>().trim_end().to_owned() + "\n")
            .collect::<String>()
    };
    let grid = rows(|cell| cell.symbol().to_owned());
    format!("{grid}{}\n{}", "=".repeat(width), rows(style))
}

fn style(cell: &Cell) -> String {
    let has = |modifier| cell.modifier.contains(modifier);
    let letter = match cell.fg {
        _ if has(Modifier::REVERSED) => '#',
        _ if cell.symbol() == " " => ' ',
        Color::Cyan | Color::LightCyan => 'c',
        Color::Yellow => 'y',
        Color::Green => 'g',
        Color::Red => 'r',
        Color::Magenta => 'm',
        Color::Reset if has(Modifier::DIM) => '~',
        Color::Reset if has(Modifier::BOLD) => 'B',
        Color::Reset => '-',
        _ => 'o',
    };
    let letter = if has(Modifier::BOLD) {
        letter.to_ascii_uppercase()
    } else {
        letter
    };
    letter.to_string()
}

/// A run made by hand: the body swings down and settles below the vessel.
pub(crate) fn run(request: &Request, state: RunState) -> Run {
    let time: Vec<f64> = (0..=60).map(|i| 10.0 * f64::from(i)).collect();
    let angle = |t: f64| 1.5 * (-t / 100.0).exp();
    let tension = |t: f64| 1.96e6 * (1.0 - (-t / 80.0).exp());
    let channel = |name: &str, f: &dyn Fn(f64) -> f64| {
        let values: Vec<f64> = time.iter().map(|t| f(*t)).collect();
        let extreme =
            |better: fn(f64, f64) -> bool| {
                let start = (values[0], time[0]);
                values.iter().zip(&time).fold(start, |best, (v, t)| {
                    if better(*v, best.0) { (*v, *t) } else { best }
                })
            };
        Channel {
            id: name.parse().unwrap(),
            peak: extreme(|a, b| a > b),
            trough: extreme(|a, b| a < b),
            values,
        }
    };
    let channels = vec![
        channel("tension_n[vessel|chain]", &|t| tension(t) + 1.2e5),
        channel("tension_n[chain|rope]", &|t| tension(t) + 0.7e5),
        channel("tension_n[rope|body]", &tension),
        channel("x_m[body]", &|t| 1000.0 * angle(t).sin()),
        channel("z_m[body]", &|t| -1000.0 * angle(t).cos()),
        channel("speed_m_per_s[body]", &|t| {
            (angle(t + 0.5) - angle(t - 0.5)).abs() * 1000.0
        }),
    ];
    let shape = |t: f64| LineShape {
        time: t,
        line: 0,
        nodes: (0..=22)
            .map(|i| {
                let s = 1000.0 * f64::from(i) / 22.0;
                [s * angle(t).sin(), 0.0, -s * angle(t).cos()]
            })
            .collect(),
        tension: (0..=22)
            .map(|i| tension(t) + 5e3 * f64::from(22 - i))
            .collect(),
        ..LineShape::default()
    };
    let last = shape(600.0);
    let profile = Profile {
        arc: (0..=22).map(|i| 1000.0 * f64::from(i) / 22.0).collect(),
        tension_min: vec![0.0; 23],
        tension_max: last.tension.iter().map(|t| 1.05 * t).collect(),
        z_min: last.nodes.iter().map(|n| n[2]).collect(),
        z_max: vec![0.0; 23],
        nodes: last.nodes,
        tension: last.tension,
        ..Profile::default()
    };
    let rows = request.case.published.iter();
    let quantity = |subject: &Subject, statistic, window, value| Quantity {
        id: QuantityId::new(subject.clone(), statistic, window),
        value,
        time_error: Some(200.0),
        mesh_error: Some(100.0),
        unsettled: None,
    };
    let summary = rows
        .map(|row| quantity(&row.channel, row.statistic, row.window_s, 1.955e6))
        .collect();
    Run {
        info: RunInfo {
            id: request.id.clone(),
            title: request.case.case.title.clone(),
            case_file: request.file.clone(),
            state,
            version: VERSION.to_owned(),
            started: "2026-01-02T03:04:05Z".to_owned(),
            overrides: request.overrides.clone(),
            failure: (state == RunState::Failed).then(|| "step 7 did not converge.".to_owned()),
            warnings: Vec::new(),
            happened: Vec::new(),
            settings: Settings {
                method: "alpha".to_owned(),
                duration_s: 600.0,
                time_step_s: 0.25,
                nodes: 23,
                output_interval_s: 10.0,
                error_method: "half the step, half the segments".to_owned(),
                ..Settings::default()
            },
            work: Work {
                steps: 2400,
                rejections: 0,
                iterations: 5000,
                evaluations: 0,
            },
            cost: Cost {
                cpu_s: 0.05,
                wall_s: 0.05,
                companions_wall_s: 0.2,
            },
        },
        case_text: request.text.clone(),
        history: History {
            time: time.clone(),
            channels,
        },
        shapes: (0..=6).map(|i| shape(100.0 * f64::from(i))).collect(),
        profiles: vec![profile],
        summary,
        fatigue: Vec::new(),
    }
}

/// The same run, shared.
pub(crate) fn shared(request: &Request) -> Arc<Run> {
    Arc::new(run(request, RunState::Done))
}
