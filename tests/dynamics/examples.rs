//! The examples of the library run, and their numbers are those of closed forms and of balances.

#[path = "../../examples/hanging_line.rs"]
mod hanging_line;
#[path = "../../examples/moored_line_in_waves.rs"]
mod moored_line_in_waves;

#[test]
fn the_hanging_line_is_the_catenary() {
    hanging_line::main().unwrap();
    let tensions = hanging_line::tensions().unwrap();
    assert_eq!(tensions.len(), 61);
    let (first, last) = (tensions[0], tensions[60]);
    assert!((first - last).abs() < 1e-6 * first, "{first} {last}");
    // The weight in water hangs half on each end.
    let weight = 120.0 * 9.80665 * (97.0 - 1025.0 * std::f64::consts::PI * 0.07 * 0.07);
    let middle = tensions[30];
    assert!((first - middle.hypot(0.5 * weight)).abs() < 2e-3 * first);
}

#[test]
fn the_moored_line_pulls_harder_and_less_in_waves_than_at_rest() {
    moored_line_in_waves::main().unwrap();
    let [at_rest, greatest, least] = moored_line_in_waves::tension_at_vessel().unwrap();
    assert!(0.0 <= least && least < at_rest && at_rest < greatest);
    assert!(greatest < 10.0 * at_rest, "{greatest} N");
}
