//! The cases that come with the program, so that it needs nothing but itself.

use crate::kinds::FileType;

/// Path below `cases` and text.
pub type Shipped = (&'static str, &'static str);

macro_rules! shipped {
    ($path:literal) => {
        ($path, include_str!(concat!("../../../cases/", $path)))
    };
}

/// The cases that come with the program, in the order of their paths.
pub const SHIPPED: &[Shipped] = &[
    shipped!("basics/hanging_line.toml"),
    shipped!("basics/mooring_static.toml"),
    shipped!("basics/pendulum.toml"),
    shipped!("basics/steep_wave.toml"),
    shipped!("benchmarks/beam_cantilevered.toml"),
    shipped!("benchmarks/beam_simply_supported.toml"),
    shipped!("benchmarks/current_across.toml"),
    shipped!("benchmarks/current_along.toml"),
    shipped!("benchmarks/elastica.toml"),
    shipped!("benchmarks/jumper_across.toml"),
    shipped!("benchmarks/jumper_along.toml"),
    shipped!("benchmarks/jumper_heave.toml"),
    shipped!("benchmarks/lindahl_chain.toml"),
    shipped!("benchmarks/point_load.toml"),
    shipped!("double_stepped/cable.toml"),
    shipped!("double_stepped/cantilever.toml"),
    shipped!("double_stepped/extreme_wave.toml"),
    shipped!("double_stepped/regular_wave.toml"),
    shipped!("double_stepped/tank.toml"),
    shipped!("hard/afloat.toml"),
    shipped!("hard/body_on_bed.toml"),
    shipped!("hard/buckling.toml"),
    shipped!("hard/buoyant.toml"),
    shipped!("hard/clump_on_bed.toml"),
    shipped!("hard/coincident.toml"),
    shipped!("hard/contrast.toml"),
    shipped!("hard/crest.toml"),
    shipped!("hard/crisis.toml"),
    shipped!("hard/cut_off.toml"),
    shipped!("hard/falling.toml"),
    shipped!("hard/frames.toml"),
    shipped!("hard/free_fall.toml"),
    shipped!("hard/limit.toml"),
    shipped!("hard/manifold_on_bed.toml"),
    shipped!("hard/relaxed.toml"),
    shipped!("hard/release.toml"),
    shipped!("hard/resonance.toml"),
    shipped!("hard/reversal.toml"),
    shipped!("hard/rough.toml"),
    shipped!("hard/slack.toml"),
    shipped!("hard/snap.toml"),
    shipped!("hard/splash.toml"),
    shipped!("hard/stick_slip.toml"),
    shipped!("hard/stop.toml"),
    shipped!("hard/swing.toml"),
    shipped!("hard/taut.toml"),
    shipped!("hard/ten_km.toml"),
    shipped!("hard/tiny_ei.toml"),
    shipped!("hard/touchdown.toml"),
    shipped!("hard/vertical.toml"),
    shipped!("hard/whip.toml"),
    shipped!("mooring/heaved_200m.toml"),
    shipped!("mooring/heaved_50m.toml"),
    shipped!("mooring/heaved_600m.toml"),
    shipped!("mooring/hybrid_fixed.toml"),
    shipped!("mooring/hybrid_moving.toml"),
    shipped!("pendulous/manifold.toml"),
    shipped!("pendulous/module.toml"),
    shipped!("pendulous/module_rotating.toml"),
    shipped!("ropeway/crossing.toml"),
    shipped!("ship/anchor_line.toml"),
    shipped!("umbilical/catenary.toml"),
    shipped!("umbilical/fatigue.toml"),
    shipped!("umbilical/power_cable_80m.toml"),
    shipped!("umbilical/steep_wave.toml"),
];

/// The cross-sections that come with the program, in the order of their paths.
pub const SECTIONS: &[Shipped] = &[
    shipped!("umbilical/section.toml"),
    shipped!("umbilical/section_power_cable.toml"),
];

/// The ships that come with the program, in the order of their paths.
pub const SHIPS: &[Shipped] = &[
    shipped!("ship/anchored.toml"),
    shipped!("ship/coupled.toml"),
];

/// Tables that these files name, in the order of their paths.
pub const BESIDE: &[Shipped] = &[
    shipped!("ship/landing_craft.csv"),
    shipped!("systems/volturnus_data/semi.1"),
    shipped!("systems/volturnus_data/semi.12d"),
    shipped!("systems/volturnus_data/semi.3"),
];

/// The ropeways that come with the program, in the order of their paths.
pub const ROPEWAYS: &[Shipped] = &[
    shipped!("ropeway/constant_tension.toml"),
    shipped!("ropeway/hauling.toml"),
    shipped!("ropeway/made_fast.toml"),
    shipped!("ropeway/span_40.toml"),
    shipped!("ropeway/span_60.toml"),
    shipped!("ropeway/span_80.toml"),
];

/// The systems of lines that come with the program, in the order of their paths.
pub const SYSTEMS: &[Shipped] = &[
    shipped!("hard/falling_rod.toml"),
    shipped!("hard/heaving_buoy.toml"),
    shipped!("hard/landing.toml"),
    shipped!("hard/let_go.toml"),
    shipped!("hard/payout.toml"),
    shipped!("hard/rough_bed.toml"),
    shipped!("hard/slack_bridle.toml"),
    shipped!("hard/slope.toml"),
    shipped!("hard/snapping_junction.toml"),
    shipped!("hard/stays.toml"),
    shipped!("hard/tether.toml"),
    shipped!("hard/three_taut_ropes.toml"),
    shipped!("hard/top_heavy.toml"),
    shipped!("hard/triple_pendulum.toml"),
    shipped!("pendulous/vessel.toml"),
    shipped!("systems/aged_chains.toml"),
    shipped!("systems/bridle_and_buoy.toml"),
    shipped!("systems/bridle_in_heave.toml"),
    shipped!("systems/buoy_and_clump.toml"),
    shipped!("systems/buoy_and_riser.toml"),
    shipped!("systems/buoy_let_go.toml"),
    shipped!("systems/chain_and_rope.toml"),
    shipped!("systems/clump_in_line.toml"),
    shipped!("systems/crows_foot.toml"),
    shipped!("systems/lazy_wave.toml"),
    shipped!("systems/line_beside_body.toml"),
    shipped!("systems/line_breaks.toml"),
    shipped!("systems/line_on_body.toml"),
    shipped!("systems/lowering.toml"),
    shipped!("systems/moved_chain_200m.toml"),
    shipped!("systems/moved_chain_50m.toml"),
    shipped!("systems/moved_chain_600m.toml"),
    shipped!("systems/moved_spread.toml"),
    shipped!("systems/oc3_free.toml"),
    shipped!("systems/oc3_spar.toml"),
    shipped!("systems/oc4_free.toml"),
    shipped!("systems/oc4_semi.toml"),
    shipped!("systems/polyester_stages.toml"),
    shipped!("systems/semi_taut.toml"),
    shipped!("systems/shared_line.toml"),
    shipped!("systems/single_chain.toml"),
    shipped!("systems/slack_chain.toml"),
    shipped!("systems/sliding_cargo.toml"),
    shipped!("systems/spread_mooring.toml"),
    shipped!("systems/three_chains.toml"),
    shipped!("systems/tripod.toml"),
    shipped!("systems/two_floaters.toml"),
    shipped!("systems/volturnus.toml"),
    shipped!("systems/volturnus_free.toml"),
    shipped!("systems/volturnus_in_waves.toml"),
    shipped!("systems/w_shape.toml"),
    shipped!("systems/winch_lowering.toml"),
];

/// The files that come with the program, by kind.
pub const BY_KIND: [(FileType, &[Shipped]); FileType::ALL.len()] = [
    (FileType::Line, SHIPPED),
    (FileType::Section, SECTIONS),
    (FileType::Ropeway, ROPEWAYS),
    (FileType::Ship, SHIPS),
    (FileType::System, SYSTEMS),
];

/// The shipped file of the kind and the title of this text: what an edited copy of it was before.
#[must_use]
pub fn of_title(text: &str) -> Option<&'static str> {
    let title = title(text)?;
    let (_, files) = BY_KIND
        .iter()
        .find(|(kind, _)| *kind == FileType::of_text(text))?;
    let (_, shipped) = files
        .iter()
        .find(|(_, shipped)| self::title(shipped) == Some(title))?;
    Some(shipped)
}

/// The text of the shipped file at this path below `cases`.
#[must_use]
pub fn text(path: &str) -> Option<&'static str> {
    let mut all = BY_KIND.iter().flat_map(|(_, files)| *files);
    all.find(|(known, _)| *known == path).map(|(_, text)| *text)
}

/// A file that comes with the program beside another, a table or a cross-section: the other by its path, below `cases` or with it, the
/// file as that names it.
#[must_use]
pub fn beside(file: &str, name: &str) -> Option<&'static str> {
    let file = file.strip_prefix("cases/").unwrap_or(file);
    let all = || BY_KIND.iter().flat_map(|(_, files)| *files);
    all().find(|(path, _)| *path == file)?;
    let (folder, _) = file.rsplit_once('/')?;
    let wanted = format!("{folder}/{name}");
    let mut named = BESIDE.iter().chain(all());
    let (_, text) = named.find(|(path, _)| *path == wanted)?;
    Some(text)
}

/// The line of a text that gives its title.
fn title(text: &str) -> Option<&str> {
    let mut lines = text.lines().map(str::trim);
    lines.find(|line| line.starts_with("title"))
}

#[cfg(test)]
mod tests {
    use std::{
        collections::BTreeMap,
        fs,
        path::{Path, PathBuf},
    };

    use super::{BY_KIND, Shipped, beside};
    use crate::kinds::FileType;

    #[test]
    fn tables_are_found_beside_the_files_that_name_them_alone() {
        for file in [
            "systems/volturnus_in_waves.toml",
            "cases/systems/volturnus_in_waves.toml",
        ] {
            assert!(beside(file, "volturnus_data/semi.1").is_some());
            assert!(beside(file, "volturnus_data/other.1").is_none());
        }
        assert!(beside("systems/mine.toml", "volturnus_data/semi.1").is_none());
    }

    #[test]
    fn the_lists_are_the_folder() {
        for (kind, list) in BY_KIND {
            same(list, kind);
        }
    }

    fn same(list: &[Shipped], kind: FileType) {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
        let mut found = BTreeMap::new();
        let mut folders: Vec<PathBuf> = vec![root.clone()];
        while let Some(folder) = folders.pop() {
            for item in fs::read_dir(folder).unwrap() {
                let path = item.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|e| e == "toml")
                    && FileType::of_path(&path) == kind
                {
                    let name = path
                        .strip_prefix(&root)
                        .unwrap()
                        .to_str()
                        .unwrap()
                        .to_owned();
                    found.insert(name, fs::read_to_string(&path).unwrap());
                }
            }
        }
        let listed: BTreeMap<String, String> = list
            .iter()
            .map(|(path, text)| ((*path).to_owned(), (*text).to_owned()))
            .collect();
        assert_eq!(
            listed.keys().collect::<Vec<_>>(),
            found.keys().collect::<Vec<_>>()
        );
        assert!(listed == found, "a listed case is not the text of its file");
    }
}
