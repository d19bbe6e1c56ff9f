//! Tables of stiffness: straight between their rows where the file is MoorDyn's, smooth in own files.

use seacable::audit::audit;
use seacable::audit::finding::Topic;
use seacable::export::{ExportOptions, Target, export};
use seacable::import::ImportOptions;
use seacable::number::si;
use seacable::system::warnings::warnings;

use crate::trial::{channel, imported, moved, path, solved, tension_at_b, text};

const HAWSER: &str = "h01_stiffness_table.txt";

/// A nylon hawser held between two ends at a strain of 0.12, with rows of 600 kN at 0.10 and 1400 kN at 0.15: MoorDyn 2.7.2 has
/// 920,001 N (public report MoorDyn#183; its `Line::getNonlinearEA` is linear). The tolerance is the weight of the hawser.
#[test]
fn a_table_of_moordyn_is_straight_between_its_rows() {
    let text = imported(HAWSER);
    let system = solved(&text);
    let tension = tension_at_b(&system, "line1");
    assert!((tension - 920e3).abs() < 3.0, "{}", si(tension, "N"));
    assert!(
        warnings(&system)
            .iter()
            .all(|one| !one.contains("last row"))
    );
    // Reversed and divided more finely it is the same.
    let turned = text.replace("from = \"p1\"\nto = \"p2\"", "from = \"p2\"\nto = \"p1\"");
    let fine = text.replace("segments = 20", "segments = 80");
    for other in [&turned, &fine] {
        assert_ne!(*other, text);
        let tension = solved(other).rest.balance.tension;
        assert!((tension - 920e3).abs() < 3.0, "{}", si(tension, "N"));
    }
    // An own file that does not ask for it has a curve without kinks: 856,001 N by hand (monotone cubic).
    let own = text.replace("tension_interpolation = \"linear\"", "");
    assert_ne!(own, text);
    let tension = tension_at_b(&solved(&own), "line1");
    assert!((tension - 856e3).abs() < 3.0, "{}", si(tension, "N"));
}

/// The audit holds MoorDyn's division against the same table: no finding, and so no remedy that changes nothing.
#[test]
fn an_audit_finds_nothing_in_the_segments_of_a_line_by_a_table() {
    let audit = audit(&text(HAWSER), &path(HAWSER), &ImportOptions::default()).unwrap();
    let meshes = audit.findings.iter().filter(|one| one.topic == Topic::Mesh);
    assert_eq!(meshes.count(), 0, "{:#?}", audit.findings);
}

/// A run begins where the line rests: it is linear in motion as at rest.
#[test]
fn a_table_of_moordyn_is_straight_in_motion() {
    let moving = format!(
        "{}\n[solver]\nduration_s = 0.5\ntime_step_s = 0.05\n",
        imported(HAWSER)
    );
    let run = moved(&solved(&moving));
    for value in channel(&run, "tension_n[line1|b]") {
        assert!((value - 920e3).abs() < 5.0, "{value}");
    }
}

/// Written for MoorDyn, a smooth table has so many rows that straight lines between them differ little, and a remark says by how much;
/// a straight one keeps its rows.
#[test]
fn a_smooth_table_is_written_with_the_rows_that_moordyn_reads() {
    let straight = imported(HAWSER);
    let smooth = straight.replace("tension_interpolation = \"linear\"", "");
    let of = |text: &str| {
        let exported = export(&solved(text), Target::MoorDyn, ExportOptions::default()).unwrap();
        let (_, table) = exported.files.into_iter().next().unwrap();
        let remarks = exported.remarks.join("\n");
        (table.lines().count() - 2, remarks)
    };
    let (rows, remarks) = of(&straight);
    assert_eq!(rows, 5);
    assert!(!remarks.contains("smooth"), "{remarks}");
    let (rows, remarks) = of(&smooth);
    assert_eq!(rows, 29);
    assert!(remarks.contains("its table is smooth"), "{remarks}");
}

/// Beyond the last row the table goes on straight, and a note says so: MoorDyn in C++ holds the last tension there.
#[test]
fn a_line_beyond_its_table_is_named() {
    let text = imported(HAWSER).replace("[56.0, 0.0, -5.0]", "[61.0, 0.0, -5.0]");
    let system = solved(&text);
    let tension = tension_at_b(&system, "line1");
    // 0.22 of strain: 3 MN and 0.02 of the last slope, 32 MN.
    assert!((tension - 3.64e6).abs() < 10.0, "{}", si(tension, "N"));
    let all = warnings(&system).join("\n");
    assert!(all.contains("more than the last row"), "{all}");
}
