//! Starts off equilibrium, breaks at time zero, explicit steps that are too long, and what nothing holds.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use seacable::case::kind;
use seacable::import::{self, ImportOptions};
use seacable::run::job::JobEvent;
use seacable::run::job::execute_from;
use seacable::run::resume_request;
use seacable::run::store::{RunLocation, RunWriter};
use seacable::run::{Run, RunState};
use seacable::system::motion::checkpoint::ResumedSystem;
use seacable::system::motion::job::{self as system_job, SystemRequest};
use seacable::system::motion::run::{MotionRun, run};
use seacable::system::{SolvedSystem, SystemFile};

const G: f64 = 9.80665;

fn trial(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/trials/files");
    std::fs::read_to_string(path.join(name)).unwrap()
}

/// The case of a file of another program.
fn case_of(text: &str) -> String {
    let read = import::read(text, "file.txt", &ImportOptions::default());
    read.unwrap_or_else(|all| panic!("{all:#?}")).text
}

fn solved(text: &str) -> SolvedSystem {
    kind::parse::<SystemFile>(text, "t.toml").unwrap_or_else(|all| panic!("{text}\n{all:#?}"))
}

/// What is wrong with a system.
fn refused(text: &str) -> String {
    let errors = kind::parse::<SystemFile>(text, "t.toml").unwrap_err();
    errors.iter().map(ToString::to_string).collect()
}

fn computed(text: &str) -> MotionRun {
    let system = solved(text);
    let given = system.file.solver.clone().unwrap();
    let run = run(&system, &given, &AtomicBool::new(false), &mut |_| {});
    run.unwrap_or_else(|why| panic!("{}; {}", why.problem, why.remedy))
}

fn moved(text: &str) -> MotionRun {
    let run = computed(text);
    assert_eq!(run.failure, None);
    run
}

fn channel<'a>(run: &'a MotionRun, name: &str) -> &'a [f64] {
    let found = run.history.channel(name);
    &found.unwrap_or_else(|| panic!("{name}")).values
}

fn last(run: &MotionRun, name: &str) -> f64 {
    *channel(run, name).last().unwrap()
}

fn assert_near(value: f64, known: f64, within: f64) {
    assert!((value - known).abs() <= within, "{value} for {known}");
}

/// A run of constant steps.
fn fixed(method: &str, duration: f64, steps: f64, rows: f64) -> String {
    format!(
        "\n[solver]\nmethod = \"{method}\"\nduration_s = {duration:?}\ntime_step_s = {:?}\nrho_inf = 1.0\n\
         position_tolerance_m = 1e-11\nerror_estimate = false\n[output]\ninterval_s = {:?}\n",
        duration / steps,
        duration / rows
    )
}

const METHODS: [&str; 2] = ["alpha", "rk4"];

/// Complete elliptic integral of the first kind by the arithmetic-geometric mean.
fn elliptic(k: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - k * k).sqrt());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    std::f64::consts::FRAC_PI_2 / a
}

/// Period of a rod of this length and radius that is let go so far from the vertical.
fn period_of_rod(length: f64, radius: f64, aside: f64, gravity: f64) -> f64 {
    let inertia = (3.0 * radius * radius + length * length) / 12.0 + 0.25 * length * length;
    let omega = (0.5 * gravity * length / inertia).sqrt();
    4.0 / omega * elliptic((0.5 * aside).sin())
}

/// Angle of a pendulum at rest so far from the vertical, after a time: `theta'' = -omega² sin theta`, by small steps.
fn swung(omega: f64, aside: f64, time: f64) -> f64 {
    let steps = 20_000;
    let h = time / f64::from(steps);
    let rate = |theta: f64| -omega * omega * theta.sin();
    let (mut theta, mut speed) = (aside, 0.0);
    for _ in 0..steps {
        speed += 0.5 * h * rate(theta);
        theta += h * speed;
        speed += 0.5 * h * rate(theta);
    }
    theta
}

/// A physical pendulum of 2.887 s. MoorDyn 2.7.2 is no reference: its search for a start leaves the end at x = 0.355 m at time zero, with
/// `TmaxIC 0` too, and from there it swings with 3.10 s (-0.6865, -0.9524 and 1.471 m after 1, 2 and 3 s).
#[test]
fn a_pendulum_of_moordyn_begins_where_its_file_puts_it() {
    let case = case_of(&trial("h03_pendulum_release.txt"));
    assert!(
        case.contains("[start]") && case.contains("placement = \"given\""),
        "{case}"
    );
    let free = moved(&format!(
        "{case}\n[solver]\nduration_s = 3.0\nerror_estimate = false\n[output]\ninterval_s = 0.5\n"
    ));
    let aside = 30.0_f64.to_radians();
    let period = period_of_rod(3.0, 0.025, aside, G);
    assert_near(period, 2.887, 1e-3);
    let omega = 4.0 / period * elliptic((0.5 * aside).sin());
    for (time, x) in free.history.time.iter().zip(channel(&free, "x_m[rod1-b]")) {
        assert_near(*x, 3.0 * swung(omega, aside, *time).sin(), 1.5e-3);
    }
    for method in METHODS {
        let mut solver = fixed(method, period, 2000.0, 4.0);
        if method == "rk4" {
            // The line beside the rod sets its step.
            solver = solver.replace(&format!("time_step_s = {:?}\n", period / 2000.0), "");
        }
        let run = moved(&format!("{case}{solver}"));
        let x = channel(&run, "x_m[rod1-b]");
        assert_near(x[2], -1.5, 1e-5);
        assert_near(x[4], 1.5, 1e-5);
        assert!(run.balance.relative_drift() < 1e-4, "{:?}", run.balance);
    }
}

/// By the elliptic integral 7.1125 s.
#[test]
fn a_rod_let_go_above_its_pin_swings_with_the_elliptic_integral() {
    let aside = 120.0_f64.to_radians();
    let period = period_of_rod(10.0, 0.1, aside, G);
    assert_near(period, 7.1125, 1e-3);
    let case = case_of(&trial("VP1_120.txt"));
    for method in METHODS {
        let run = moved(&format!("{case}{}", fixed(method, period, 4000.0, 4.0)));
        let (x, z) = (channel(&run, "x_m[rod1-b]"), channel(&run, "z_m[rod1-b]"));
        for (row, known) in [(0, 1.0), (2, -1.0), (4, 1.0)] {
            assert_near(x[row], known * 10.0 * aside.sin(), 1e-4);
            assert_near(z[row], 5.0, 1e-4);
        }
        assert_near(z[1], -10.0, 1e-4);
    }
}

#[test]
fn a_body_begins_at_any_angle() {
    let text = trial("pendulum_120deg.toml");
    let (inertia, omega2) = (4167.916666667 + 500.0 * 25.0, 500.0 * G * 5.0);
    let omega = (omega2 / inertia).sqrt();
    let period = 4.0 / omega * elliptic(60.0_f64.to_radians().sin());
    assert_near(period, 7.1125, 1e-3);
    let (head, _) = text.split_once("[solver]").unwrap();
    for method in METHODS {
        let run = moved(&format!("{head}{}", fixed(method, period, 4000.0, 4.0)));
        // Beyond 90 degrees the pitch goes back, and roll and yaw are 180.
        let pitch = channel(&run, "pitch_deg[rod]");
        for (row, known) in [(0, 60.0), (1, 0.0), (2, -60.0), (3, 0.0), (4, 60.0)] {
            assert_near(pitch[row], known, 1e-2);
        }
    }
}

/// The rod hangs at rest: roll, pitch and yaw say nothing there, a turn about the y axis does.
#[test]
fn a_rod_is_turned_from_where_it_hangs() {
    let rod = "[system]\ntitle = \"rod\"\n[environment]\nwater_density_kg_per_m3 = 0.0\ngravity_m_per_s2 = 9.80665
        [rods.bar]\nkind = \"pinned\"\nend_a_m = [1.0, 2.0, -10.0]\nend_b_m = [1.0, 2.0, -13.0]\nmass_kg = 45.0\ndiameter_m = 0.05\n";
    let period = period_of_rod(3.0, 0.025, 30.0_f64.to_radians(), G);
    let run = moved(&format!(
        "{rod}start_turn_deg = [0.0, -30.0, 0.0]{}",
        fixed("alpha", period, 2000.0, 4.0)
    ));
    let x = channel(&run, "x_m[bar-b]");
    assert_near(x[0], 2.5, 1e-9);
    assert_near(x[2], -0.5, 1e-5);
    assert_near(x[4], 2.5, 1e-5);
    // With the speed of its lowest place it comes as high.
    let omega2 = 1.5 * G / 3.0;
    let rate = (2.0 * omega2 * (1.0 - 30.0_f64.to_radians().cos())).sqrt();
    let run = moved(&format!(
        "{rod}start_angular_velocity_deg_per_s = [0.0, {:?}, 0.0]{}",
        -rate.to_degrees(),
        fixed("alpha", period, 2000.0, 4.0)
    ));
    assert_near(channel(&run, "x_m[bar-b]")[1], 2.5, 1e-3);
}

/// x0 cos wt + v0/w sin wt.
#[test]
fn a_floating_body_heaves_by_its_closed_form() {
    let (mass, added, stiffness): (f64, f64, f64) = (1e5, 4e4, 2e5);
    let (offset, speed) = (0.4, -0.3);
    let text = format!(
        "[system]\ntitle = \"buoy\"\n[environment]\nwater_density_kg_per_m3 = 1000.0\n
        [bodies.buoy]\nkind = \"free\"\nmass_kg = {mass:?}\ninertia_kg_m2 = [1e6, 1e6, 1e6]\nvolume_m3 = 100.0
        waterplane_stiffness = [0.0, 0.0, {stiffness:?}, 1e6, 1e6, 0.0]\nadded_mass = [0.0, 0.0, {added:?}, 0.0, 0.0, 0.0]
        start_offset_m = [0.0, 0.0, {offset:?}]\nstart_velocity_m_per_s = [0.0, 0.0, {speed:?}]\n"
    );
    let omega = (stiffness / (mass + added)).sqrt();
    for method in METHODS {
        let run = moved(&format!("{text}{}", fixed(method, 12.0, 6000.0, 48.0)));
        let heave = channel(&run, "z_m[buoy]");
        for (time, z) in run.history.time.iter().zip(heave) {
            let known = offset * (omega * time).cos() + speed / omega * (omega * time).sin();
            assert_near(*z, known, 1e-5);
        }
    }
}

/// A mass that nothing holds, let go where the file puts it.
fn dropped(density: f64, keys: &str, solver: &str) -> MotionRun {
    moved(&format!(
        "[system]\ntitle = \"drop\"\n[environment]\nwater_density_kg_per_m3 = {density:?}\ngravity_m_per_s2 = 9.80665
        [points.mass]\nkind = \"free\"\nposition_m = [1.0, 2.0, -5.0]\nmass_kg = 100.0\n{keys}\n[start]\nplacement = \"given\"\n{solver}"
    ))
}

#[test]
fn a_mass_that_nothing_holds_falls() {
    for method in METHODS {
        let run = dropped(
            0.0,
            "start_velocity_m_per_s = [2.0, -1.0, 3.0]",
            &fixed(method, 4.0, 400.0, 8.0),
        );
        for (row, time) in run.history.time.iter().enumerate() {
            assert_near(channel(&run, "x_m[mass]")[row], 1.0 + 2.0 * time, 1e-9);
            assert_near(channel(&run, "y_m[mass]")[row], 2.0 - time, 1e-9);
            let z = -5.0 + 3.0 * time - 0.5 * G * time * time;
            assert_near(channel(&run, "z_m[mass]")[row], z, 1e-9);
        }
        assert!(run.balance.relative_drift() < 1e-6, "{:?}", run.balance);
    }
}

/// In water it comes to its terminal velocity: z = z0 - v²/g ln cosh(g t / v).
#[test]
fn a_mass_sinks_against_its_drag() {
    let (volume, added, area): (f64, f64, f64) = (0.04, 20.0, 0.3);
    let keys =
        format!("volume_m3 = {volume:?}\nadded_mass_kg = {added:?}\ndrag_area_m2 = {area:?}");
    let pull = (100.0 - 1000.0 * volume) * G;
    let fastest = (pull / (0.5 * 1000.0 * area)).sqrt();
    let gain = pull / (100.0 + added);
    for solver in [
        fixed("alpha", 5.0, 5000.0, 10.0),
        fixed("rk4", 5.0, 1000.0, 10.0),
        "[solver]\nduration_s = 5.0\nerror_estimate = true\n[output]\ninterval_s = 0.5\n"
            .to_owned(),
    ] {
        let run = dropped(1000.0, &keys, &solver);
        for (time, z) in run.history.time.iter().zip(channel(&run, "z_m[mass]")) {
            let known = -5.0 - fastest * fastest / gain * (gain * time / fastest).cosh().ln();
            assert_near(*z, known, 3e-4);
        }
    }
}

#[test]
fn a_body_and_a_rod_that_nothing_holds_fall() {
    let text = format!(
        "[system]\ntitle = \"drop\"\n[environment]\nwater_density_kg_per_m3 = 0.0\ngravity_m_per_s2 = 9.80665
        [bodies.box]\nkind = \"free\"\nposition_m = [0.0, 0.0, -5.0]\nmass_kg = 100.0\ninertia_kg_m2 = [10.0, 10.0, 10.0]
        [rods.bar]\nkind = \"free\"\nend_a_m = [4.0, 0.0, -5.0]\nend_b_m = [6.0, 0.0, -5.0]\nmass_kg = 10.0\ndiameter_m = 0.1
        start_angular_velocity_deg_per_s = [0.0, 0.0, 90.0]
        [start]\nplacement = \"given\"\n{}",
        fixed("alpha", 2.0, 2000.0, 4.0)
    );
    let run = moved(&text);
    for name in ["z_m[box]", "z_m[bar]"] {
        assert_near(last(&run, name), -5.0 - 2.0 * G, 1e-6);
    }
    assert_near(last(&run, "x_m[bar-b]"), 4.0, 1e-4);
    let page = seacable::system::warnings::warnings(&solved(&text));
    assert!(
        page.iter().any(|line| line.contains("Nothing holds box")),
        "{page:?}"
    );
}

const ROPE: &str = "[materials.rope]\nmass_kg_per_m = 2.0\ndiameter_m = 0.03\nea_n = 2e6\naxial_damping_n_s = 200.0\ndrag_normal = 1.2\n";

/// A clump on a rope let go aside with a velocity, all of it turned about the vertical.
fn turned_by(angle_deg: f64, solver: &str) -> String {
    let (sin, cos) = angle_deg.to_radians().sin_cos();
    let at = |x: f64, y: f64, z: f64| {
        format!("[{:?}, {:?}, {z:?}]", cos * x - sin * y, sin * x + cos * y)
    };
    format!(
        "[system]\ntitle = \"swing\"\n{ROPE}
        [points.top]\nkind = \"fixed\"\nposition_m = {}
        [points.clump]\nkind = \"free\"\nmass_kg = 800.0\nvolume_m3 = 0.1\ndrag_area_m2 = 0.2\nstart_offset_m = {}\nstart_velocity_m_per_s = {}
        [points.eye]\nkind = \"body\"\nbody = \"box\"\nposition_m = [0.3, 0.1, 0.5]
        [bodies.box]\nkind = \"free\"\nposition_m = {}\nyaw_deg = {angle_deg:?}\nmass_kg = 500.0\ninertia_kg_m2 = [80.0, 90.0, 60.0]\nvolume_m3 = 0.1
        start_offset_m = {}\nstart_offset_deg = [2.0, -3.0, 5.0]\nstart_velocity_m_per_s = {}\nstart_angular_velocity_deg_per_s = {}
        [[lines]]\nname = \"upper\"\nfrom = \"top\"\nto = \"clump\"\nmaterial = \"rope\"\nlength_m = 12.0\nsegments = 6
        [[lines]]\nname = \"lower\"\nfrom = \"clump\"\nto = \"eye\"\nmaterial = \"rope\"\nlength_m = 5.0\nsegments = 4\n{solver}",
        at(0.0, 0.0, -1.0),
        at(2.0, 0.5, 0.18),
        at(-0.3, 0.2, 0.0),
        at(0.0, 0.0, -20.0),
        at(2.5, 0.8, 0.24),
        at(-0.1, 0.3, 0.0),
        at(12.0, -8.0, 20.0),
    )
}

#[test]
fn a_start_off_equilibrium_is_the_same_turned_about_the_vertical() {
    let solver = fixed("alpha", 3.0, 3000.0, 12.0);
    let straight = moved(&turned_by(0.0, &solver));
    assert!(
        straight.balance.relative_drift() < 2e-3,
        "{:?}",
        straight.balance
    );
    let other = moved(&turned_by(37.0, &solver));
    for name in ["tension_n[upper|a]", "tension_n[lower|b]", "z_m[box]"] {
        for (one, other) in channel(&straight, name).iter().zip(channel(&other, name)) {
            assert!(
                (one - other).abs() < 1e-6 * (1.0 + one.abs()),
                "{name}: {one} {other}"
            );
        }
    }
    let by_rk4 = moved(&turned_by(0.0, &fixed("rk4", 3.0, 6000.0, 12.0)));
    for name in ["z_m[box]", "x_m[box]", "pitch_deg[box]", "x_m[clump]"] {
        assert_near(last(&by_rk4, name), last(&straight, name), 2e-2);
    }
}

/// What is placed is held there while the rest comes to rest: nothing moves at first but what is let go.
#[test]
fn some_parts_are_placed_and_the_others_rest() {
    let text = format!(
        "[system]\ntitle = \"two\"\n{ROPE}
        [points.top]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -1.0]
        [points.rests]\nkind = \"free\"\nmass_kg = 300.0
        [points.placed]\nkind = \"free\"\nmass_kg = 500.0\nposition_m = [9.0, 0.0, -12.0]
        [[lines]]\nname = \"upper\"\nfrom = \"top\"\nto = \"rests\"\nmaterial = \"rope\"\nlength_m = 12.0\nsegments = 6
        [[lines]]\nname = \"lower\"\nfrom = \"rests\"\nto = \"placed\"\nmaterial = \"rope\"\nlength_m = 6.0\nsegments = 4
        [start]\nplacement = \"given\"\nparts = [\"placed\"]\n{}",
        fixed("alpha", 0.5, 500.0, 500.0)
    );
    let run = moved(&text);
    assert_eq!(
        ["x_m[placed]", "y_m[placed]", "z_m[placed]"].map(|name| channel(&run, name)[0]),
        [9.0, 0.0, -12.0]
    );
    // Bodies fall by g t²/2 at most; the other one stays where it is to a higher order.
    let way = |name: &str| (channel(&run, name)[10] - channel(&run, name)[0]).abs();
    assert!(way("z_m[placed]") > 1e-5 && way("z_m[rests]") < 1e-6);
    let wrong = refused(&text.replace("[\"placed\"]", "[\"place\"]"));
    assert!(wrong.contains("did you mean `placed`?"), "{wrong}");
    let wrong = refused(&text.replace("placement = \"given\"\n", ""));
    assert!(
        wrong.contains("has no effect: everything begins at rest"),
        "{wrong}"
    );
}

fn stored(request: &SystemRequest, from: Option<&ResumedSystem>, dir: &Path, stop: f64) -> Run {
    let place = RunLocation::Exactly(dir.to_owned());
    let mut writer = RunWriter::begin(&place, request.initial_info(), &request.text).unwrap();
    let cancel = AtomicBool::new(false);
    let run = execute_from(request, from, &cancel, &mut |event| {
        if matches!(&event, JobEvent::Frame(frame) if frame.time >= stop) {
            cancel.store(true, Ordering::Relaxed);
        }
        writer.event(&event).unwrap();
    });
    writer.finish(&run).unwrap();
    run
}

/// Resumes a run that was stopped, and holds it against one that was not.
fn resumes_to_the_same_bits(text: &str, stop: f64) {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    let request = system_job::request(solved(text).into(), text, "t.toml".to_owned(), Vec::new());
    let request = request.unwrap();
    let whole = stored(&request, None, &at("whole"), f64::INFINITY);
    let stopped = stored(&request, None, &at("first"), stop);
    assert_eq!(stopped.info.state, RunState::Cancelled);
    let (again, from) = resume_request(&at("first"), None).unwrap();
    let resumed = stored(&again, from.as_ref(), &at("second"), f64::INFINITY);
    assert_eq!(resumed.info.state, RunState::Done);
    assert!(resumed.history == whole.history && resumed.summary == whole.summary);
    assert_eq!(resumed.info.happened, whole.info.happened);
}

#[test]
fn a_run_from_off_equilibrium_resumes_to_the_same_bits() {
    for method in METHODS {
        let solver = fixed(method, 1.0, 2000.0, 20.0);
        resumes_to_the_same_bits(&turned_by(20.0, &solver), 0.5);
    }
    resumes_to_the_same_bits(
        &turned_by(
            20.0,
            "[start]\nplacement = \"given\"\n[solver]\nduration_s = 1.0\nerror_estimate = false\n[output]\ninterval_s = 0.05\n",
        ),
        0.5,
    );
}

/// The pull at rest is 101 kN, the strength 1 kN: it goes at once, and once.
#[test]
fn a_line_that_is_too_weak_at_rest_goes_at_time_zero() {
    let case = case_of(&trial("h13_fails_at_once.txt"));
    for method in METHODS {
        let text = format!(
            "{case}\n[solver]\nmethod = \"{method}\"\nduration_s = 30.5\nerror_estimate = false\n[output]\ninterval_s = 0.5\n"
        );
        // The explicit method needs many steps: half a second of it.
        let text = match method {
            "rk4" => text.replace("duration_s = 30.5", "duration_s = 0.5"),
            _ => text,
        };
        let run = moved(&text);
        assert!(
            run.happened[0].starts_with("0.000000 s: end B"),
            "{:?}",
            run.happened
        );
        let gone = run
            .happened
            .iter()
            .filter(|said| said.ends_with("is let go"));
        assert_eq!(gone.count(), 1, "{:?}", run.happened);
        if method == "alpha" {
            let said = "30.000000 s: end B of line line1 is stated to be let go here; it was let go earlier";
            assert_eq!(run.happened[1..], [said]);
        }
        let tension = channel(&run, "tension_n[line1|b]");
        assert!(tension[0] > 1e5 && tension[1] < 2e4, "{tension:?}");
    }
}

/// A rope between two points that may break in its middle.
fn weak(keys: &str, solver: &str) -> String {
    format!(
        "[system]\ntitle = \"weak\"\n{ROPE}
        [points.top]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -1.0]
        [points.end]\nkind = \"fixed\"\nposition_m = [20.0, 0.0, -1.0]
        [[lines]]\nname = \"rope\"\nfrom = \"top\"\nto = \"end\"\nmaterial = \"rope\"\nlength_m = 20.5\nsegments = 8\n{keys}\n{solver}"
    )
}

#[test]
fn every_limit_that_is_exceeded_at_rest_acts_at_time_zero() {
    for method in METHODS {
        let solver = fixed(method, 0.2, 2000.0, 4.0);
        let run = moved(&weak(
            "break_at_m = 8.0\nbreak_n = 10.0\nbreak_s = 0.1",
            &solver,
        ));
        assert_eq!(
            run.happened,
            [
                "0.000000 s: line rope breaks",
                "0.100000 s: line rope is stated to break here; it broke earlier"
            ]
        );
        let run = moved(&weak("release_a_n = 10.0\nrelease_b_n = 20.0", &solver));
        assert_eq!(
            run.happened,
            [
                "0.000000 s: end A of line rope is let go",
                "0.000000 s: end B of line rope is let go"
            ]
        );
        let run = moved(&weak("release_b_n = 1e6", &solver));
        assert!(run.happened.is_empty());
    }
    let text = weak(
        "release_b_n = 10.0\nrelease_b_s = 0.15",
        &fixed("alpha", 0.2, 400.0, 20.0),
    );
    resumes_to_the_same_bits(&text, 0.1);
}

/// Interior segments have `omega² = 4 EA/(m l²)`: the limit is 2.785 / omega, less with damping.
#[test]
fn an_explicit_step_above_the_limit_of_a_line_is_refused_with_its_segment() {
    let steps = |damping: &str, step: f64| {
        let text = weak(
            "",
            &format!(
                "[solver]\nmethod = \"rk4\"\nduration_s = 1.0\ntime_step_s = {step:?}\nerror_estimate = false\n[output]\ninterval_s = 0.25\n"
            ),
        )
        .replace("axial_damping_n_s = 200.0", damping);
        let system = solved(&text);
        let given = system.file.solver.clone().unwrap();
        run(&system, &given, &AtomicBool::new(false), &mut |_| {})
    };
    let length: f64 = 20.5 / 8.0;
    let limit = 2.785 / (4.0 * 2e6 / (2.0 * length * length)).sqrt();
    let why = steps("axial_damping_n_s = 0.0", 1.01 * limit).unwrap_err();
    let said = format!("{}; {}", why.problem, why.remedy);
    let known = format!("is above the stability limit of RK4, {limit:.3e} s, set by segment");
    assert!(
        said.contains(&known) && said.contains("of line rope; choose a smaller step"),
        "{said}"
    );
    let run = steps("axial_damping_n_s = 0.0", 0.98 * limit).unwrap();
    assert_eq!(run.failure, None);
    let tension = channel(&run, "tension_n[rope|a]");
    assert!(tension.iter().all(|t| *t < 1e4), "{tension:?}");
}

const LOOSE: &str = "\
--- LINE TYPES ---
Name Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx
(-)
c 0.1 60 4e8 -1 0 1 1 0 0
--- POINTS ---
ID Type X Y Z M V CdA Ca
(-)
1 Fixed 0 0 -100 0 0 0 0
2 Coupled 120 0 -10 0 0 0 0
3 Free 5 0 -20 500 0.1 0 0
4 Free 6 0 -20 0 0 0 0
--- LINES ---
ID LineType AttachA AttachB UnstrLen NumSegs Outputs
(-)
1 c 1 2 155 20 -
--- OPTIONS ---
100 WtrDpth
";

#[test]
fn a_free_point_of_moordyn_that_nothing_holds_is_said_or_falls() {
    let case = case_of(LOOSE);
    assert!(
        case.contains(
            "Point 3 is free and no line ends at it: it is left out, since nothing holds it"
        ),
        "{case}"
    );
    assert!(
        case.contains(
            "Point 4 is free and no line ends at it: it is left out, since it has no mass"
        ),
        "{case}"
    );
    let case = case_of(&LOOSE.replace("100 WtrDpth", "100 WtrDpth\n0 TmaxIC"));
    assert!(
        !case.contains("Point 3") && case.contains("Point 4"),
        "{case}"
    );
    let run = moved(&format!("{case}{}", fixed("alpha", 1.0, 200.0, 2.0)));
    let net = (500.0 - 1025.0 * 0.1) / 500.0 * G;
    assert_near(last(&run, "z_m[p3]"), -20.0 - 0.5 * net, 1e-6);
}

#[test]
fn what_nothing_holds_is_refused_where_it_does_not_begin_by_the_file() {
    let text = "[system]\ntitle = \"drop\"\n[points.mass]\nkind = \"free\"\nposition_m = [1.0, 2.0, -5.0]\nmass_kg = 100.0\n";
    let said = refused(text);
    assert!(
        said.contains("nothing holds \"mass\"") && said.contains("placement = \"given\""),
        "{said}"
    );
    let held = "[system]\ntitle = \"held\"\n[points.a]\nkind = \"fixed\"\nposition_m = [1.0, 2.0, -5.0]\n[bodies.b]\nkind = \"held\"\n";
    assert!(refused(held).contains("nothing in the system moves"));
    let body = format!("{held}start_velocity_m_per_s = [1.0, 0.0, 0.0]\n");
    assert!(refused(&body).contains("has no effect: the body begins where it is held"));
}
