//! Lines of several sections at rest against independent answers, and what must hold for any of them.

use proptest::prelude::*;
use seacable::statics::catenary::{
    CatenaryShape, EndOffset, RigidBed, SectionProperties, Solution,
};

use super::sections::{check_stiffness, line, sections, total};

/// `tests/data/composite.txt`: lines with clumps, buoys, floating sections, on the bed or not; answers from an
/// independent 40-digit solution.
const TABLE: &str = include_str!("../data/composite.txt");

struct Row {
    kind: String,
    ends: EndOffset,
    sections: Vec<SectionProperties>,
    bed: Option<RigidBed>,
    /// h, v_b, v_a, on_bed
    answer: [f64; 4],
}

fn rows() -> Vec<Row> {
    TABLE.lines().skip(1).map(row).collect()
}

fn row(line: &str) -> Row {
    let cells: Vec<&str> = line.split(';').collect();
    let number = |i: usize| cells[i].parse::<f64>().unwrap();
    Row {
        kind: cells[0].to_string(),
        ends: EndOffset {
            x_m: number(1),
            z_m: number(2),
        },
        bed: cells[3].parse().ok().map(flat),
        sections: sections(cells[4]),
        answer: [number(5), number(6), number(7), number(8)],
    }
}

fn flat(below_a_m: f64) -> RigidBed {
    RigidBed {
        below_a_m,
        ..RigidBed::default()
    }
}

#[test]
fn every_kind_agrees_with_the_independent_answer() {
    for row in rows() {
        let rest = line(row.ends, &row.sections, row.bed)
            .solve()
            .expect(&row.kind);
        let [h, v_b, v_a, on_bed] = row.answer;
        let top = h.hypot(v_b.abs().max(v_a.abs()));
        for (found, wanted) in [(rest.h_b_n, h), (rest.v_b_n, v_b), (rest.v_a_n, v_a)] {
            assert!(
                (found - wanted).abs() < 1e-11 * top,
                "{} {found} {wanted}",
                row.kind
            );
        }
        let length = total(&row.sections);
        assert!(
            (rest.on_bed_m - on_bed).abs() < 1e-9 * length,
            "{}",
            row.kind
        );
        let end = rest.at(length);
        let gap = (end.x_m - row.ends.x_m).hypot(end.z_m - row.ends.z_m);
        assert!(gap < 1e-11 * length, "{}", row.kind);
    }
}

#[test]
fn end_stiffness_is_the_derivative_of_the_end_force() {
    for row in rows() {
        check_stiffness(
            &row.kind,
            row.ends,
            |rest| rest.tension_b_n().max(rest.tension_a_n()),
            |ends| line(ends, &row.sections, row.bed).solve().expect(&row.kind),
        );
    }
}

#[test]
fn a_line_cut_in_pieces_is_the_same_line() {
    let whole = [SectionProperties::new(900.0, 1200.0, 5e8)];
    let cut = [
        SectionProperties::new(200.0, 1200.0, 5e8),
        SectionProperties::new(450.0, 1200.0, 5e8),
        SectionProperties::new(250.0, 1200.0, 5e8),
    ];
    for (x_m, z_m, bed) in [
        (800.0, 300.0, None),
        (840.0, 120.0, Some(0.0)),
        (700.0, 400.0, Some(0.0)),
        (840.0, 40.0, Some(60.0)),
        (500.0, 40.0, Some(60.0)),
        (840.0, -60.0, Some(60.0)),
        (910.0, 0.0, Some(0.0)),
        (0.0, 200.0, None),
    ] {
        let ends = EndOffset { x_m, z_m };
        let one = line(ends, &whole, bed.map(flat)).solve().unwrap();
        let many = line(ends, &cut, bed.map(flat)).solve().unwrap();
        let top = one.tension_b_n().max(one.tension_a_n());
        assert!((one.h_b_n - many.h_b_n).abs() < 1e-10 * top, "{x_m} {z_m}");
        assert!((one.v_b_n - many.v_b_n).abs() < 1e-10 * top, "{x_m} {z_m}");
        assert!((one.on_bed_m - many.on_bed_m).abs() < 1e-7, "{x_m} {z_m}");
        assert_eq!(one.shape, many.shape, "{x_m} {z_m}");
    }
}

#[test]
fn a_lazy_wave_rests_rises_over_its_buoys_and_hangs() {
    let riser = [
        SectionProperties::new(300.0, 500.0, 5e8),
        SectionProperties::new(100.0, -600.0, 5e8),
        SectionProperties::new(200.0, 500.0, 5e8),
    ];
    let ends = EndOffset {
        x_m: 400.0,
        z_m: 200.0,
    };
    let rest = line(ends, &riser, Some(RigidBed::default()))
        .solve()
        .unwrap();
    assert_eq!(rest.shape, CatenaryShape::PartlyOnBed);
    let heights: Vec<f64> = (0..=600).map(|s| rest.at(f64::from(s)).z_m).collect();
    let turns = heights
        .windows(3)
        .filter(|w| (w[1] - w[0]) * (w[2] - w[1]) < 0.0)
        .count();
    assert_eq!(turns, 2, "an arch and a sag between bed and top");
}

#[test]
fn a_body_heavier_than_its_buoy_rests_on_the_bed_between_two_equilibria() {
    let mooring = [
        SectionProperties {
            clump_n: -6e4,
            ..SectionProperties::new(150.0, 300.0, 5e8)
        },
        SectionProperties::new(300.0, 300.0, 5e8),
        SectionProperties::new(150.0, 300.0, 5e8),
    ];
    let ends = EndOffset {
        x_m: 500.0,
        z_m: 100.0,
    };
    let rest = line(ends, &mooring, Some(RigidBed::default()))
        .solve()
        .unwrap();
    assert_eq!(rest.shape, CatenaryShape::ManyOnBed);
    assert!(rest.at(150.0).z_m > 10.0 && rest.on_bed_m > 10.0);
    no_deeper_than_the_bed(&rest, total(&mooring), 0.0);
}

#[test]
fn a_slack_line_hangs_plumb_on_both_sides_however_its_weight_rounds() {
    // The vertical force where the first leg touches down is the rounding of 98.2 N - 28.7 N - 69.5 N.
    let sections = [
        SectionProperties::new(
            32.529_601_634_673_76,
            3.019_765_801_797_352_5,
            49_988_126_491.875_07,
        ),
        SectionProperties::new(28.835_618_092_323_86, 1.0, 1e6),
    ];
    let length = total(&sections);
    let below = 0.154_951_762_500_636_41 * length;
    let ends = EndOffset {
        x_m: 0.01 * length,
        z_m: 0.0,
    };
    let rest = line(ends, &sections, Some(flat(below))).solve().unwrap();
    assert_eq!(rest.shape, CatenaryShape::SlackTroughOnBed);
    assert!(rest.residual < 1e-14 && rest.h_b_n == 0.0);
    // Each leg as long as the bed is deep, but for its stretch.
    assert!(
        (rest.v_b_n - below).abs() < 1e-4
            && (rest.v_a_n / sections[0].weight_n_per_m + below).abs() < 1e-4
    );
}

#[test]
fn a_line_lies_exactly_as_long_as_its_bed_either_way_round() {
    let sections = [
        SectionProperties::new(258.502_978_499_591_6, 3819.0, 1.16e10),
        SectionProperties::new(209.352_315_955_867_6, 8.05, 8.28e9),
        SectionProperties::new(413.129_640_213_824_9, 821.2, 1.43e6),
    ];
    let round = [sections[2], sections[1], sections[0]];
    let ends = EndOffset {
        x_m: total(&sections),
        z_m: 0.0,
    };
    for sections in [sections, round] {
        let rest = line(ends, &sections, Some(flat(0.0))).solve().unwrap();
        assert!(rest.h_b_n < 1e-6 && rest.on_bed_m == total(&sections));
    }
}

#[test]
fn sections_that_cannot_stretch_are_the_limit_of_stiff_ones() {
    let of = |ea: f64| {
        [
            SectionProperties::new(500.0, 1200.0, ea),
            SectionProperties::new(400.0, 600.0, ea),
        ]
    };
    let ends = EndOffset {
        x_m: 840.0,
        z_m: 120.0,
    };
    for bed in [None, Some(flat(0.0))] {
        let h = |ea: f64| line(ends, &of(ea), bed).solve().unwrap().h_b_n;
        assert!((h(1e15) / h(f64::INFINITY) - 1.0).abs() < 1e-7);
    }
}

fn no_deeper_than_the_bed(rest: &Solution, length: f64, below: f64) {
    for i in 0..=500 {
        let point = rest.at(length * f64::from(i) / 500.0);
        assert!(
            point.z_m >= -below - 1e-8 * length,
            "{} {}",
            point.arc_m,
            point.z_m
        );
        assert!(point.tension_n.is_finite() && point.x_m.is_finite());
    }
}

fn any_section() -> impl Strategy<Value = SectionProperties> {
    let body = prop_oneof![
        3 => Just(0.0),
        1 => (1.0..5.0_f64).prop_map(|c| 10_f64.powf(c)),
        1 => (1.0..5.0_f64).prop_map(|c| -10_f64.powf(c)),
    ];
    (
        0.5..3.0_f64,
        0.0..4.0_f64,
        6.0..11.0_f64,
        prop_oneof![Just(1.0), Just(1.0), Just(-0.3)],
        body,
    )
        .prop_map(|(l, w, ea, sign, clump_n)| SectionProperties {
            length_m: 10_f64.powf(l),
            weight_n_per_m: sign * 10_f64.powf(w),
            ea_n: 10_f64.powf(ea),
            clump_n,
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn any_line_rests_on_its_bed_and_ends_where_it_should(
        mut sections in prop::collection::vec(any_section(), 1..7),
        x in 0.01..1.02_f64, z in -0.3..0.6_f64, depth in 0.0..0.4_f64, bed in any::<bool>(),
    ) {
        sections.last_mut().unwrap().clump_n = 0.0;
        let length = total(&sections);
        let below = depth * length;
        let ends = EndOffset { x_m: x * length, z_m: z.max(-depth) * length };
        let rest = line(ends, &sections, bed.then(|| flat(below))).solve();
        prop_assert!(rest.is_ok(), "{:?}", rest);
        let rest = rest.unwrap();
        let end = rest.at(length);
        let gap = (end.x_m - ends.x_m).hypot(end.z_m - ends.z_m);
        prop_assert!(gap < 1e-8 * length, "{gap:e}");
        if bed {
            no_deeper_than_the_bed(&rest, length, below);
        }
        // Turned round end for end: the same forces at the same places.
        let mut round: Vec<SectionProperties> = sections.iter().rev().copied().collect();
        for i in 0..round.len() {
            round[i].clump_n = if i + 1 < round.len() { sections[round.len() - 2 - i].clump_n } else { 0.0 };
        }
        let back = EndOffset { z_m: -ends.z_m, ..ends };
        let turned = line(back, &round, bed.then(|| flat(below + ends.z_m))).solve();
        prop_assert!(turned.is_ok(), "turned {:?}", turned);
        let turned = turned.unwrap();
        let top = rest.tension_a_n().max(rest.tension_b_n()).max(1.0);
        prop_assert!((turned.h_a_n - rest.h_b_n).abs() < 1e-7 * top);
        prop_assert!((turned.v_a_n + rest.v_b_n).abs() < 1e-7 * top);
    }
}
