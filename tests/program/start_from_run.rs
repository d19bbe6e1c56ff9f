//! A case that starts where a stored run stands.

#![expect(clippy::float_cmp, reason = "compares numbers that are the same bits")]

use std::path::Path;
use std::sync::atomic::AtomicBool;

use crate::small::SMALL;
use seacable::case::{self, Case, edit};
use seacable::files::root;
use seacable::run::job::{self, Request};
use seacable::run::store::{self, RunLocation, RunWriter};
use seacable::run::{Run, RunState, resume_request};

/// The pendulum with these keys set.
fn text(keys: &[(&str, &str)]) -> String {
    let common = [
        ("solver.time_step_s", "0.05"),
        ("solver.duration_s", "2.0"),
        ("solver.error_estimate", "false"),
    ];
    let all: Vec<_> = common.iter().chain(keys).copied().collect();
    edit::set_all(SMALL, &all).unwrap()
}

fn request(text: String, case: Case) -> Request {
    Request {
        case,
        text,
        file: "small.toml".to_owned(),
        overrides: Vec::new(),
        id: String::new(),
    }
}

fn stored(request: &Request, dir: &Path) -> Run {
    let whole = case::stand_alone(&request.text, &request.case).into_owned();
    let place = RunLocation::Exactly(dir.to_owned());
    let mut writer = RunWriter::begin(&place, request.initial_info(), &whole).unwrap();
    let run = job::execute(request, &AtomicBool::new(false), &mut |event| {
        writer.event(&event).unwrap();
    });
    writer
        .finish(&Run {
            case_text: whole,
            ..run.clone()
        })
        .unwrap();
    run
}

/// A case of this text that starts from the run in a directory.
fn from(dir: &Path, keys: &[(&str, &str)]) -> Result<(String, Case), String> {
    let text = text(keys);
    let shape = "shape = \"straight\"\nelevation_deg = -30.0\n";
    assert!(text.contains(shape));
    let run = toml::Value::String(dir.display().to_string());
    // It lies neither beside the case nor below here.
    root::allow(&dir.display().to_string());
    let text = text.replace(shape, &format!("from_run = {run}\n"));
    match case::parse(&text, "small.toml") {
        Ok(case) => Ok((text, case)),
        Err(all) => Err(all
            .iter()
            .map(ToString::to_string)
            .collect::<Vec<_>>()
            .join("\n")),
    }
}

/// Nothing in the case but the start goes with time: going on so is going on, to the last bit.
#[test]
fn starting_from_a_run_is_going_on_with_it() {
    for method in ["alpha", "rk4", "quasi"] {
        let place = tempfile::tempdir().unwrap();
        let dir = place.path().join("first");
        let keys = [("solver.method", method)];
        let keys = if method == "rk4" {
            vec![keys[0], ("solver.time_step_s", "0.005")]
        } else {
            keys.to_vec()
        };
        let text = text(&keys);
        let case = case::parse(&text, "small.toml").unwrap();
        stored(&request(text, case), &dir);
        let (resumed, stands) = resume_request::<Case>(&dir, Some(4.0)).unwrap();
        let whole = job::execute_from(
            &resumed,
            stands.as_ref(),
            &AtomicBool::new(false),
            &mut |_| {},
        );
        let (text, case) = from(&dir, &keys).unwrap();
        let begun = job::execute(&request(text, case), &AtomicBool::new(false), &mut |_| {});
        assert_eq!(begun.info.state, RunState::Done, "{:?}", begun.info.failure);
        let offset = whole.history.time.len() - begun.history.time.len();
        assert_eq!(whole.history.time[offset], 2.0);
        for (a, b) in begun.history.channels.iter().zip(&whole.history.channels) {
            for (i, (a, b)) in a.values.iter().zip(&b.values[offset..]).enumerate() {
                assert_eq!(a.to_bits(), b.to_bits(), "{method}, row {i}: {a} and {b}");
            }
        }
    }
}

/// The run keeps where it started: it is computed again without the run it started from, on the companions' mesh as well.
#[test]
fn such_a_run_needs_nothing_but_itself() {
    let place = tempfile::tempdir().unwrap();
    let [first, second] = ["first", "second"].map(|name| place.path().join(name));
    let plain = text(&[]);
    let case = case::parse(&plain, "small.toml").unwrap();
    stored(&request(plain, case), &first);
    let (text, case) = from(&first, &[("solver.error_estimate", "true")]).unwrap();
    let run = stored(&request(text, case), &second);
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    let reported = run
        .summary
        .iter()
        .find(|q| q.name() == "z_m[payload].final")
        .unwrap();
    let (time, mesh) = (reported.time_error.unwrap(), reported.mesh_error.unwrap());
    assert!(time < 0.1 && mesh < 0.5, "{time} {mesh}");
    std::fs::remove_dir_all(&first).unwrap();
    let text = store::case_text(&second).unwrap();
    let case = case::parse(&text, "small.toml").unwrap();
    let again = job::execute(&request(text, case), &AtomicBool::new(false), &mut |_| {});
    assert_eq!(again.history, run.history);
}

#[test]
fn a_mismatch_is_reported_with_its_place() {
    let place = tempfile::tempdir().unwrap();
    let dir = place.path().join("first");
    let plain = text(&[]);
    let case = case::parse(&plain, "small.toml").unwrap();
    stored(&request(plain, case), &dir);
    let fault = |dir: &Path, keys: &[(&str, &str)]| from(dir, keys).unwrap_err();
    let reported = fault(&dir, &[("line.rope.segments", "5")]);
    assert!(
        reported.starts_with("small.toml:") && reported.contains("start.from_run"),
        "{reported}"
    );
    assert!(
        reported.contains("5 nodes over 20 m, this one 6 nodes over 20 m"),
        "{reported}"
    );
    let reported = fault(&dir, &[("line.rope.length_m", "21.0")]);
    assert!(
        reported.contains("this one 5 nodes over 21 m"),
        "{reported}"
    );
    let reported = fault(&place.path().join("nowhere"), &[]);
    assert!(
        reported.contains("checkpoint.toml cannot be read"),
        "{reported}"
    );
    let reported = fault(&dir, &[("start.velocity_m_per_s", "[1.0, 0.0, 0.0]")]);
    assert!(
        reported.contains("start.velocity_m_per_s") && reported.contains("starts from a run"),
        "{reported}"
    );
    // An end elsewhere is not a fault of the file alone, and reported by the run.
    let (text, case) = from(&dir, &[("ends.a.position_m", "[1.0, 0.0, -10.0]")]).unwrap();
    let run = job::execute(&request(text, case), &AtomicBool::new(false), &mut |_| {});
    let why = run.info.failure.unwrap();
    assert!(why.contains("end a begins 1.000 m from where"), "{why}");
    std::fs::write(dir.join("checkpoint.toml"), "?").unwrap();
    let reported = fault(&dir, &[]);
    assert!(
        reported.contains("the checkpoint of") && reported.contains("cannot be read"),
        "{reported}"
    );
}
