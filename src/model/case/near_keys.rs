//! Keys of a case that are nearly right.

use super::fields::unknown_key;
use super::model::CASE;

#[test]
fn a_unit_left_out_or_wrong_names_the_right_key() {
    let known: Vec<_> = CASE.fields_of("line.*").collect();
    let bare = unknown_key(&CASE, "length", &known, &[]);
    assert_eq!(bare.remedy, "write `length_m`, with the value in m");
    assert_eq!(bare.meant, Some("length_m"));
    let wrong = unknown_key(&CASE, "length_ft", &known, &[]);
    assert_eq!(wrong.problem, "has the wrong unit in its name");
    let known: Vec<_> = CASE.fields_of("materials.*").collect();
    assert_eq!(
        unknown_key(&CASE, "mass_kg", &known, &[]).meant,
        Some("mass_kg_per_m")
    );
    assert_eq!(
        unknown_key(&CASE, "wet_weight_n_per_m", &known, &[]).meant,
        Some("wet_weight_kg_per_m")
    );
}
