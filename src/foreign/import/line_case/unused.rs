//! What of a case is not carried over and does not act in the system, in words.

use super::end_clumps;
use super::published;
use super::source::LineSource;
use super::start;
use super::traveller;
use super::trials::CarriedTrials;
use crate::case::StartShape;

/// Keys of what bears on a bed, without effect where there is none.
const BEARING: [&str; 4] = [
    "bed_area_m2",
    "bottom_m",
    "breakout_n",
    "breakout_distance_m",
];

/// The remarks, a sentence each.
pub(super) fn remarks(source: &LineSource<'_>, trials: &CarriedTrials) -> Vec<String> {
    let mut left_out: Vec<String> = Vec::new();
    let trials = trials.left_out(source);
    if !trials.is_empty() {
        left_out.push(format!(
            "trials of what no keys of the system set alone, or that are held against nothing: {}",
            trials.join(", ")
        ));
    }
    let studies = published::studies_left_out(source);
    if !studies.is_empty() {
        let names = studies.join(", ");
        left_out.push(format!(
            "studies of keys whose value no key of a system has alone: {names}"
        ));
    }
    let (lost, all) = published::left_out(source);
    if lost > 0 {
        left_out.push(format!("{lost} of {all} published values, trends and curves, which are of such studies, or of statistics or channels that a system has none of"));
    }
    if bears_on_nothing(source) {
        left_out.push("how the payload or clumps bear on a bed, as there is none".to_owned());
    }
    for clump in end_clumps::left_out(source) {
        left_out.push(format!(
            "`{clump}`, which hangs on a held end and pulls on nothing but what holds it"
        ));
    }
    let mut remarks = Vec::new();
    if !left_out.is_empty() {
        remarks.push(format!("NOT CARRIED OVER: {}.", left_out.join("; ")));
    }
    remarks.extend(traveller::remark(source));
    if !source.is_in_time() {
        remarks.extend(at_rest(source));
    }
    remarks
}

fn bears_on_nothing(source: &LineSource<'_>) -> bool {
    let given = |table: &[&str]| {
        let mut keys = BEARING.iter();
        keys.any(|key| source.node(&[table, &[*key]].concat()).is_some())
    };
    let mut clumps = source.case.clumps.iter();
    source.case.seabed.is_none()
        && (given(&["payload"]) || clumps.any(|clump| given(&["clumps", &clump.name])))
}

/// What a case at rest says of a run in time, or of how its equilibrium is found.
fn at_rest(source: &LineSource<'_>) -> Vec<String> {
    let mut remarks = Vec::new();
    let begins = &source.case.start;
    let is_given = begins.shape == StartShape::Straight || begins.arc_m.is_some();
    if is_given && !start::is_searched_from(source) {
        remarks.push("The search for the equilibrium begins where the system puts it, not at the start of the case.".to_owned());
    }
    remarks
}
