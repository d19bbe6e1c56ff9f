//! Inputs found by coverage, for the target that `SEACABLE_FUZZ_TARGET` names, a list of them where none is named: the functions that `cargo test --test fuzz` calls too.

#![no_main]

use std::sync::OnceLock;
use std::{env, fs, path::Path};

use libfuzzer_sys::fuzz_target;

#[path = "../../tests/fuzz/targets/mod.rs"]
#[expect(dead_code, reason = "shares are for the tests")]
mod targets;

fn target() -> &'static targets::Target {
    static TARGET: OnceLock<&targets::Target> = OnceLock::new();
    TARGET.get_or_init(|| {
        let named = env::var("SEACABLE_FUZZ_TARGET").unwrap_or_default();
        let found = targets::all().find(|target| target.name == named);
        found.unwrap_or_else(|| panic!("there is no target {named}"))
    })
}

/// Lists the targets where none is named.
fn list_if_asked() {
    if env::var_os("SEACABLE_FUZZ_TARGET").is_none() {
        targets::all().for_each(|target| println!("{}", target.name));
        std::process::exit(0);
    }
}

/// Writes what is shipped for the target to the folder that `SEACABLE_FUZZ_SEEDS` names, where the search begins.
fn write_seeds() {
    let Some(folder) = env::var_os("SEACABLE_FUZZ_SEEDS") else {
        return;
    };
    for (number, seed) in (target().seeds)().iter().enumerate() {
        fs::write(Path::new(&folder).join(format!("seed-{number}")), seed).unwrap();
    }
}

fuzz_target!(
    init: {
        list_if_asked();
        targets::enter();
        write_seeds();
    },
    |data: &[u8]| {
        target().read(data);
    }
);
