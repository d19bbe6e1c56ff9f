//! Tables of numbers: those that cases name, coefficients of floating bodies, lines at rest.

use std::collections::BTreeMap;

use seacable::case::{
    self, Attachment, BedInterpolation, Current, Diagnostic, current_grid, depth_grid, kind,
    shipped,
};
use seacable::scene;
use seacable::ship::Ship;
use seacable::ship::motion::wave_response::WaveResponse;
use seacable::study::lines;
use seacable::system::potential_flow::{Scales, wamit};

use super::Target;
use super::cases::shown;
use super::place::{contained, file, path, put};

pub(super) const ALL: &[Target] = &[
    Target {
        name: "motion_table",
        run: |data| moved_by(data, "table"),
        seeds: || {
            vec![b"time_s,x_m,y_m,z_m\n0,0,0,0\n0.6,0,0,0\n1.3,0,0,0\n3.1,0,0,2\n4,0,0,2\n20,0,0,2\n".to_vec()]
        },
        share: 50,
    },
    Target {
        name: "vessel_table",
        run: |data| moved_by(data, "vessel"),
        seeds: || vec![VESSEL.as_bytes().to_vec()],
        share: 50,
    },
    Target {
        name: "depths",
        run: depths,
        seeds: || {
            texts(&[
                "x_m,y_m,depth_m\n-10,-5,30\n0,-5,31\n10,-5,32\n-10,5,30\n0,5,31\n10,5,32\n",
                "3 2\n-10 0 10\n-5 5\n-10 -5 -30\n0 -5 -31\n10 -5 -32\n-10 5 -30\n0 5 -31\n10 5 -32\n",
                "--- MoorPy Bathymetry Input File ---\nnGridX 3\nnGridY 2\n      -10    0   10\n-5     30   31   32\n 5     30   31   32\n",
            ])
        },
        share: 600,
    },
    Target {
        name: "current",
        run: current,
        seeds: || {
            texts(&[
                "t_s,z_m,u_m_per_s,v_m_per_s\n0,-40,0,0\n0,0,0.5,0\n10,-40,0,0\n10,0,1,0.1\n",
                "title\n\n\n\n-40 -20 0\n\n0 0 0.2 0.4\n10 0 0.4 0.8 1 2 3\n",
                "1 1 2 2\n5\n0\n-30 0\n0 15\n5 0 -30 0 1 2 3\n5.0 0 -30 15 4 5 6\n5 0 -0 0 7 8 9\n5 0 0 15 1 1 1\n",
            ])
        },
        share: 1000,
    },
    Target {
        name: "published_curve",
        run: curve,
        seeds: || texts(&["time_s,value\n0,1\n1,2.5\n2,-3e1\n"]),
        share: 50,
    },
    Target {
        name: "load_cases",
        run: load_cases,
        seeds: || {
            texts(&[
                "current.speed_m_per_s,probability\n0.1,0.25\n0.4,0.75\n",
                "solver.duration_s, occurrences\n2 s, 3\n4, 9\n",
            ])
        },
        share: 200,
    },
    Target {
        name: "wamit_radiation",
        run: |data| {
            coefficients(data, |text, scales| {
                wamit::radiation(text, "a.1", scales).map(drop)
            })
        },
        seeds: || head(radiation_at_finite_periods()),
        share: 500,
    },
    Target {
        name: "wamit_excitation",
        run: |data| {
            coefficients(data, |text, scales| {
                wamit::excitation(text, "a.3", scales).map(drop)
            })
        },
        seeds: || head(include_str!("../../../cases/systems/volturnus_data/semi.3")),
        share: 300,
    },
    Target {
        name: "wamit_drift",
        run: |data| {
            coefficients(data, |text, scales| {
                wamit::drift(text, "a.12d", scales).map(drop)
            })
        },
        seeds: || {
            head(include_str!(
                "../../../cases/systems/volturnus_data/semi.12d"
            ))
        },
        share: 200,
    },
    Target {
        name: "ship_responses",
        run: responses,
        seeds: || head(include_str!("../../../cases/ship/landing_craft.csv")),
        share: 3,
    },
    Target {
        name: "lines_at_rest",
        run: lines_at_rest,
        seeds: || {
            texts(&[
                &include_str!("../../data/catenary.csv")[..1500],
                "Ax,Ay,Az,Bx,By,Bz,L,w_Npm,EA_N,d_m,Cd,CdAx,rho,Ux,Uy,Uz\n-600,0,-800,0,0,0,1050,200,1e9,0.2,1.2,0,1025,0,0.5,0\n",
                r#"{"a_m": [-600, 0, -800], "b_m": [0, 0, 0], "sections": [[400, 200, 1e9], [650, 200, 1e9, 0]], "diameter_m": 0.2, "drag_normal": 1.2, "current": [[0, 0.5, 0.0], [400, 0.0, 0.5], [800, -0.5, 0.0]]}"#,
            ])
        },
        share: 20,
    },
];

/// The responses of a vessel at two periods.
const VESSEL: &str = "period_s,surge_m_per_m,surge_phase_deg,sway_m_per_m,sway_phase_deg,heave_m_per_m,heave_phase_deg,roll_deg_per_m,roll_phase_deg,\
    pitch_deg_per_m,pitch_phase_deg,yaw_deg_per_m,yaw_phase_deg\n5,0.2,90,0,0,0.3,10,0,0,1,90,0,0\n12,0.6,90,0,0,0.9,0,0,0,2,90,0,0\n";

fn texts(all: &[&str]) -> Vec<Vec<u8>> {
    all.iter().map(|text| text.as_bytes().to_vec()).collect()
}

/// The rows after those of infinite periods.
fn radiation_at_finite_periods() -> &'static str {
    let text = include_str!("../../../cases/systems/volturnus_data/semi.1");
    &text[text.find("6.283186E+01").unwrap_or(0)..]
}

/// The first rows of a long table: rows are alike.
fn head(text: &str) -> Vec<Vec<u8>> {
    let rows: Vec<&str> = text.lines().take(40).collect();
    vec![rows.join("\n").into_bytes()]
}

/// A line case that carries a file.
fn carrying(keys: &str, name: &str, text: &str) -> String {
    let text = toml::Value::String(text.to_owned());
    format!(
        "case.title = \"A line\"\nmaterials.rope = {{ diameter_m = 0.1, mass_kg_per_m = 10.0, ea_n = 1e6 }}\n\
         line = [{{ name = \"rope\", material = \"rope\", length_m = 30.0, segments = 3 }}]\n\
         ends.b = {{ name = \"low\", kind = \"payload\" }}\n\
         payload = {{ dry_mass_kg = 1000.0, wet_mass_kg = 900.0, drag_area_m2 = 1.0, added_mass_kg = 10.0 }}\n\
         solver.duration_s = 3.0\n{keys}files.\"{name}\".text = {text}\n"
    )
}

/// Reads a line case and builds it.
fn built(text: &str) -> bool {
    match case::parse(text, &file("case.toml")) {
        Ok(case) => scene::build(&case, 1).is_ok(),
        Err(faults) => shown(&faults),
    }
}

/// An end that moves by a table.
fn moved_by(data: &[u8], motion: &str) -> bool {
    let ends = format!(
        "ends.a = {{ name = \"ship\", kind = \"moving\", motion = \"{motion}\", motion_file = \"m.csv\", position_m = [0.0, 0.0, -1.0] }}\n"
    );
    let waves = match motion {
        "vessel" => {
            "waves = { kind = \"regular\", height_m = 2.0, period_s = 8.0, depth_m = 100.0 }\n"
        }
        _ => "",
    };
    built(&carrying(&(ends + waves), "m.csv", &contained(data)))
}

fn curve(data: &[u8]) -> bool {
    let keys = "ends.a = { name = \"ship\", kind = \"fixed\", position_m = [0.0, 0.0, -1.0] }\n\
        published_curve = [{ name = \"tension\", channel = \"tension_n[ship|rope]\", points_file = \"c.csv\", source = \"figure 1\", \
         tolerance_percent = 5.0, inputs = \"published\" }]\n";
    built(&carrying(keys, "c.csv", &contained(data)))
}

fn load_cases(data: &[u8]) -> bool {
    let keys = "ends.a = { name = \"ship\", kind = \"fixed\", position_m = [0.0, 0.0, -1.0] }\n\
        current = { speed_m_per_s = 0.5 }\nload_cases = [{ file = \"l.csv\" }]\n";
    built(&carrying(keys, "l.csv", &contained(data)))
}

fn one(name: &str, data: &[u8]) -> BTreeMap<String, Attachment> {
    let text = contained(data).into();
    [(name.to_owned(), Attachment { text })].into()
}

fn depths(data: &[u8]) -> bool {
    let files = one("bed.csv", data);
    let both = [BedInterpolation::Bilinear, BedInterpolation::Smooth];
    let read = both.map(|how| match depth_grid((Some("bed.csv"), how), &files) {
        Ok(grid) => grid.is_some(),
        Err(fault) => shown(&[fault]),
    });
    read == [true; 2]
}

fn current(data: &[u8]) -> bool {
    let files = one("current.csv", data);
    let named = Current {
        file: Some("current.csv".to_owned()),
        ..Current::default()
    };
    match current_grid(&named, &files) {
        Ok(grid) => grid.is_some(),
        Err(fault) => shown(&[fault]),
    }
}

fn coefficients(data: &[u8], read: fn(&str, &Scales) -> Result<(), Diagnostic>) -> bool {
    let text = contained(data);
    let scales = Scales {
        density: 1025.0,
        gravity: 9.81,
        length: 1.0,
    };
    read(&text, &scales).map_or_else(|fault| shown(&[fault]), |()| true)
}

/// Response amplitude operators of a ship.
fn responses(data: &[u8]) -> bool {
    let text = contained(data);
    put(&path("raos.csv"), text.as_bytes());
    let ship = shipped::text("ship/coupled.toml").unwrap_or_default();
    let ship = kind::parse::<Ship>(ship, &file("ship.toml")).unwrap().ship;
    let mut settings = ship.motion.unwrap();
    settings.responses = Some("raos.csv".to_owned());
    let read = WaveResponse::read(&settings, 0.1, path("").as_path());
    read.map_or_else(|fault| shown(&[fault]), |_| true)
}

/// Every row keeps its place, answered or refused.
fn lines_at_rest(data: &[u8]) -> bool {
    let Ok(table) = lines::solve(data) else {
        return false;
    };
    assert!(table.refused <= table.rows);
    table.refused < table.rows
}
