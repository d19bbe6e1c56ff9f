//! Friction across lines: what it does not act on, and files of other programs that have it.

use seacable::case::kind;
use seacable::import::{self, ImportOptions};
use seacable::system::loads_without_effect::loads_without_effect;
use seacable::system::{SolvedSystem, SystemFile};

use crate::{HEAD, solved, tensions};

/// A chain half on the bed.
fn chain(bed: &str, more: &str) -> SolvedSystem {
    solved(&format!(
        "{HEAD}[seabed]\ndepth_m = 50.0\n{bed}{more}\
         [materials.chain]\nmass_kg_per_m = 180.0\ndiameter_m = 0.1\nea_n = 8e8\ndrag_normal = 1.2\n\
         [points.anchor]\nkind = \"fixed\"\nposition_m = [180.0, 0.0, -50.0]\n\
         [points.top]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]\n\
         [[lines]]\nname = \"line\"\nfrom = \"anchor\"\nto = \"top\"\nmaterial = \"chain\"\nlength_m = 202.0\nsegments = 60\n"
    ))
}

const ACROSS: &str = "At rest the friction of the bed across lines does not act on line line";

#[test]
fn across_a_closed_form_it_acts_on_nothing_and_says_so() {
    let along = chain("friction = 0.3\n", "");
    let both = chain("friction = 0.3\nfriction_lateral = 0.8\n", "");
    assert_eq!(tensions(&along, "line"), tensions(&both, "line"));
    let said = |system: &SolvedSystem| {
        let remarks = loads_without_effect(system);
        remarks
            .iter()
            .filter(|text| text.starts_with(ACROSS))
            .count()
    };
    assert_eq!((said(&along), said(&both)), (0, 1));
    // A current across the line moves it until friction holds it.
    let current = "[current]\nspeed_m_per_s = 1.5\ndirection_deg = 90.0\n";
    let with = |across: f64| {
        let bed = format!("friction = 0.3\nfriction_lateral = {across:?}\n");
        chain(&bed, current)
    };
    let found = [with(0.3), with(0.05)];
    assert_eq!(found.each_ref().map(said), [0, 0]);
    let aside = found.each_ref().map(|system| {
        let line = system.rest.balance.lines[0].discretised.as_ref().unwrap();
        line.found.position_m.iter().map(|x| x.y).sum::<f64>()
    });
    assert!(aside[1] > aside[0] + 1.0, "{aside:?}");
}

#[test]
fn friction_by_velocity_holds_nothing_at_rest_and_says_so() {
    let smooth = chain("", "");
    let zhu = chain("friction = 0.4\nfriction_law = \"zhu-2017\"\n", "");
    assert_eq!(tensions(&smooth, "line"), tensions(&zhu, "line"));
    let said = "At rest the friction of the bed does not act on line line: by `zhu-2017`";
    let remarks = loads_without_effect(&zhu);
    assert!(
        remarks.iter().any(|text| text.starts_with(said)),
        "{remarks:?}"
    );
    let current = "[current]\nspeed_m_per_s = 1.5\ndirection_deg = 90.0\n";
    let [smooth, zhu] = [
        chain("", current),
        chain("friction = 0.4\nfriction_law = \"zhu-2017\"\n", current),
    ];
    assert_eq!(tensions(&smooth, "line"), tensions(&zhu, "line"));
}

#[test]
fn friction_across_alone_is_friction() {
    let current = "[current]\nspeed_m_per_s = 1.5\ndirection_deg = 90.0\n";
    let anchored = |keys: &str| tensions(&chain(keys, current), "line")[0];
    let smooth = anchored("");
    let across = anchored("friction = 0.0\nfriction_lateral = 0.8\n");
    let both = anchored("friction = 0.8\n");
    // Along the line tension is as without friction, but for the way that the line lies.
    assert!(
        across > 0.8 * smooth && both < 0.5 * smooth,
        "{smooth} {across} {both}"
    );
}

fn imported(text: &str) -> SystemFile {
    let options = ImportOptions::default();
    let case = import::read(text, "mooring.dat", &options).unwrap_or_else(|all| panic!("{all:#?}"));
    kind::parse::<SystemFile>(&case.text, "case.toml")
        .unwrap_or_else(|all| panic!("{}\n{all:#?}", case.text))
        .file
}

const MOORDYN: &str = "\
--- LINE TYPES ---
Name Diam MassDen EA BA/-zeta EI Cd Ca CdAx CaAx
(-) (m) (kg/m) (N) (-) (-) (-) (-) (-) (-)
chain 0.1 180 8e8 -0.8 0 1.2 1.0 0.1 0.0
--- POINTS ---
ID Type X Y Z M V CdA CA
(#) (-) (m) (m) (m) (kg) (m3) (m2) (-)
1 Fixed 180 0 -50 0 0 0 0
2 Coupled 0 0 0 0 0 0 0
--- LINES ---
ID LineType AttachA AttachB UnstrLen NumSegs Outputs
(#) (-) (-) (-) (m) (-) (-)
1 chain 1 2 202 60 -
--- OPTIONS ---
50 WtrDpth
";

/// MoorDyn of OpenFAST has mu_kA along lines and mu_kT across them, both 0 unless given (MoorDyn.f90, MoorDyn_Line.f90).
#[test]
fn moordyn_of_openfast_has_two_coefficients() {
    for (options, along, across) in [
        ("0.3 FrictionCoefficient\n", 0.3, None),
        ("0.8 mu_kT\n0.3 mu_kA\n", 0.3, Some(0.8)),
        ("0.3 mu_kA\n", 0.3, Some(0.0)),
    ] {
        let bed = imported(&format!("{MOORDYN}{options}")).seabed.unwrap();
        assert_eq!(
            (bed.friction, bed.friction_lateral),
            (Some(along), across),
            "{options}"
        );
    }
}

#[test]
fn a_deck_of_cable_dyn_has_friction_across() {
    let text = std::fs::read_to_string("tests/trials/files/importers/lazy_modes.dat").unwrap();
    for (value, across) in [("0.8", Some(0.8)), ("none", None)] {
        let options = format!("1e5 kBot\n0.3 FrictionMuAxial\n{value} FrictionMuLateral\n");
        let bed = imported(&text.replace("1e5 kBot\n", &options))
            .seabed
            .unwrap();
        assert_eq!((bed.friction, bed.friction_lateral), (Some(0.3), across));
    }
}
