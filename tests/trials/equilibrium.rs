//! The search for an equilibrium: lines that a free point divides, and what is at rest but for rounding.

use seacable::case::kind::parse_stored;
use seacable::system::motion::start::start;
use seacable::system::quantities::{error, value};
use seacable::system::stability::Stability;
use seacable::system::{SolvedSystem, SystemFile};

fn solved(text: &str) -> SolvedSystem {
    parse_stored::<SystemFile>(text, "trial.toml").unwrap()
}

/// A free point without mass divides a line and changes nothing, so that each system has the tensions of the one with the whole line within
/// the errors that both state. The search of the divided ones did not come to rest.
#[test]
fn divided_lines_pull_as_the_whole_does() {
    for (whole, split, divided, second) in [
        (
            include_str!("files/divided_line_12_whole.toml"),
            include_str!("files/divided_line_12_split.toml"),
            "l1",
            "spl2",
        ),
        (
            include_str!("files/divided_line_55_whole.toml"),
            include_str!("files/divided_line_55_split.toml"),
            "l0",
            "spl2",
        ),
        (
            include_str!("files/divided_line_109_whole.toml"),
            include_str!("files/divided_line_109_split.toml"),
            "l0",
            "spl2",
        ),
        // A buoy in a current with two poses, of which it took the unstable one.
        (
            include_str!("files/divided_line_44_whole.toml"),
            include_str!("files/divided_line_44_split.toml"),
            "l0",
            "l0-2",
        ),
    ] {
        let (whole, split) = (solved(whole), solved(split));
        for line in &whole.network.lines {
            for end in ["a", "b"] {
                let name = format!("tension_n[{}|{end}]", line.name);
                let there = match end == "b" && line.name == divided {
                    true => format!("tension_n[{second}|b]"),
                    false => name.clone(),
                };
                let apart = (value(&whole, &name).unwrap() - value(&split, &there).unwrap()).abs();
                let stated = error(&whole, &name).unwrap() + error(&split, &there).unwrap();
                assert!(apart <= stated, "{name}: {apart} N, stated {stated} N");
            }
        }
    }
}

/// A buoy that a current makes unstable leaves its pose along the motion or against it: mirrored it comes to the mirrored pose.
#[test]
fn an_unstable_pose_is_left_alike_when_mirrored() {
    let here = solved(include_str!("files/unstable_in_current.toml"));
    let there = solved(include_str!("files/unstable_in_current_mirrored.toml"));
    for system in [&here, &there] {
        let unstable = matches!(system.stability, Stability::Unstable(_));
        assert!(!unstable, "{:?}", system.stability);
    }
    for end in ["a", "b"] {
        let name = format!("tension_n[l0|{end}]");
        let (one, other) = (value(&here, &name).unwrap(), value(&there, &name).unwrap());
        assert!(
            (one / other - 1.0).abs() < 1e-6,
            "{name}: {one} and {other} N"
        );
    }
}

/// A spar of 3,091 t between two strings of some 300 kN: what is left of the forces is the rounding of its weight, and what moves is 7e-15 m.
#[test]
fn what_is_at_rest_to_rounding_is_at_rest() {
    let solved = solved(include_str!("files/at_rest_to_rounding.toml"));
    let begun = start(&solved, 1.0).unwrap();
    assert!(begun.iterations < 100, "{} iterations", begun.iterations);
}
