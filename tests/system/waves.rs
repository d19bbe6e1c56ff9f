//! Systems in waves: closed forms of floating and submerged bodies, lines against line cases, responses, short-crested seas.

use std::f64::consts::{PI, TAU};

use seacable::system::motion::run::MotionRun;

use crate::motion::{channel, moved, refused};

const G: f64 = 9.80665;

/// Amplitude and lead over `cos(omega t)` of a channel at a period of a whole number of rows, over the last periods.
pub(crate) fn swing(run: &MotionRun, name: &str, period: f64, periods: f64) -> (f64, f64) {
    swing_in(&run.history.time, channel(run, name), period, periods)
}

/// The same of values over time.
pub(crate) fn swing_in(time: &[f64], values: &[f64], period: f64, periods: f64) -> (f64, f64) {
    let end = time.last().unwrap() + 0.5 * (time[1] - time[0]);
    let rows = time.iter().zip(values);
    let last = rows.filter(|(t, _)| **t > end - period * periods);
    let (mut cosine, mut sine, mut count) = (0.0, 0.0, 0.0);
    for (t, value) in last {
        let (s, c) = (TAU / period * t).sin_cos();
        cosine += value * c;
        sine += value * s;
        count += 1.0;
    }
    let (cosine, sine) = (2.0 * cosine / count, 2.0 * sine / count);
    (cosine.hypot(sine), (-sine).atan2(cosine))
}

pub(crate) const SOFT: &str = "
[materials.soft]
mass_kg_per_m = 0.01
diameter_m = 0.004
ea_n = 2e3
";

pub(crate) fn solver(duration: f64, step: f64, interval: f64) -> String {
    format!(
        "[solver]\nduration_s = {duration:?}\ntime_step_s = {step:?}\nerror_estimate = false\n[output]\ninterval_s = {interval:?}\n"
    )
}

/// Three soft lines around a body on a circle of a radius.
pub(crate) fn held(body: &str) -> String {
    format!(
        "{SOFT}
        [points.anchor]\nkind = \"fixed\"\nposition_m = [150.0, 0.0, -5.0]
        [points.fairlead]\nkind = \"body\"\nbody = \"{body}\"\nposition_m = [3.0, 0.0, -5.0]
        [[lines]]\nname = \"soft\"\nfrom = \"anchor\"\nto = \"fairlead\"\nmaterial = \"soft\"\nlength_m = 140.0\nsegments = 6
        repeat_at_deg = [0.0, 120.0, 240.0]\n"
    )
}

#[test]
fn a_spar_heaves_as_its_closed_form() {
    // In long waves the pressure on the bottom of a cylinder is rho g a exp(-k d): with heave stiffness rho g A and mass rho A d
    // the response is exp(-k d) / (1 - omega² d / g), damping apart.
    let (radius, draft, amplitude) = (3.0, 40.0, 0.05);
    let mass = 1025.0 * PI * radius * radius * draft;
    for period in [9.0, 20.0] {
        let omega = TAU / period;
        let run = moved(&format!(
            "[environment]\nwater_density_kg_per_m3 = 1025.0\n
            [[waves]]\nkind = \"regular\"\nheight_m = {:?}\nperiod_s = {period:?}\nramp_s = 30.0
            [bodies.spar]\nkind = \"free\"\nmass_kg = {mass:?}\ncentre_of_gravity_m = [0.0, 0.0, -25.0]
            inertia_kg_m2 = [2e8, 2e8, 1e7]\ndamping = [2e4, 2e4, 8e4, 3e7, 3e7, 1e7]
            [[bodies.spar.members]]\nfrom_m = [0.0, 0.0, -40.0]\nto_m = [0.0, 0.0, 12.0]\ndiameter_m = 6.0\nadded_mass_normal = 1.0
            {}{}",
            2.0 * amplitude,
            held("spar"),
            solver(260.0, 0.1, 0.1)
        ));
        let (heave, _) = swing(&run, "z_m[spar]", period, 3.0);
        let k = omega * omega / G;
        let stiffness = 1025.0 * G * PI * radius * radius;
        let inertia = stiffness - omega * omega * mass;
        let exact = amplitude * (-k * draft).exp() * stiffness / inertia.hypot(8e4 * omega);
        assert!(
            (heave / exact - 1.0).abs() < 0.01,
            "{period}: {heave} {exact}"
        );
        // What the waves put in is accounted for.
        assert!(run.balance.relative_drift() < 2e-3, "{:?}", run.balance);
    }
}

#[test]
fn a_neutral_ball_moves_as_the_water_around_it() {
    // Low waves: the local acceleration of linear theory leaves a mean force of second order, which nothing holds here.
    let (amplitude, period, depth) = (0.03, 8.0, 10.0_f64);
    let omega = TAU / period;
    let run = moved(&format!(
        "{SOFT}
        [[waves]]\nkind = \"regular\"\nheight_m = {:?}\nperiod_s = {period:?}\nramp_s = 40.0\ndirection_deg = 90.0
        [points.below]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -150.0]
        [points.ball]\nkind = \"free\"\nmass_kg = 1025.0\nvolume_m3 = 1.0\nadded_mass_kg = 512.5\nposition_m = [0.0, 0.0, {:?}]
        [[lines]]\nname = \"tether\"\nfrom = \"below\"\nto = \"ball\"\nmaterial = \"soft\"\nlength_m = 139.99\nsegments = 8
        {}",
        2.0 * amplitude, -depth, solver(120.0, 0.1, 0.1)
    ));
    let heights = channel(&run, "z_m[ball]");
    let z = heights.iter().sum::<f64>() / heights.len() as f64;
    let orbit = amplitude * (omega * omega / G * z).exp();
    // The tether is a spring of 2e3 / 139.99 N/m along its axis.
    let spring = 1.0 - 2e3 / 139.99 / (1025.0 * 1.5 * omega * omega);
    for (name, by_tether) in [("y_m[ball]", 1.0), ("z_m[ball]", spring)] {
        let (swing, _) = swing(&run, name, period, 3.0);
        let swing = swing * by_tether;
        assert!(
            (swing / orbit - 1.0).abs() < 0.004,
            "{name}: {swing} {orbit}"
        );
    }
    let (across, _) = swing(&run, "x_m[ball]", period, 3.0);
    assert!(across < 1e-6, "{across}");
}

/// A table of responses: heave 0.5 m/m 30 deg ahead, roll 2 deg/m, in head and beam seas.
pub(crate) const RESPONSES: &str = "heading_deg,period_s,surge_m_per_m,surge_phase_deg,sway_m_per_m,sway_phase_deg,heave_m_per_m,heave_phase_deg,roll_deg_per_m,roll_phase_deg,pitch_deg_per_m,pitch_phase_deg,yaw_deg_per_m,yaw_phase_deg
0,5,0.4,90,0,0,0.5,30,0,0,1,0,0,0
0,20,0.4,90,0,0,0.5,30,0,0,1,0,0,0
90,5,0,0,0.4,90,0.5,30,2,0,0,0,0,0
90,20,0,0,0.4,90,0.5,30,2,0,0,0,0,0
180,5,0.4,90,0,0,0.5,30,0,0,1,0,0,0
180,20,0.4,90,0,0,0.5,30,0,0,1,0,0,0
";

fn vessel(waves: &str, keys: &str, files: &str) -> String {
    format!(
        "{SOFT}{waves}
        [bodies.vessel]\nkind = \"moved\"\nyaw_deg = 90.0\nposition_m = [20.0, 0.0, 0.0]\n{keys}
        [points.stern]\nkind = \"body\"\nbody = \"vessel\"\nposition_m = [-50.0, 0.0, 0.0]
        [points.anchor]\nkind = \"fixed\"\nposition_m = [20.0, -60.0, -100.0]
        [[lines]]\nname = \"riser\"\nfrom = \"anchor\"\nto = \"stern\"\nmaterial = \"soft\"\nlength_m = 105.0\nsegments = 6
        {}{files}",
        solver(60.0, 0.1, 0.1)
    )
}

#[test]
fn a_vessel_follows_its_responses() {
    let files = format!("[files.\"r.csv\"]\ntext = \"\"\"{RESPONSES}\"\"\"\n");
    let waves = "[[waves]]\nkind = \"regular\"\nheight_m = 2.0\nperiod_s = 10.0\n";
    let run = moved(&vessel(waves, "response_file = \"r.csv\"", &files));
    // Waves along +x come from the starboard side of a vessel that points along +y: its sway is along -x.
    let k = TAU.powi(2) / 100.0 / G;
    let expected = [
        ("x_m[vessel]", 0.4, 90.0),
        ("z_m[vessel]", 0.5, 30.0),
        ("roll_deg[vessel]", -2.0, 0.0),
    ];
    for (name, size, lead) in expected {
        let (found, phase) = swing(&run, name, 10.0, 3.0);
        let lead = f64::to_radians(lead) - k * 20.0;
        // x along the waves is minus the sway, which a mirrored table turns about once more.
        let wanted = (f64::abs(size), if size < 0.0 { lead + PI } else { lead });
        assert!(
            (found - wanted.0).abs() < 1e-3,
            "{name}: {found} {}",
            wanted.0
        );
        let off = (phase - wanted.1 + PI).rem_euclid(TAU) - PI;
        assert!(off.abs() < 1e-2, "{name}: {phase} {}", wanted.1);
    }
}

#[test]
fn responses_that_do_not_fit_are_refused() {
    let files = format!("[files.\"r.csv\"]\ntext = \"\"\"{RESPONSES}\"\"\"\n");
    let waves = "[[waves]]\nkind = \"regular\"\nheight_m = 2.0\nperiod_s = 10.0\n";
    let with = |waves: &str, keys: &str| refused(&vessel(waves, keys, &files));
    assert!(with("", "response_file = \"r.csv\"").contains("no waves to respond to"));
    let twice = with(
        waves,
        "response_file = \"r.csv\"\namplitude_m = [1.0, 0.0, 0.0]\nperiod_s = [5.0]",
    );
    assert!(twice.contains("prescribed motion too"), "{twice}");
    let absent = with(waves, "response_file = \"other.csv\"");
    assert!(absent.contains("cannot be read"), "{absent}");
    let height = with("[[waves]]\nkind = \"regular\"\nperiod_s = 10.0\n", "");
    assert!(height.contains("regular waves have a height"), "{height}");
    let bad = format!(
        "[files.\"r.csv\"]\ntext = \"\"\"{}\"\"\"\n",
        RESPONSES.replace("0,20,", "0,-20,")
    );
    let bad = refused(&vessel(waves, "response_file = \"r.csv\"", &bad));
    assert!(bad.contains("r.csv"), "{bad}");
}

#[test]
fn swell_and_spread_wind_sea_have_the_height_of_both() {
    let run = moved(&vessel(
        "[[waves]]\nkind = \"irregular\"\nsignificant_height_m = 2.0\npeak_period_s = 8.0\nspreading_exponent = 4.0\n
         [[waves]]\nkind = \"irregular\"\nsignificant_height_m = 1.5\npeak_period_s = 14.0\ndirection_deg = 60.0\n",
        "",
        "",
    ));
    let system = crate::solved(&format!(
        "{}{}",
        crate::HEAD,
        vessel(
            "[[waves]]\nkind = \"irregular\"\nsignificant_height_m = 2.0\npeak_period_s = 8.0\nspreading_exponent = 4.0\n",
            "",
            ""
        )
    ));
    let sea = system.network.sea.unwrap();
    assert_eq!(sea.fields().len(), 24);
    // Every component is there once: amplitudes are those of the whole spectrum.
    let energy: f64 = sea
        .at_point(&seacable::numerics::V3::zeros())
        .iter()
        .map(|c| 0.5 * c.amplitude.powi(2))
        .sum();
    assert!((4.0 * energy.sqrt() / 2.0 - 1.0).abs() < 1e-9);
    let heights = channel(&run, "wave_elevation_m[gauge]");
    let rms = (heights.iter().map(|h| h * h).sum::<f64>() / heights.len() as f64).sqrt();
    // Over a minute alone: of the size of 2.5 m significant.
    assert!((0.3..1.0).contains(&rms), "{rms}");
}

/// A line between two held points in a wave, with this gauge.
fn gauged(gauge: &str) -> String {
    format!(
        "[environment]\nwater_density_kg_per_m3 = 1025.0
        [[waves]]\nkind = \"regular\"\nheight_m = 2.0\nperiod_s = 8.0\n{gauge}{SOFT}
        [points.anchor]\nkind = \"fixed\"\nposition_m = [30.0, 0.0, -5.0]
        [points.buoy]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -5.0]
        [[lines]]\nname = \"soft\"\nfrom = \"anchor\"\nto = \"buoy\"\nmaterial = \"soft\"\nlength_m = 29.0\nsegments = 6
        {}",
        solver(4.0, 0.1, 0.1)
    )
}

#[test]
fn waves_are_recorded_over_a_point() {
    let elevation = |gauge: &str| {
        let run = moved(&gauged(gauge));
        channel(&run, "wave_elevation_m[gauge]").to_vec()
    };
    let over = elevation("gauge_over = \"anchor\"");
    assert_eq!(over, elevation("gauge_m = [30.0, 0.0]"));
    assert_ne!(over, elevation("gauge_m = [0.0, 0.0]"));
}

#[test]
fn a_gauge_over_nothing_is_refused() {
    for (gauge, problem) in [
        ("gauge_over = \"anker\"", "anchor"),
        (
            "gauge_over = \"anchor\"\ngauge_m = [0.0, 0.0]",
            "two places",
        ),
    ] {
        let message = refused(&gauged(gauge));
        assert!(
            message.contains("gauge_over") && message.contains(problem),
            "{message}"
        );
    }
}
