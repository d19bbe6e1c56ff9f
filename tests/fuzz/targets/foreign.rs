//! Files of other programs, the tables beside them, and what the audit says of them.

use std::path::Path;

use seacable::audit;
use seacable::case::kind;
use seacable::import::{self, ImportOptions, yaml::library};
use seacable::system::SystemFile;

use super::Target;
use super::cases::shown;
use super::place::{contained, file, path, put};

const MOORDYN: &str = include_str!("../../data/corpus/moordyn/oc3_2.txt");
const MOORDYN_1: &str = include_str!("../../data/corpus/moordyn/oc3_1.txt");
const PARTS: &str = include_str!("../../data/corpus/moordyn/parts.txt");
/// Words that are odd but clear, and the tables of other dialects.
const ODD: [&str; 4] = [
    include_str!("../../trials/files/importers/coupled1.txt"),
    include_str!("../../trials/files/importers/v1_numnodes.txt"),
    include_str!("../../trials/files/importers/external_loads.txt"),
    include_str!("../../trials/files/importers/rigid6_buoy.dat"),
];
const MAP: &str = include_str!("../../data/corpus/map_plus_plus/oc3.txt");

pub(super) const ALL: &[Target] = &[
    Target {
        name: "moordyn",
        run: |data| imported(data, "file.dat", &ImportOptions::default()),
        seeds: || texts(&[&[MOORDYN, MOORDYN_1, PARTS], &ODD[..]].concat()),
        share: 20,
    },
    Target {
        name: "map_plus_plus",
        run: |data| imported(data, "file.map", &of_map_plus_plus()),
        seeds: || {
            texts(&[
                MAP,
                MOORDYN_1,
                include_str!("../../trials/files/importers/map_five_columns.map"),
                include_str!("../../trials/files/importers/omit_contact.map"),
            ])
        },
        share: 50,
    },
    Target {
        name: "design_yaml",
        run: |data| imported(data, "design.yaml", &ImportOptions::default()),
        seeds: || {
            texts(&[
                include_str!("../../system/foreign/famodel.yaml"),
                include_str!("../../system/foreign/ontology.yaml"),
                include_str!("../../system/foreign/raft.yaml"),
            ])
        },
        share: 10,
    },
    Target {
        name: "line_types",
        run: line_types,
        seeds: || {
            texts(&[
                include_str!("../../system/foreign/library.yaml"),
                include_str!("../../trials/files/importers/library_eadlm.yaml"),
            ])
        },
        share: 100,
    },
    Target {
        name: "water_kinematics",
        run: water_kinematics,
        seeds: || texts(&[include_str!("../../trials/files/importers/WaterKin.dat")]),
        share: 20,
    },
    Target {
        name: "import_motion",
        run: motion,
        seeds: || {
            texts(&[
                "Time Surge Sway Heave Roll Pitch Yaw\n0 0 0 0 0 0 0\n1 0.1 0 0.2 0 1 0\n2 0.3 0 0.1 0 0 0\n",
            ])
        },
        share: 5,
    },
    Target {
        name: "audit",
        run: audited,
        seeds: || texts(&[PARTS, MOORDYN_1]),
        share: 3,
    },
];

fn texts(all: &[&str]) -> Vec<Vec<u8>> {
    all.iter().map(|text| text.as_bytes().to_vec()).collect()
}

/// What the program that calls MAP++ says.
fn of_map_plus_plus() -> ImportOptions {
    ImportOptions {
        depth: Some(320.0),
        density: Some(1025.0),
        gravity: Some(9.80665),
        ..ImportOptions::default()
    }
}

/// The file as a case, and the case computed.
fn imported(data: &[u8], name: &str, options: &ImportOptions) -> bool {
    let text = contained(data);
    let name = file(name);
    let _ = import::is_foreign_file(Path::new(&name), &text);
    let case = match import::read(&text, &name, options) {
        Ok(case) => case,
        Err(faults) => return shown(&faults),
    };
    let Err(faults) = kind::parse::<SystemFile>(&case.text, &name) else {
        return true;
    };
    for fault in faults.iter().take(4) {
        assert!(case.at_its_row(fault, &name, &text).line >= 1);
    }
    shown(&faults)
}

fn line_types(data: &[u8]) -> bool {
    let text = contained(data);
    let library = match library::read(&text, &file("library.yaml")) {
        Ok(library) => library,
        Err(faults) => return shown(&faults),
    };
    for of in &library.types {
        drop(library.properties(of, 0.1));
        assert!(!of.ea_formula().is_empty());
    }
    true
}

/// A file of water kinematics beside a file of MoorDyn.
fn water_kinematics(data: &[u8]) -> bool {
    put(&path("WaterKin.dat"), contained(data).as_bytes());
    let read = import::read(ODD[3], &file("file.dat"), &ImportOptions::default());
    read.map_or_else(|faults| shown(&faults), |_| true)
}

/// A table of the motion of coupled parts, beside a file of MoorDyn.
fn motion(data: &[u8]) -> bool {
    let table = path("motion.txt");
    put(&table, contained(data).as_bytes());
    let options = ImportOptions {
        motion: Some(table),
        ..ImportOptions::default()
    };
    let read = import::read(MOORDYN, &file("file.dat"), &options);
    read.map_or_else(|faults| shown(&faults), |_| true)
}

fn audited(data: &[u8]) -> bool {
    let text = contained(data);
    let audit = audit::audit(&text, &file("file.dat"), &ImportOptions::default());
    audit.map_or_else(|faults| shown(&faults), |_| true)
}
