//! Lines without a closed form in a system: in a current, and with bending stiffness.

use seacable::case::kind;
use seacable::system::SystemFile;

use crate::{HEAD, place, solved, tensions};

/// Two lines that meet at a point, with the keys of their material and the rest of the file.
fn two_lines(material: &str, rest: &str) -> String {
    format!(
        "{HEAD}[seabed]\ndepth_m = 200.0\n[materials.chain]\ndiameter_m = 0.1\nmass_kg_per_m = 60.0\nea_n = 4e8\n{material}
[points.a]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -150.0]
[points.b]\nkind = \"fixed\"\nposition_m = [260.0, 0.0, -20.0]
[points.middle]\nkind = \"free\"\nmass_kg = 500.0
[[lines]]\nname = \"low\"\nfrom = \"a\"\nto = \"middle\"\nmaterial = \"chain\"\nlength_m = 180.0\nsegments = 160
[[lines]]\nname = \"high\"\nfrom = \"middle\"\nto = \"b\"\nmaterial = \"chain\"\nlength_m = 130.0\nsegments = 120\n{rest}"
    )
}

/// With next to no current the discretised lines are the closed forms, to their mesh error.
#[test]
fn without_current_they_are_the_closed_forms() {
    let exact = solved(&two_lines("", ""));
    let still = solved(&two_lines("", "[current]\nspeed_m_per_s = 0.0\n"));
    assert!(still.is_discretised() && !exact.is_discretised());
    for (index, line) in ["low", "high"].into_iter().enumerate() {
        let (e, s) = (tensions(&exact, line), tensions(&still, line));
        let allowed = still.errors.lines[index].unwrap();
        assert!(allowed < 1e-3 * e[1], "{allowed}");
        for end in 0..2 {
            assert!(
                (e[end] - s[end]).abs() < 2.0 * allowed,
                "{line}: {e:?} {s:?} {allowed}"
            );
        }
    }
}

/// A current across moves the junction with it; its forces and those at the ends are in balance.
#[test]
fn a_current_across_moves_the_junction() {
    let drag = "drag_normal = 1.2\n";
    let flowing = |speed: f64, towards: f64| {
        solved(&two_lines(
            drag,
            &format!("[current]\nspeed_m_per_s = {speed}\ndirection_deg = {towards}\n"),
        ))
    };
    let (weak, strong) = (flowing(0.5, 90.0), flowing(1.5, 90.0));
    let (near, far) = (place(&weak, "middle")[1], place(&strong, "middle")[1]);
    assert!(near > 0.1 && far > 5.0 * near, "{near} {far}");
    let mirrored = place(&flowing(1.5, -90.0), "middle")[1];
    assert!((far + mirrored).abs() < 1e-6 * far);
    for system in [&weak, &strong] {
        assert!(system.rest.residual < 1e-6 * system.rest.balance.tension);
    }
}

/// A little bending stiffness changes the tensions little, and the search ends.
#[test]
fn bending_stiffness_takes_part() {
    let exact = solved(&two_lines("", ""));
    let stiff = solved(&two_lines("ei_n_m2 = 1e4\n", ""));
    assert!(stiff.is_discretised());
    let (e, s) = (tensions(&exact, "high")[1], tensions(&stiff, "high")[1]);
    assert!((e - s).abs() < 0.02 * e, "{e} {s}");
}

/// Sections that state their segments are divided into these, in their ratio where the line states its own.
#[test]
fn sections_state_their_segments() {
    let text = |of_line: &str, [a, b]: [&str; 2]| {
        format!(
            "{HEAD}[current]\nspeed_m_per_s = 0.5\n[materials.chain]\ndiameter_m = 0.1\nmass_kg_per_m = 60.0\nea_n = 4e8
[points.a]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -150.0]
[points.b]\nkind = \"fixed\"\nposition_m = [200.0, 0.0, -20.0]
[[lines]]\nname = \"line\"\nfrom = \"a\"\nto = \"b\"\n{of_line}
[[lines.sections]]\nmaterial = \"chain\"\nlength_m = 100.0\n{a}
[[lines.sections]]\nmaterial = \"chain\"\nlength_m = 160.0\n{b}"
        )
    };
    let segments = |of_line, sections| -> Vec<usize> {
        let system = solved(&text(of_line, sections));
        let line = system.network.lines[0].discretised.clone().unwrap();
        let sections = line.case().line.iter();
        sections.map(|section| section.segments).collect()
    };
    let asked = ["segments = 3\n", "segments = 5\n"];
    assert_eq!(segments("", asked), [3, 5]);
    assert_eq!(segments("segments = 16\n", asked), [6, 10]);
    assert_eq!(segments("segments = 26\n", ["", ""]), [10, 16]);
    let some = text("", ["segments = 3\n", ""]);
    let refused = kind::parse::<SystemFile>(&some, "x.toml").unwrap_err();
    assert_eq!(refused[0].key, "lines.line.sections.1.segments");
}
