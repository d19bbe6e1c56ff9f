//! Single lines at rest against independent answers, and the symmetries they must have.

use proptest::prelude::*;
use seacable::statics::catenary::{
    CatenaryError, CatenaryLine, CatenaryShape, EndOffset, RigidBed, SectionProperties, Solution,
};

/// `tests/data/catenary.csv`: lines of every kind with answers from an independent 40-digit solution
/// (forces chosen, end positions computed, forces corrected for the rounding of the positions).
const TABLE: &str = include_str!("../data/catenary.csv");

struct Row {
    kind: String,
    ends: EndOffset,
    section: SectionProperties,
    bed: Option<RigidBed>,
    forces: [f64; 4],
    on_bed: f64,
}

fn rows() -> Vec<Row> {
    let mut reader = csv::Reader::from_reader(TABLE.as_bytes());
    let parse = |cells: &csv::StringRecord, i: usize| cells[i].parse::<f64>();
    reader
        .records()
        .map(|cells| {
            let cells = cells.unwrap();
            let number = |i| parse(&cells, i).unwrap();
            Row {
                kind: cells[0].to_string(),
                ends: EndOffset {
                    x_m: number(1),
                    z_m: number(2),
                },
                section: SectionProperties::new(number(3), number(5), number(4)),
                bed: parse(&cells, 7).ok().map(|below_a_m| RigidBed {
                    below_a_m,
                    slope_rad: number(8).to_radians(),
                    friction: number(6),
                }),
                forces: [number(9), number(10), number(11), number(12)],
                on_bed: number(13),
            }
        })
        .collect()
}

fn line<'a>(
    ends: EndOffset,
    section: &'a [SectionProperties],
    bed: Option<RigidBed>,
) -> CatenaryLine<'a> {
    CatenaryLine {
        ends,
        sections: section,
        bed,
        surface_above_a_m: None,
    }
}

fn forces(s: &Solution) -> [f64; 4] {
    [s.h_b_n, s.v_b_n, s.h_a_n, s.v_a_n]
}

/// Largest difference of end forces over the larger end tension.
fn apart(a: [f64; 4], b: [f64; 4]) -> f64 {
    let size = b[0].hypot(b[1]).max(b[2].hypot(b[3]));
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max)
        / size.max(f64::MIN_POSITIVE)
}

#[test]
fn every_kind_of_line_agrees_with_the_independent_answer() {
    for row in rows() {
        let section = [row.section];
        let rest = line(row.ends, &section, row.bed).solve().expect(&row.kind);
        let error = apart(forces(&rest), row.forces);
        assert!(error < 1e-9, "{}: {error:e}", row.kind);
        let bed = (rest.on_bed_m - row.on_bed).abs();
        assert!(bed < 1e-9 * row.section.length_m, "{}: {bed:e}", row.kind);
    }
}

#[test]
fn the_drawn_line_runs_from_a_to_b_with_the_tension_of_its_ends() {
    for row in rows() {
        let section = [row.section];
        let rest = line(row.ends, &section, row.bed).solve().expect(&row.kind);
        let (a, b) = (rest.at(0.0), rest.at(row.section.length_m));
        let size = row.section.length_m;
        assert!(a.x_m.hypot(a.z_m) < 1e-9 * size, "{}", row.kind);
        let gap = (b.x_m - row.ends.x_m).hypot(b.z_m - row.ends.z_m);
        assert!(gap < 1e-9 * size, "{}: {gap:e}", row.kind);
        let top = rest.tension_b_n().max(rest.tension_a_n());
        assert!(
            (b.tension_n - rest.tension_b_n()).abs() < 1e-9 * top,
            "{}",
            row.kind
        );
        assert!(
            (a.tension_n - rest.tension_a_n()).abs() < 1e-9 * top,
            "{}",
            row.kind
        );
        // Continuous, and nowhere below its lowest point or the bed.
        let low = rest.lowest();
        let mut before = a;
        for i in 1..=200 {
            let point = rest.at(size * f64::from(i) / 200.0);
            assert!(point.z_m >= low.z_m - 1e-9 * size, "{}", row.kind);
            let step = (point.x_m - before.x_m).hypot(point.z_m - before.z_m);
            let stretch = 1.0 + top / row.section.ea_n;
            assert!(
                step <= size / 200.0 * stretch * (1.0 + 1e-9),
                "{}",
                row.kind
            );
            if let Some(bed) = row.bed.filter(|_| row.section.weight_n_per_m > 0.0) {
                let floor = -bed.below_a_m + point.x_m * bed.slope_rad.tan();
                assert!(point.z_m >= floor - 1e-8 * size, "{}", row.kind);
            }
            before = point;
        }
    }
}

#[test]
fn a_warm_start_gives_the_same_answer() {
    for row in rows() {
        let section = [row.section];
        let cold = line(row.ends, &section, row.bed).solve().expect(&row.kind);
        let near = EndOffset {
            x_m: row.ends.x_m * 0.98,
            z_m: row.ends.z_m,
        };
        // From itself, and from a neighbour that may be of another shape.
        let mut starts = vec![cold.clone()];
        starts.extend(line(near, &section, row.bed).solve().ok());
        for start in starts {
            let warm = line(row.ends, &section, row.bed)
                .solve_from(&start)
                .expect(&row.kind);
            assert!(apart(forces(&warm), forces(&cold)) < 1e-9, "{}", row.kind);
            assert_eq!(warm.shape, cold.shape, "{}", row.kind);
        }
    }
}

#[test]
fn end_stiffness_is_the_derivative_of_the_end_force() {
    for row in rows() {
        let section = [row.section];
        let at = |x: f64, z: f64| {
            let ends = EndOffset {
                x_m: row.ends.x_m + x,
                z_m: row.ends.z_m + z,
            };
            line(ends, &section, row.bed).solve()
        };
        let rest = at(0.0, 0.0).expect(&row.kind);
        let k = rest.stiffness_n_per_m;
        let stiff = k.iter().flatten().fold(0.0_f64, |m, v| m.max(v.abs()));
        let top = rest.tension_b_n().max(rest.tension_a_n());
        // A step that changes the force by 1e-5 of itself; not where the shape changes at once.
        // Close above the bed the force grows with the root of the height: stay well within it.
        let height = row.bed.map_or(f64::INFINITY, |bed| {
            bed.below_a_m + row.ends.z_m - row.ends.x_m * bed.slope_rad.tan()
        });
        let step = (1e-5 * top / stiff).min(1e-4 * height);
        if rest.shape == CatenaryShape::WhollyOnBed
            || rest.h_b_n < 1e-9 * top
            || step < 1e-9 * row.ends.x_m
        {
            continue;
        }
        for (column, (x, z)) in [(step, 0.0), (0.0, step)].into_iter().enumerate() {
            let (Ok(up), Ok(down)) = (at(x, z), at(-x, -z)) else {
                continue;
            };
            if up.shape != rest.shape || down.shape != rest.shape {
                continue;
            }
            let found = [
                (up.h_b_n - down.h_b_n) / (2.0 * step),
                (up.v_b_n - down.v_b_n) / (2.0 * step),
            ];
            for (i, found) in found.into_iter().enumerate() {
                let error = (found - k[i][column]).abs() / stiff;
                assert!(error < 1e-5, "{} [{i}][{column}] {error:e}", row.kind);
            }
        }
    }
}

#[test]
fn shapes_have_names() {
    let chain = [SectionProperties::new(100.0, 1000.0, 1e9)];
    let name = |x_m, z_m, below: Option<f64>| {
        let bed = below.map(|below_a_m| RigidBed {
            below_a_m,
            ..RigidBed::default()
        });
        line(EndOffset { x_m, z_m }, &chain, bed)
            .solve()
            .unwrap()
            .shape_name()
    };
    assert_eq!(name(80.0, 20.0, None), "hanging");
    assert_eq!(name(0.0, 20.0, None), "hanging doubled over");
    assert_eq!(name(0.0, 100.1, None), "vertical");
    assert_eq!(name(90.0, 30.0, Some(0.0)), "partly on bed");
    assert_eq!(name(60.0, 30.0, Some(0.0)), "slack on bed");
    assert_eq!(name(100.1, 0.0, Some(0.0)), "wholly on bed");
    assert_eq!(name(80.0, 0.0, Some(20.0)), "U on bed");
    assert_eq!(name(50.0, 0.0, Some(20.0)), "slack U on bed");
}

#[test]
fn a_floating_line_comes_to_rest_against_the_surface() {
    let sunk = [SectionProperties::new(100.0, 500.0, 1e8)];
    let afloat = [SectionProperties::new(100.0, -500.0, 1e8)];
    let bed = RigidBed {
        below_a_m: 15.0,
        ..RigidBed::default()
    };
    let below = line(
        EndOffset {
            x_m: 80.0,
            z_m: 10.0,
        },
        &sunk,
        Some(bed),
    )
    .solve()
    .unwrap();
    let above = CatenaryLine {
        ends: EndOffset {
            x_m: 80.0,
            z_m: -10.0,
        },
        sections: &afloat,
        bed: None,
        surface_above_a_m: Some(15.0),
    };
    let rest = above.solve().unwrap();
    assert_eq!(rest.shape_name(), "arch against surface");
    assert!(
        apart(
            [rest.h_b_n, -rest.v_b_n, rest.h_a_n, -rest.v_a_n],
            forces(&below)
        ) < 1e-12
    );
    assert!((rest.at(50.0).z_m - 15.0).abs() < 1e-12);
    assert!((rest.lowest().z_m + 10.0).abs() < 1e-9);
    let too_low = CatenaryLine {
        surface_above_a_m: Some(-1.0),
        ..above
    };
    assert!(matches!(
        too_low.solve(),
        Err(CatenaryError::EndAboveSurface { .. })
    ));
}

#[test]
fn what_has_no_answer_is_refused_in_words() {
    let refuse = |ends: (f64, f64), section: (f64, f64, f64), bed: Option<RigidBed>| {
        let section = [SectionProperties::new(section.0, section.1, section.2)];
        let ends = EndOffset {
            x_m: ends.0,
            z_m: ends.1,
        };
        line(ends, &section, bed).solve().unwrap_err().to_string()
    };
    let flat = Some(RigidBed::default());
    let chain = (100.0, 1e3, 1e9);
    assert!(refuse((80.0, -1.0), chain, flat).contains("end B lies 1.000000 m below the bed"));
    assert!(refuse((f64::NAN, 1.0), chain, None).contains("x of end B [m] is NaN"));
    assert!(refuse((1.0, 1.0), (0.0, 1e3, 1e9), None).contains("length"));
    assert!(refuse((1.0, 1.0), (10.0, 1e3, -1.0), None).contains("EA"));
    assert!(refuse((1.0, 1.0), (10.0, 0.0, 1e9), None).contains("not determined"));
    assert!(refuse((101.0, 0.0), (100.0, 1e3, f64::INFINITY), None).contains("cannot stretch"));
    let rough = RigidBed {
        below_a_m: 20.0,
        slope_rad: 0.0,
        friction: 0.5,
    };
    assert!(refuse((80.0, 0.0), chain, Some(rough)).contains("friction"));
    let slope = RigidBed {
        below_a_m: 0.0,
        slope_rad: 0.2,
        friction: 0.0,
    };
    assert!(refuse((10.0, 40.0), chain, Some(slope)).contains("slides"));
}

#[test]
fn extremes_give_an_answer_or_a_refusal() {
    let numbers = [
        0.0,
        1e-300,
        1e-30,
        1e-9,
        1.0,
        3e3,
        1e12,
        1e30,
        1e60,
        f64::INFINITY,
        f64::NAN,
    ];
    let signed: Vec<f64> = numbers.iter().flat_map(|v| [*v, -v]).collect();
    for &x_m in &signed {
        for &z_m in &signed {
            for &length in &numbers {
                for &w in &[0.0, 1e-300, 1e-9, 1.0, 1e12, -1.0] {
                    for &ea in &[1e-9, 1.0, 1e5, 1e12, 1e30, f64::INFINITY] {
                        let section = [SectionProperties::new(length, w, ea)];
                        for bed in [None, Some(RigidBed::default())] {
                            if let Ok(rest) = line(EndOffset { x_m, z_m }, &section, bed).solve() {
                                assert!(forces(&rest).iter().all(|f| f.is_finite()));
                                assert!(rest.residual <= 1e-6 && rest.h_b_n >= 0.0);
                            }
                        }
                    }
                }
            }
        }
    }
}

fn any_line() -> impl Strategy<Value = (EndOffset, SectionProperties, Option<RigidBed>)> {
    let bed = prop_oneof![Just(None), (0.0..1.0_f64).prop_map(Some), Just(Some(0.0)),];
    (
        -3.0..4.0_f64,
        -3.0..5.0_f64,
        4.0..14.0_f64,
        0.0..1.3_f64,
        -1.3..1.3_f64,
        bed,
    )
        .prop_map(|(l, w, ea, x, z, below)| {
            let length = 10_f64.powf(l);
            let bed = below.map(|below| RigidBed {
                below_a_m: below * length,
                ..RigidBed::default()
            });
            let section = SectionProperties::new(length, 10_f64.powf(w), 10_f64.powf(ea));
            let ends = EndOffset {
                x_m: x * length,
                z_m: z * length,
            };
            (ends, section, bed)
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn to_the_left_and_upside_down_are_the_same((ends, section, _) in any_line()) {
        let there = line(ends, &[section], None).solve();
        let left = line(EndOffset { x_m: -ends.x_m, ..ends }, &[section], None).solve();
        let floating = SectionProperties { weight_n_per_m: -section.weight_n_per_m, ..section };
        let over = line(EndOffset { z_m: -ends.z_m, ..ends }, &[floating], None).solve();
        let there = there.unwrap();
        prop_assert!(apart(forces(&left.unwrap()), forces(&there)) < 1e-15);
        let over = over.unwrap();
        let turned = [over.h_b_n, -over.v_b_n, over.h_a_n, -over.v_a_n];
        prop_assert!(apart(turned, forces(&there)) < 1e-15);
    }

    #[test]
    fn swapping_the_ends_swaps_the_forces((ends, section, bed) in any_line()) {
        let below = bed.map(|bed| RigidBed { below_a_m: bed.below_a_m + ends.z_m, ..bed });
        let there = line(ends, &[section], bed).solve();
        let back = line(EndOffset { z_m: -ends.z_m, ..ends }, &[section], below).solve();
        if let (Ok(there), Ok(back)) = (there, back) {
            let swapped = [back.h_a_n, -back.v_a_n, back.h_b_n, -back.v_b_n];
            prop_assert!(apart(swapped, forces(&there)) < 1e-9);
        }
    }

    #[test]
    fn scaling_lengths_and_weights_scales_forces((ends, section, bed) in any_line()) {
        // Twice as long and a quarter as heavy by the metre: half the weight, half the forces.
        let half = SectionProperties {
            length_m: 2.0 * section.length_m,
            weight_n_per_m: 0.25 * section.weight_n_per_m,
            ea_n: 0.5 * section.ea_n,
            clump_n: 0.0,
        };
        let wide = EndOffset { x_m: 2.0 * ends.x_m, z_m: 2.0 * ends.z_m };
        let deep = bed.map(|bed| RigidBed { below_a_m: 2.0 * bed.below_a_m, ..bed });
        let there = line(ends, &[section], bed).solve();
        let scaled = line(wide, &[half], deep).solve();
        match (there, scaled) {
            (Ok(there), Ok(scaled)) => {
                prop_assert!(apart(forces(&scaled).map(|f| 2.0 * f), forces(&there)) < 1e-9);
            }
            (a, b) => prop_assert_eq!(a.is_ok(), b.is_ok()),
        }
    }

    #[test]
    fn a_line_always_has_an_answer((ends, section, bed) in any_line()) {
        match line(ends, &[section], bed).solve() {
            Ok(rest) => prop_assert!(rest.residual < 1e-9, "{}", rest.residual),
            Err(CatenaryError::EndBelowBed { .. }) => {}
            Err(other) => prop_assert!(false, "{}", other),
        }
    }
}

mod tables {
    use seacable::study::lines::{TableError, solve};

    #[test]
    fn a_table_keeps_its_rows_and_order_and_says_what_is_wrong_with_a_row() {
        let table = "name,x_m,z_m,length_m,ea_n,weight_n_per_m,bed_below_a_m,h_b_n\n\
                     good,80,20,100,1e9,1000,,999\n\
                     word,80,20,long,1e9,1000,,\n\
                     short,80,20\n\
                     deep,80,-20,100,1e9,1000,5,\n\
                     \"comma, quoted\",80,20,-1,1e9,1000,,\n\
                     again,80,20,100,1e9,1000,,\n";
        let written = solve(table.as_bytes()).unwrap();
        assert_eq!((written.rows, written.refused), (6, 4));
        let text = String::from_utf8(written.text).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(
            lines[0],
            "name,x_m,z_m,length_m,ea_n,weight_n_per_m,bed_below_a_m,h_b_n,v_b_n,h_a_n,v_a_n,on_bed_m,status,shape"
        );
        assert!(lines[1].ends_with(",0,ok,hanging") && !lines[1].contains("999"));
        assert!(lines[2].contains("line 3, column length_m: \"\"long\"\" is not a number"));
        assert!(lines[3].contains("line 4: 3 cells where the first line names 8 columns"));
        assert!(lines[4].contains("line 5: end B lies 15.000000 m below the bed"));
        assert!(
            lines[5].starts_with("\"comma, quoted\"")
                && lines[5].contains("line 6, column length_m")
        );
        assert_eq!(lines[6].replace("again", "good"), lines[1]);
    }

    #[test]
    fn the_missing_columns_of_a_table_are_named() {
        let fault = solve(b"x_m,z_m,length_m\n1,2,3\n").unwrap_err();
        assert!(
            matches!(&fault, TableError::Missing(missing) if missing == "ea_n, weight_n_per_m")
        );
        assert!(solve(b"").is_err());
    }

    #[test]
    fn the_table_of_independent_answers_comes_back_all_ok() {
        let written = solve(super::TABLE.as_bytes()).unwrap();
        assert_eq!(written.refused, 0);
        assert_eq!(written.rows, super::rows().len());
    }
}

mod command {
    use assert_cmd::Command;

    fn seacable() -> Command {
        Command::cargo_bin("seacable").unwrap()
    }

    #[test]
    fn the_command_writes_the_table() {
        let dir = tempfile::tempdir().unwrap();
        let (input, output) = (dir.path().join("in.csv"), dir.path().join("out.csv"));
        std::fs::write(&input, super::TABLE).unwrap();
        let run = |command: &mut Command| command.arg("catenary").arg(&input).assert();
        run(&mut seacable()).success();
        seacable()
            .arg("catenary")
            .arg(&input)
            .arg("-o")
            .arg(&output)
            .assert()
            .success();
        let text = std::fs::read_to_string(&output).unwrap();
        assert_eq!(text.lines().count(), super::TABLE.lines().count());
        assert!(text.lines().skip(1).all(|line| line.contains(",ok,")));
    }

    #[test]
    fn a_refused_row_and_a_missing_file_are_reported() {
        let dir = tempfile::tempdir().unwrap();
        let input = dir.path().join("in.csv");
        let head = "x_m,z_m,length_m,ea_n,weight_n_per_m,bed_below_a_m\n";
        std::fs::write(&input, format!("{head}80,-20,100,1e9,1000,0\n")).unwrap();
        let reported = seacable().arg("catenary").arg(&input).assert().code(1);
        let output = reported.get_output();
        assert!(String::from_utf8_lossy(&output.stdout).contains("below the bed"));
        assert!(String::from_utf8_lossy(&output.stderr).contains("1 of 1 lines"));
        seacable()
            .arg("catenary")
            .arg(dir.path().join("none.csv"))
            .assert()
            .code(2);
    }
}

/// Wholly on a rough slope the tension falls along the line by `w (sin θ + μ cos θ)` per metre, to nothing where friction holds the line.
#[test]
fn a_line_wholly_on_a_slope_has_tensions_and_stiffness_in_closed_form() {
    let (slope, friction): (f64, f64) = (0.2, 0.6);
    let (length, w, ea) = (100.0, 50.0, 1e6);
    let (sin, cos) = slope.sin_cos();
    let loss = w * (sin + friction * cos);
    for t_b in [0.4 * loss * length, 3.0 * loss * length] {
        let moving = length.min(t_b / loss);
        let t_a = (t_b - loss * length).max(0.0);
        let distance = length + 0.5 * (t_b + t_a) * moving / ea;
        let ends = EndOffset {
            x_m: distance * cos,
            z_m: distance * cos * slope.tan(),
        };
        let bed = RigidBed {
            below_a_m: 0.0,
            slope_rad: slope,
            friction,
        };
        let section = [SectionProperties::new(length, w, ea)];
        let rest = line(ends, &section, Some(bed)).solve().unwrap();
        assert_eq!(rest.shape, CatenaryShape::WhollyOnBed);
        let near = |found: f64, expected: f64, of: f64| {
            assert!(
                (found - expected).abs() < 1e-9 * of,
                "{found} for {expected}"
            );
        };
        near(rest.h_b_n, t_b * cos, t_b);
        near(rest.v_b_n, t_b * sin, t_b);
        near(rest.h_a_n, t_a * cos, t_b);
        near(rest.v_a_n.abs(), t_a * sin, t_b);
        let k = ea / moving;
        let [[hx, hz], [vx, vz]] = rest.stiffness_n_per_m;
        for (found, expected) in [
            (hx, k * cos * cos),
            (hz, k * cos * sin),
            (vx, k * cos * sin),
            (vz, k * sin * sin),
        ] {
            near(found, expected, k);
        }
    }
}
