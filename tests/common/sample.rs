//! A run made by hand, with numbers that are hard to write down.

use seacable::run::{
    Channel, Cost, History, LineShape, Profile, Quantity, Run, RunInfo, RunState, Settings,
    VERSION, Work,
};

/// What `run.toml` holds, with every optional key given.
pub(crate) fn info() -> RunInfo {
    RunInfo {
        id: "sample".to_owned(),
        title: "A title with \"quotes\", a comma and an ö".to_owned(),
        case_file: "sample.toml".to_owned(),
        state: RunState::Done,
        version: VERSION.to_owned(),
        started: "2026-11-21T06:11:26Z".to_owned(),
        overrides: vec!["current.speed_m_per_s=0.4".to_owned()],
        failure: None,
        warnings: vec!["Segment 57 was slack for 12 s.".to_owned()],
        happened: Vec::new(),
        settings: Settings {
            step_tolerance: None,
            numerical_damping: Some(1e-4 / 3.0),
            numerical_damping_period_s: Some(10.0),
            method_reason: Some("it costs less".to_owned()),
            accuracy: None,
            method: "alpha".to_owned(),
            duration_s: 1200.0,
            time_step_s: 0.1 + 0.2,
            time_step_automatic: true,
            rho_inf: Some(0.4),
            stability_limit_s: Some(1.0 / 3.0),
            stability_limit_at: Some("segment 57, wire".to_owned()),
            position_tolerance_m: Some(1e-6),
            nodes: 4,
            output_interval_s: 0.5,
            error_method: "half the step; half the segments".to_owned(),
        },
        work: Work {
            steps: 4800,
            rejections: 2,
            iterations: 9876,
            evaluations: 11,
        },
        cost: Cost {
            cpu_s: 0.061,
            wall_s: 0.1 / 3.0,
            companions_wall_s: 1e-9,
        },
    }
}

/// A complete run.
pub(crate) fn run() -> Run {
    let time: Vec<f64> = (0..50).map(|i| f64::from(i) * 0.1).collect();
    let wave = |scale: f64| time.iter().map(|t| scale * (t * 1.7).sin() / 3.0).collect();
    let channel = |name: &str, scale| Channel {
        id: name.parse().unwrap(),
        values: wave(scale),
        peak: (scale / 3.0 + 1e-13, 0.923_997_8),
        trough: (-scale / 3.0, 2.0 / 7.0),
    };
    let nodes: Vec<[f64; 3]> = (0..4)
        .map(|i| [f64::from(i) / 3.0, -0.0, -1e-300 * f64::from(i)])
        .collect();
    let shapes = [0.0, 5.0 / 3.0].map(|time| LineShape {
        time,
        line: 0,
        nodes: nodes.clone(),
        tension: vec![2.02e6, 0.1, 0.2, 5e-324],
        ..LineShape::default()
    });
    Run {
        info: info(),
        case_text: "# a comment\r\n[case]\ntitle = \"x\"\n".to_owned(),
        history: History {
            time: time.clone(),
            channels: vec![
                channel("tension_n[wire|payload]", 2.02e6),
                channel("z_m[pay,load]", 0.1),
            ],
        },
        shapes: shapes.to_vec(),
        profiles: vec![Profile {
            arc: vec![0.0, 0.1, 0.2, 0.1 + 0.2],
            nodes,
            tension: vec![1.0, 2.0, 3.0, 4.0 / 3.0],
            tension_min: vec![0.0; 4],
            tension_max: vec![1e7 / 7.0; 4],
            z_min: vec![-1400.0 / 3.0; 4],
            z_max: vec![1e-17; 4],
            ..Profile::default()
        }],
        fatigue: Vec::new(),
        summary: vec![
            quantity(
                "tension_n[wire|payload].mean(0..200)",
                7.63e5 / 7.0,
                Some(12.0 / 7.0),
                Some(0.3),
            ),
            quantity("tension_n[wire|payload].max", 2.02e6, Some(0.0), None),
            quantity("z_m[pay,load].final", -1404.38, None, None),
        ],
    }
}

fn quantity(name: &str, value: f64, time_error: Option<f64>, mesh_error: Option<f64>) -> Quantity {
    Quantity {
        id: name.parse().unwrap(),
        value,
        time_error,
        mesh_error,
        unsettled: None,
    }
}
