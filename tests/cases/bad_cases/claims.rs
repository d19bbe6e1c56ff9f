//! Studies, published values, trends and marks.

use seacable::case;

use super::{GOOD, assert_fault, faults, spoilt};

#[test]
fn study_of_a_key_that_is_not_there() {
    let fault = spoilt(
        "key = \"materials.chain.diameter_m\"",
        "key = \"materials.chain.diametr_m\"",
    );
    assert_fault(
        &fault,
        (53, 7),
        "study.current.key",
        "there is no key `materials.chain.diametr_m`",
        "did you mean `materials.chain.diameter_m`?",
    );
    let fault = spoilt(
        "key = \"materials.chain.diameter_m\"",
        "key = \"case.title\"",
    );
    assert_fault(
        &fault,
        (53, 7),
        "study.current.key",
        "is not a number",
        "takes one number",
    );
    let fault = spoilt("values = [0.05, 0.1]", "values = [0.05, -0.1]");
    assert_fault(
        &fault,
        (54, 17),
        "study.current.values",
        "is out of range: -0.1 m",
        "greater than 0 m",
    );
}

#[test]
fn published_value_of_a_channel_that_is_not_recorded() {
    let fault = spoilt(
        "channel = \"tension_n[lower|load]\"",
        "channel = \"tension_n[lower|loda]\"",
    );
    assert_fault(
        &fault,
        (58, 11),
        "published.\"tension at the load\".channel",
        "there is no channel named",
        "did you mean \"tension_n[lower|load]\"?",
    );
    let fault = spoilt("channel = \"x_m[load]\"", "channel = \"x_m[vessel]\"");
    assert_fault(
        &fault,
        (70, 11),
        "trend.\"thicker, more drag\".channel",
        "there is no channel named \"x_m[vessel]\"",
        "x_m[load]",
    );
}

#[test]
fn published_value_without_tolerance() {
    let fault = spoilt("tolerance_rel = 0.03\n", "");
    assert_fault(
        &fault,
        (56, 1),
        "published.\"tension at the load\".tolerance_rel",
        "no tolerance",
        "tolerance_abs",
    );
}

#[test]
fn window_that_runs_backward() {
    let fault = spoilt("window_s = [0.0, 200.0]", "window_s = [200.0, 0.0]");
    assert_fault(
        &fault,
        (60, 12),
        "published.\"tension at the load\".window_s",
        "the window is empty",
        "begin before it ends",
    );
}

#[test]
fn peak_without_a_number_and_number_without_a_peak() {
    let old = "channel = \"tension_n[lower|load]\"\nstatistic = \"mean\"\nwindow_s = [0.0, 200.0]";
    let peak = "channel = \"z_m\"\nstatistic = \"peak\"\nstretch_m = [0.0, 80.0]";
    let fault = spoilt(old, peak);
    assert_fault(
        &fault,
        (59, 13),
        "published.\"tension at the load\".statistic",
        "which peak is meant is not stated",
        "add `nth = 1`",
    );
    let numbered = format!("{peak}\nnth = 2");
    assert!(case::parse(&GOOD.replace(old, &numbered), "good.toml").is_ok());
    let fault = spoilt("statistic = \"final\"", "statistic = \"final\"\nnth = 1");
    assert_fault(
        &fault,
        (72, 7),
        "trend.\"thicker, more drag\".nth",
        "`final` has no number",
        "leave `nth` out",
    );
}

#[test]
fn point_of_a_study_that_is_not_there() {
    let fault = spoilt("at = { study = \"current\"", "at = { study = \"curent\"");
    assert_fault(
        &fault,
        (65, 16),
        "published.\"tension at the load\".at.study",
        "there is no study named \"curent\"",
        "did you mean \"current\"?",
    );
    let fault = spoilt("value = 0.05 }", "value = 0.06 }");
    assert_fault(
        &fault,
        (65, 35),
        "published.\"tension at the load\".at.value",
        "0.06 is not a value of the study",
        "0.05, 0.1",
    );
    let fault = spoilt("study = \"current\"\n", "study = \"weight\"\n");
    assert_fault(
        &fault,
        (69, 9),
        "trend.\"thicker, more drag\".study",
        "there is no study named \"weight\"",
        "`current`",
    );
}

#[test]
fn mark_of_a_key_that_is_not_there() {
    let fault = spoilt("\"payload.drag_area_m2\" =", "\"payload.drag_aera_m2\" =");
    assert_fault(
        &fault,
        (49, 1),
        "marks.\"payload.drag_aera_m2\"",
        "there is no key `payload.drag_aera_m2`",
        "did you mean `payload.drag_area_m2`?",
    );
}

#[test]
fn all_faults_are_reported_at_once_in_the_order_of_lines() {
    let text = GOOD
        .replace("length_m = 80.0", "length_m = -80.0")
        .replace("ea_n = 1e9", "ea = 1e9")
        .replace("\"x_m[load]\"", "\"x_m[laod]\"")
        .replace("section = \"upper\"", "section = \"uper\"");
    let keys: Vec<String> = faults(&text).into_iter().map(|fault| fault.key).collect();
    assert_eq!(
        keys,
        [
            "materials.chain.ea",
            "line.upper.length_m",
            "floats.uper.section",
            "trend.\"thicker, more drag\".channel"
        ]
    );
}

#[test]
fn statistics_over_time_and_over_length_are_distinguished() {
    let row = "\n[[trend]]\nname = \"n\"\nstudy = \"t\"\nexpect = \"rises\"\nsource = \"s\"\n";
    let first = |channel: &str, statistic: &str, more: &str| {
        let text =
            format!("{GOOD}{row}channel = \"{channel}\"\nstatistic = \"{statistic}\"\n{more}");
        let all = faults(&text).into_iter();
        all.filter(|fault| fault.key.starts_with("trend.n.") && !fault.key.ends_with("study"))
            .map(|fault| fault.problem)
            .collect::<Vec<String>>()
    };
    assert_eq!(
        first("tension_n", "rate", ""),
        ["`rate` goes over time, and `tension_n` over the length of the line"]
    );
    assert_eq!(
        first("x_m[load]", "turns", ""),
        ["`turns` goes over the length of the line, and a channel over time"]
    );
    assert_eq!(
        first("tension_n", "turns", "window_s = [0.0, 1.0]\n"),
        ["`tension_n` of the whole line is taken over the whole run"]
    );
    assert_eq!(
        first("tension_n", "max", "stretch_m = [9.0, 8.0]\n"),
        ["the stretch runs backward: from 9 m to 8 m"]
    );
    assert_eq!(
        first("x_m[load]", "max", "stretch_m = [1.0, 2.0]\n"),
        ["`x_m[load]` is recorded against time, not along the line"]
    );
    assert!(first("tension_n", "mean", "stretch_m = [8.0, 8.0]\n").is_empty());
    assert!(first("curvature_per_m", "max", "").is_empty());
}
