//! Audits: what MoorDyn misreads or leaves out is found, and a remedy is one that was tried.

use seacable::audit::finding::{AuditFinding, Topic};
use seacable::audit::{Audit, audit};
use seacable::export::{ExportOptions, Target, export};
use seacable::import::ImportOptions;

use crate::trial::{path, solved, text};

fn audited(name: &str) -> Audit {
    let all = audit(&text(name), &path(name), &ImportOptions::default());
    all.unwrap_or_else(|all| panic!("{all:#?}"))
}

fn about<'a>(audit: &'a Audit, subject: &str) -> Option<&'a AuditFinding> {
    audit.findings.iter().find(|one| one.subject == subject)
}

/// MoorDyn 2.7 looks for the rows about a height from the first on (`interp_factor`, source/Util/Interp.hpp), so that a profile from the surface down is
/// its first row everywhere.
#[test]
fn a_current_that_is_listed_from_the_surface_down_is_found() {
    let found = audited("moordyn_sea/line.txt");
    let finding = about(&found, "Currents").unwrap_or_else(|| panic!("{:#?}", found.findings));
    assert!(
        finding
            .what
            .contains("its first row, 1.5 m/s, everywhere at z = 0 m and below"),
        "{finding:#?}"
    );
    assert!(
        finding
            .what
            .contains("z = -100 m, where the file has 0.2 m/s"),
        "{finding:#?}"
    );
}

/// Waves by frequencies at the nodes have no dynamic pressure in MoorDyn 2.7 (`SpectrumKinWrapper`, source/Waves.hpp), which its rods feel on their ends.
#[test]
fn the_pressure_of_waves_that_moordyn_leaves_out_on_rods_is_found() {
    let found = audited("moordyn_sea/rod.txt");
    let finding = about(&found, "WaveKin").unwrap_or_else(|| panic!("{:#?}", found.findings));
    assert!(finding.what.contains("no dynamic pressure"), "{finding:#?}");
    assert!(
        finding.remedy.contains("WaveKin 3") && finding.remedy.contains("read back"),
        "{finding:#?}"
    );
    assert!(about(&audited("moordyn_sea/line.txt"), "WaveKin").is_none());
}

/// Too few segments are found with a remedy that was tried: what is left of the error is said.
#[test]
fn more_segments_are_proposed_where_they_help() {
    let coarse = text("moordyn_sea/line.txt")
        .replace("120 40", "101 2")
        .replace("1 Currents\n", "")
        .replace("60 0 -2", "10 0 -2");
    let found = audit(
        &coarse,
        &path("moordyn_sea/coarse.txt"),
        &ImportOptions::default(),
    )
    .unwrap();
    let meshes = found.findings.iter();
    let meshes: Vec<&AuditFinding> = meshes.filter(|one| one.topic == Topic::Mesh).collect();
    let [one] = meshes.as_slice() else {
        panic!("{:#?}", found.findings)
    };
    assert!(one.what.contains("2 segments give"), "{one:#?}");
    assert!(
        one.remedy.contains("4 or more segments") && one.remedy.contains("are left"),
        "{one:#?}"
    );
}

/// A file that is written for MoorDyn passes the audit with its step: RK4 in C++, and no finding of the RK2 that OpenFAST would take.
#[test]
fn the_step_of_an_exported_file_passes_the_audit() {
    for case in [
        include_str!("../../cases/systems/single_chain.toml"),
        include_str!("../../cases/systems/clump_in_line.toml"),
        include_str!("../../cases/systems/oc4_semi.toml"),
    ] {
        let exported = export(&solved(case), Target::MoorDyn, ExportOptions::default()).unwrap();
        let found = audit(
            &exported.text,
            &path("exported.txt"),
            &ImportOptions::default(),
        )
        .unwrap();
        let steps = found.findings.iter();
        let steps: Vec<&AuditFinding> = steps
            .filter(|one| one.topic == Topic::Step || one.remedy.contains("dtM"))
            .collect();
        assert!(steps.is_empty(), "{steps:#?}");
        // What OpenFAST does with the same step is judged all the same.
        let by_rk2 = found.step.unwrap().by_rk2.unwrap();
        assert!(by_rk2.holds() || by_rk2.stable.is_some(), "{by_rk2:?}");
    }
}
