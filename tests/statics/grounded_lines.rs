//! Lines of several sections that lie from A on a rough or sloping bed, against independent answers and against lines
//! of one section.

use proptest::prelude::*;
use seacable::statics::catenary::{
    CatenaryError, CatenaryLine, CatenaryShape, EndOffset, RigidBed, SectionProperties, Solution,
};

use super::sections::{check_stiffness, forces, line, sections, total};

/// Forces chosen, end positions computed with 50 digits, forces corrected for the rounding of the positions.
const TABLE: &str = include_str!("../data/grounded_lines.txt");

struct Row {
    kind: String,
    ends: EndOffset,
    sections: Vec<SectionProperties>,
    bed: RigidBed,
    /// h_b, v_b, h_a, v_a, on_bed
    answer: [f64; 5],
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
        bed: RigidBed {
            below_a_m: number(3),
            slope_rad: number(4).to_radians(),
            friction: number(5),
        },
        sections: sections(cells[6]),
        answer: [7, 8, 9, 10, 11].map(number),
    }
}

#[test]
fn every_line_agrees_with_the_independent_answer() {
    for row in rows() {
        let rest = line(row.ends, &row.sections, row.bed)
            .solve()
            .expect(&row.kind);
        let top = rest.tension_b_n().max(rest.tension_a_n());
        for (found, wanted) in forces(&rest).iter().zip(row.answer) {
            assert!(
                (found - wanted).abs() < 1e-10 * top,
                "{} {found} {wanted}",
                row.kind
            );
        }
        let length = total(&row.sections);
        assert!(
            (rest.on_bed_m - row.answer[4]).abs() < 1e-9 * length,
            "{}",
            row.kind
        );
        let end = rest.at(length);
        let gap = (end.x_m - row.ends.x_m).hypot(end.z_m - row.ends.z_m);
        assert!(gap < 1e-11 * length, "{} {gap:e}", row.kind);
        assert!((rest.at(0.0).tension_n - rest.tension_a_n()).abs() < 1e-9 * top);
    }
}

#[test]
fn end_stiffness_is_the_derivative_of_the_end_force() {
    for row in rows() {
        check_stiffness(&row.kind, row.ends, Solution::tension_b_n, |ends| {
            line(ends, &row.sections, row.bed).solve().expect(&row.kind)
        });
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
    for (x_m, z_m, slope, friction) in [
        (840.0, 120.0, 0.0, 0.7),
        (700.0, 400.0, 0.0, 0.7),
        (400.0, 300.0, 0.0, 0.7),
        (900.5, 0.0, 0.0, 0.2),
        (840.0, 200.0, 0.1, 0.0),
        (860.0, 20.0, -0.1, 0.0),
        (840.0, 200.0, 0.1, 0.7),
        (860.0, 20.0, -0.1, 0.7),
        (300.0, 350.0, 0.1, 0.7),
        (850.0, 300.0, 0.1, 0.7),
    ] {
        let bed = RigidBed {
            below_a_m: 0.0,
            slope_rad: slope,
            friction,
        };
        let ends = EndOffset { x_m, z_m };
        let one = line(ends, &whole, bed).solve().unwrap();
        let many = line(ends, &cut, bed).solve().unwrap();
        let top = one.tension_b_n().max(one.tension_a_n());
        for (a, b) in forces(&one).iter().zip(forces(&many)) {
            assert!((a - b).abs() < 1e-10 * top, "{x_m} {z_m}");
        }
        assert!((one.on_bed_m - many.on_bed_m).abs() < 1e-7, "{x_m} {z_m}");
        assert_eq!(one.shape, many.shape, "{x_m} {z_m}");
    }
}

#[test]
fn what_friction_or_a_slope_leaves_open_is_refused() {
    let chain = [
        SectionProperties::new(100.0, 1200.0, 5e8),
        SectionProperties::new(100.0, 600.0, 5e8),
    ];
    let refusal = |x_m, z_m, below_a_m, slope_rad, friction| {
        let bed = RigidBed {
            below_a_m,
            slope_rad,
            friction,
        };
        line(EndOffset { x_m, z_m }, &chain, bed)
            .solve()
            .unwrap_err()
    };
    assert_eq!(
        refusal(180.0, 0.0, 20.0, 0.0, 0.5),
        CatenaryError::FrictionUndetermined
    );
    assert_eq!(
        refusal(170.0, 10.0, 20.0, 0.05, 0.0),
        CatenaryError::SlopeBelowA
    );
    assert!(matches!(
        refusal(100.0, 50.0, 0.0, 0.1, 0.0),
        CatenaryError::SlackOnSlope { .. }
    ));
}

#[test]
fn a_line_clear_of_a_slope_hangs_free() {
    let chain = [
        SectionProperties::new(100.0, 1200.0, 5e8),
        SectionProperties::new(100.0, 600.0, 5e8),
    ];
    let ends = EndOffset {
        x_m: 150.0,
        z_m: 60.0,
    };
    let bed = RigidBed {
        below_a_m: 80.0,
        slope_rad: 0.2,
        friction: 0.4,
    };
    let over = line(ends, &chain, bed).solve().unwrap();
    let free = CatenaryLine {
        bed: None,
        ..line(ends, &chain, bed)
    };
    assert_eq!(forces(&over), forces(&free.solve().unwrap()));
    assert_eq!(over.shape, CatenaryShape::Hanging);
}

fn any_section() -> impl Strategy<Value = SectionProperties> {
    (
        0.5..3.0_f64,
        0.0..4.0_f64,
        7.0..11.0_f64,
        prop::bool::weighted(0.2),
        1.0..5.0_f64,
    )
        .prop_map(|(length, weight, ea, hung, body)| SectionProperties {
            clump_n: if hung { 10_f64.powf(body) } else { 0.0 },
            ..SectionProperties::new(10_f64.powf(length), 10_f64.powf(weight), 10_f64.powf(ea))
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn a_sunk_line_lies_ends_where_it_should_and_stays_above_the_bed(
        mut sections in prop::collection::vec(any_section(), 2..6),
        x in 0.1..1.0_f64, up in 0.0..0.5_f64, slope in prop_oneof![Just(0.0), -0.4..0.4_f64], friction in 0.05..2.0_f64,
    ) {
        sections.last_mut().unwrap().clump_n = 0.0;
        let length = total(&sections);
        let bed = RigidBed { below_a_m: 0.0, slope_rad: slope, friction };
        let x_m = x * length;
        let ends = EndOffset { x_m, z_m: x_m * slope.tan() + up * length };
        let rest = line(ends, &sections, bed).solve();
        if let Err(CatenaryError::SlackOnSlope { .. }) = rest {
            prop_assert!(friction < slope.tan().abs());
            return Ok(());
        }
        prop_assert!(rest.is_ok(), "{:?}", rest);
        let rest = rest.unwrap();
        let size = length.max(ends.z_m);
        let end = rest.at(length);
        let gap = (end.x_m - ends.x_m).hypot(end.z_m - ends.z_m);
        prop_assert!(gap < 1e-8 * size, "{gap:e}");
        for i in 0..=200 {
            let point = rest.at(length * f64::from(i) / 200.0);
            prop_assert!(point.z_m >= point.x_m * slope.tan() - 1e-8 * size, "{:?}", point);
        }
    }
}
