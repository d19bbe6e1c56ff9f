//! What is wrong with a design in YAML, row by row, and texts that are none.

use proptest::prelude::*;
use seacable::import::yaml::library;

use super::foreign_yaml::{FAMODEL, LIBRARY, ONTOLOGY, RAFT, case_of, read};

/// Faults: the design, what is replaced, by what, the row it is reported on, the end of its key, a word of the problem.
const FAULTS: [(&str, &str, &str, u32, &str, &str); 24] = [
    (
        RAFT,
        "          length: 850\n",
        "",
        38,
        "lines.line1.length",
        "there is no `length`",
    ),
    (
        RAFT,
        "          length: 850\n",
        "          length:\n",
        42,
        "line1.length",
        "no value",
    ),
    (
        RAFT,
        "length: 850\n",
        "length: 0\n",
        42,
        "line1.length",
        "not above 0",
    ),
    (
        RAFT,
        "length: 850\n",
        "length: -850\n",
        42,
        "line1.length",
        "not above 0",
    ),
    (
        RAFT,
        "length: 850\n",
        "length: 0850\n",
        42,
        "line1.length",
        "octal",
    ),
    (
        RAFT,
        "length: 850\n",
        "length: .nan\n",
        42,
        "line1.length",
        "not a number",
    ),
    (
        RAFT,
        "stiffness:      3270e6",
        "stiffness:      3270x6",
        57,
        "chain.stiffness",
        "not a number",
    ),
    (
        RAFT,
        "stiffness:      3270e6",
        "stiffness:      .inf",
        57,
        "chain.stiffness",
        "not a number",
    ),
    (
        RAFT,
        "diameter:       0.333",
        "diameter: 0",
        55,
        "chain.diameter",
        "not above 0",
    ),
    (
        RAFT,
        "endA: anchor1",
        "endA: anker1",
        39,
        "line1.endA",
        "no point `anker1`",
    ),
    (
        RAFT,
        "endB: fairlead1",
        "endB: anchor1",
        40,
        "line1.endB",
        "same point",
    ),
    (
        RAFT,
        "          type: chain",
        "          type: chane",
        41,
        "line1.type",
        "no line type `chane`",
    ),
    (
        RAFT,
        "type: Anchor",
        "type: pile",
        21,
        "anchor2.type",
        "not a type of point",
    ),
    (
        RAFT,
        "[418.8, 725.383, -200.0]",
        "[418.8, 725.383]",
        22,
        "anchor2.location",
        "2 numbers where 3",
    ),
    (
        RAFT,
        "[418.8, 725.383, -200.0]",
        "[418.8, north, -200.0]",
        22,
        "anchor2.location",
        "not a number",
    ),
    (
        RAFT,
        "[418.8, 725.383, -200.0]",
        "418.8",
        22,
        "anchor2.location",
        "list of x, y, z",
    ),
    (
        RAFT,
        "- name: anchor2",
        "- name: anchor1",
        20,
        "points.anchor1.name",
        "second point `anchor1`",
    ),
    (
        RAFT,
        "          cost: 100.0",
        "          diameter: 0.3",
        59,
        "diameter",
        "second `diameter`",
    ),
    (
        RAFT,
        "    lines:\n",
        "    limes:\n",
        12,
        "mooring.lines",
        "there is no `lines`",
    ),
    (
        RAFT,
        "    anchor_types:\n",
        "    repeat: 3\n    anchor_types:\n",
        65,
        "mooring.repeat",
        "neither by RAFT nor here",
    ),
    (
        RAFT,
        "          length: 850\n",
        "\t  length: 850\n",
        42,
        "",
        "indented by a tab",
    ),
    (
        ONTOLOGY,
        "joint: anchor2",
        "joint: anchor9",
        42,
        "nodes.anchor2.joint",
        "no joint `anchor9`",
    ),
    (
        ONTOLOGY,
        "node2: vessel2",
        "node2: vessel9",
        59,
        "line2.node2",
        "no node `vessel9`",
    ),
    (
        ONTOLOGY,
        "               stiffness: 3.27e9\n",
        "",
        68,
        "main.stiffness",
        "there is no `stiffness`",
    ),
];

#[test]
fn every_fault_is_at_its_row_and_key() {
    for (design, of, by, line, key, problem) in FAULTS {
        assert!(design.contains(of), "{of}");
        let text = design.replacen(of, by, 1);
        let all = read(&text).expect_err(by);
        let found = all.iter().find(|fault| fault.problem.contains(problem));
        let Some(found) = found else {
            panic!("{by}: {all:#?}");
        };
        assert_eq!(found.line, line, "{by}: {found:#?}");
        assert!(found.key.ends_with(key), "{by}: {found:#?}");
        assert!(!found.remedy.is_empty(), "{by}");
    }
}

#[test]
fn faults_are_found_all_at_once_and_do_not_cause_others() {
    let text = RAFT
        .replacen("[418.8, 725.383, -200.0]", "[418.8]", 1)
        .replacen("length: 850\n", "length: none\n", 1)
        .replacen("stiffness:      3270e6", "stiffness: soft", 1)
        .replacen("endB: fairlead3", "endB: fairlead4", 1);
    let all = read(&text).unwrap_err();
    let keys: Vec<&str> = all.iter().map(|fault| fault.key.as_str()).collect();
    let wanted = [
        "mooring.points.anchor2.location",
        "mooring.lines.line1.length",
        "mooring.lines[3].endB",
        "mooring.line_types.chain.stiffness",
    ];
    assert_eq!(keys, wanted, "{all:#?}");
    assert!(
        all[2]
            .remedy
            .contains("anchor1, anchor2, anchor3, fairlead1")
    );
}

#[test]
fn what_is_no_design_says_what_was_looked_for() {
    for text in [
        "a: 1\n",
        "{\"a\": [1, 2]}",
        "- 1\n",
        "word",
        "",
        "# nothing\n",
    ] {
        let all = read(text).unwrap_err();
        assert_eq!(all.len(), 1, "{all:#?}");
        let said = format!("{} {}", all[0].problem, all[0].remedy);
        assert!(said.contains("mooring"), "{said}");
    }
    let all = read(LIBRARY).unwrap_err();
    assert_eq!((all[0].line, all[0].key.as_str()), (2, "lineProps"));
    assert!(all[0].remedy.contains("seacable lines --library"));
}

#[test]
fn texts_that_grow_without_end_are_refused() {
    let mut bomb = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1]\n".to_owned();
    for level in 1..30 {
        let below = format!("*a{}, ", level - 1).repeat(9);
        bomb += &format!("a{level}: &a{level} [{below}]\n");
    }
    bomb += "mooring: {points: *a29, lines: *a29, line_types: *a29}\n";
    assert!(read(&bomb).is_err());
    let deep = format!("mooring: {}", "[".repeat(100_000));
    assert!(
        read(&deep).unwrap_err()[0]
            .problem
            .contains("recursion limit")
    );
    let block = "- ".repeat(100_000);
    assert!(read(&block).unwrap_err()[0].problem.contains("levels deep"));
    assert!(
        read("mooring: &a {lines: *a}\n").unwrap_err()[0]
            .problem
            .contains("itself")
    );
    let merged = RAFT.replacen("        - name: line2\n          endA: anchor2\n          endB: fairlead2\n          type: chain\n          length: 850.0\n",
        "        - {<<: *first, name: line2, endA: anchor2, endB: fairlead2}\n", 1)
        .replacen("- name: line1\n", "- &first\n          name: line1\n", 1);
    assert_eq!(case_of(&merged).matches("length_m = 850.0").count(), 3);
}

#[test]
fn faults_of_a_library_are_at_their_rows() {
    let faults = [
        (
            "mass_d2   :  19.9e3",
            "mass      :  19.9e3",
            3,
            "lineProps.chain.mass_d2",
        ),
        (
            "mass_d2   :  19.9e3",
            "mass_d2   :  heavy",
            4,
            "lineProps.chain.mass_d2",
        ),
        (
            "EA_d2     :  85.6e9",
            "EA_D2     :  85.6e9",
            5,
            "lineProps.chain.EA_D2",
        ),
        (
            "density    : 1400",
            "dvol_dnom: 0.8\n    density    : 1400",
            25,
            "lineProps.rope.density",
        ),
        (
            "dvol_dnom :  1.80",
            "dvol_dnom :  0",
            11,
            "lineProps.chain.dvol_dnom",
        ),
        ("    EA_MBL     : 15\n", "", 17, "lineProps.rope.EA_d2"),
    ];
    for (of, by, line, key) in faults {
        assert!(LIBRARY.contains(of), "{of}");
        let read = library::read(&LIBRARY.replacen(of, by, 1), "library.yaml").expect(by);
        let mut all = read.not_read.iter().flat_map(|of| &of.faults);
        let found = all.find(|fault| fault.key == key);
        assert_eq!(found.map(|fault| fault.line), Some(line), "{by}: {read:#?}");
        // The other type is read.
        assert_eq!((read.types.len(), read.not_read.len()), (1, 1), "{by}");
    }
    for text in [
        "",
        "lineProps:\n",
        "lineProps: {}\n",
        "a: 1\n",
        "[1]\n",
        "lineProps: {chain: 3}\n",
    ] {
        assert!(library::read(text, "library.yaml").is_err(), "{text}");
    }
}

/// A design with a part cut out or bytes replaced.
fn mutated() -> impl Strategy<Value = String> {
    let texts = prop_oneof![Just(RAFT), Just(ONTOLOGY), Just(LIBRARY), Just(FAMODEL)];
    let bytes = prop::collection::vec((0.0..1.0_f64, any::<u8>()), 0..6);
    let pieces = prop::sample::select(vec![
        "", "*a", "&a ", "- ", ": ", "[", "{", "\"", "!!x ", "<<: ", "\t", "\n", "%", "|", "\u{e9}",
    ]);
    (
        texts,
        bytes,
        0.0..1.0_f64,
        0.0..1.0_f64,
        pieces,
        any::<bool>(),
    )
        .prop_map(|(text, bytes, from, to, piece, cut)| {
            let mut mutated = text.as_bytes().to_vec();
            for (share, byte) in bytes {
                let at = place(share, mutated.len());
                if let Some(old) = mutated.get_mut(at) {
                    *old = byte;
                }
            }
            let [from, to] = [from, to].map(|share| place(share, mutated.len()));
            if cut {
                mutated.splice(from.min(to)..from.max(to), piece.bytes());
            } else {
                mutated.truncate(from);
                mutated.extend(piece.bytes());
            }
            String::from_utf8_lossy(&mutated).into_owned()
        })
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "a place in a short text"
)]
fn place(share: f64, length: usize) -> usize {
    (share * length as f64) as usize
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn mutated_designs_are_read_or_refused(text in mutated()) {
        let library = library::read(&text, "library.yaml");
        prop_assert!(library.is_ok() || library.is_err_and(|all| !all.is_empty()));
        if let Err(faults) = read(&text) {
            prop_assert!(!faults.is_empty());
            for fault in &faults {
                prop_assert!(fault.line >= 1 && fault.column >= 1);
                prop_assert!(text.get(fault.span.clone()).is_some(), "{:?}", fault);
                prop_assert!(!fault.problem.is_empty() && !fault.remedy.is_empty());
                prop_assert!(!fault.to_string().contains('\n'), "{}", fault);
                prop_assert!(!fault.render(false).is_empty());
            }
        }
    }
}

#[test]
fn a_broken_syntax_is_said_in_the_words_of_its_format() {
    let json = "{\n \"mooring\": {\"water_depth\": 200 \"g\": 9.81}\n}\n";
    let all = read(json).unwrap_err();
    let one = &all[0];
    assert!(one.problem.starts_with("this is not JSON"), "{one:?}");
    assert!(one.problem.contains("`,` or `}`"), "{one:?}");
    assert_eq!((one.line, one.remedy.contains("indentation")), (2, false));
    let all = read("mooring:\n  lines:\n  a b\n  c: 1\n").unwrap_err();
    let one = &all[0];
    assert!(one.problem.starts_with("this is not YAML"), "{one:?}");
    assert!(!one.problem.contains('\\'), "{one:?}");
}
