//! The JSON Schema of every kind of file accepts what the reader accepts, and refuses faults of types, ranges and keys.

use seacable::case::CASE;
use seacable::case::fields::{Schema, json_schema};
use seacable::case::shipped::{ROPEWAYS, SECTIONS, SHIPPED, SHIPS, Shipped};
use serde_json::{Value, json};

/// Why a value does not meet a schema; the part of JSON Schema that the schemas of files use.
fn fault(schema: &Value, value: &Value, path: &str) -> Option<String> {
    let Some(rules) = schema.as_object() else {
        return (schema == &json!(false)).then(|| format!("{path} must not be there"));
    };
    let number = |name: &str| rules.get(name).and_then(Value::as_f64);
    let told = |problem: &str| Some(format!("{path} {problem}"));
    let kind = match value {
        Value::Object(_) => "object",
        Value::Array(_) => "array",
        Value::String(_) => "string",
        Value::Bool(_) => "boolean",
        Value::Number(n) if n.is_i64() || n.is_u64() => "integer",
        _ => "number",
    };
    for (rule, wanted) in rules {
        let wrong =
            match rule.as_str() {
                "type" => {
                    let one = std::slice::from_ref(wanted);
                    let types = wanted.as_array().map_or(one, Vec::as_slice);
                    let fits = types
                        .iter()
                        .any(|wanted| wanted == kind || (wanted == "number" && kind == "integer"));
                    if fits {
                        None
                    } else {
                        told(&format!("is {kind}, not {wanted}"))
                    }
                }
                "enum" => {
                    let known = wanted.as_array().unwrap().contains(value);
                    if known {
                        None
                    } else {
                        told("is not a known word")
                    }
                }
                "minimum" => value
                    .as_f64()
                    .filter(|v| *v < number(rule).unwrap())
                    .and_then(|_| told("is too small")),
                "exclusiveMinimum" => value
                    .as_f64()
                    .filter(|v| *v <= number(rule).unwrap())
                    .and_then(|_| told("is too small")),
                "maximum" => value
                    .as_f64()
                    .filter(|v| *v > number(rule).unwrap())
                    .and_then(|_| told("is too large")),
                "minItems" => value
                    .as_array()
                    .filter(|v| (v.len() as f64) < number(rule).unwrap())
                    .and_then(|_| told("is too short")),
                "maxItems" => value
                    .as_array()
                    .filter(|v| v.len() as f64 > number(rule).unwrap())
                    .and_then(|_| told("is too long")),
                "minProperties" => value
                    .as_object()
                    .filter(|v| (v.len() as f64) < number(rule).unwrap())
                    .and_then(|_| told("is empty")),
                "required" => wanted.as_array().unwrap().iter().find_map(|key| {
                    let key = key.as_str().unwrap();
                    (value.is_object() && value.get(key).is_none())
                        .then(|| format!("{path}.{key} is missing"))
                }),
                "properties" => wanted.as_object().unwrap().iter().find_map(|(key, inner)| {
                    fault(inner, value.get(key)?, &format!("{path}.{key}"))
                }),
                "additionalProperties" => value.as_object().and_then(|object| {
                    object.iter().find_map(|(key, inner)| {
                        let known = rules
                            .get("properties")
                            .is_some_and(|p| p.get(key).is_some());
                        if known {
                            None
                        } else {
                            fault(wanted, inner, &format!("{path}.{key}"))
                        }
                    })
                }),
                "items" => value
                    .as_array()
                    .and_then(|items| items.iter().find_map(|item| fault(wanted, item, path))),
                "anyOf" => {
                    let all: Vec<Option<String>> = wanted
                        .as_array()
                        .unwrap()
                        .iter()
                        .map(|s| fault(s, value, path))
                        .collect();
                    if all.iter().any(Option::is_none) {
                        None
                    } else {
                        all.into_iter().flatten().next()
                    }
                }
                "allOf" => wanted
                    .as_array()
                    .unwrap()
                    .iter()
                    .find_map(|s| fault(s, value, path)),
                "if" => {
                    let branch = if fault(wanted, value, path).is_none() {
                        "then"
                    } else {
                        "else"
                    };
                    rules
                        .get(branch)
                        .and_then(|schema| fault(schema, value, path))
                }
                "pattern" => {
                    let name = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_');
                    let fits = value
                        .as_str()
                        .is_none_or(|text| !text.is_empty() && text.chars().all(name));
                    if fits { None } else { told("is not a name") }
                }
                "then" | "else" | "description" | "default" | "$schema" | "title" => None,
                other => panic!("the schema has a rule that this test does not know: {other}"),
            };
        if wrong.is_some() {
            return wrong;
        }
    }
    None
}

fn as_json(text: &str) -> Value {
    serde_json::to_value(text.parse::<toml::Table>().unwrap()).unwrap()
}

fn kinds() -> [(&'static Schema, &'static [Shipped]); 4] {
    [
        (&CASE, SHIPPED),
        (&seacable::section::SECTION, SECTIONS),
        (&seacable::ropeway::ROPEWAY, ROPEWAYS),
        (&seacable::ship::SHIP, SHIPS),
    ]
}

#[test]
fn every_shipped_file_meets_the_schema_of_its_kind() {
    for (schema, files) in kinds() {
        let rules = json_schema(schema);
        for (path, text) in files {
            assert_eq!(fault(&rules, &as_json(text), ""), None, "{path}");
        }
    }
}

/// Spoils one value after the other: each must be refused. Returns how many were.
fn spoil(rules: &Value, root: &Value, pointer: &str, spoilt: &mut usize) {
    let here = root.pointer(pointer).unwrap();
    let mut refuse = |wrong: Value, what: &str| {
        let mut changed = root.clone();
        *changed.pointer_mut(pointer).unwrap() = wrong;
        assert!(fault(rules, &changed, "").is_some(), "{pointer}: {what}");
        *spoilt += 1;
    };
    match here {
        Value::Object(object) => {
            let open = pointer.is_empty() || !object.values().all(Value::is_object);
            if open {
                let mut more = here.clone();
                more["no_such_key"] = json!(1);
                refuse(more, "unknown key");
            }
            for key in object.keys() {
                let key = key.replace('~', "~0").replace('/', "~1");
                spoil(rules, root, &format!("{pointer}/{key}"), spoilt);
            }
        }
        Value::Array(items) if items.iter().all(Value::is_object) => {
            for index in 0..items.len() {
                spoil(rules, root, &format!("{pointer}/{index}"), spoilt);
            }
        }
        Value::Number(_) => {
            refuse(json!(true), "type");
        }
        Value::Bool(_) => refuse(json!(0.5), "type"),
        _ => refuse(json!({}), "type"),
    }
}

#[test]
fn unknown_keys_and_wrong_types_do_not_meet_the_schema() {
    for (schema, files) in kinds() {
        let rules = json_schema(schema);
        for (path, text) in &files[..files.len().min(3)] {
            let mut spoilt = 0;
            spoil(&rules, &as_json(text), "", &mut spoilt);
            assert!(spoilt > 20, "{path}: {spoilt}");
        }
    }
}

#[test]
fn values_out_of_range_words_and_conditions_do_not_meet_the_schema() {
    let rules = json_schema(&CASE);
    let good = as_json(include_str!("../../cases/double_stepped/regular_wave.toml"));
    let with = |pointer: &str, value: Value| {
        let mut case = good.clone();
        let (table, key) = pointer.rsplit_once('/').unwrap();
        case.pointer_mut(table).unwrap()[key] = value;
        fault(&rules, &case, "")
    };
    assert_eq!(with("/solver/rho_inf", json!(1)), None);
    assert!(
        with("/solver/rho_inf", json!(1.5))
            .unwrap()
            .contains("too large")
    );
    assert!(
        with("/solver/duration_s", json!(0))
            .unwrap()
            .contains("too small")
    );
    assert!(
        with("/line/0/segments", json!(2.5))
            .unwrap()
            .contains("not [\"integer\"")
    );
    assert!(
        with("/line/0/name", json!("a b"))
            .unwrap()
            .contains("not a name")
    );
    assert!(
        with("/solver/method", json!("rk5"))
            .unwrap()
            .contains("not a known word")
    );
    assert!(
        with("/ends/a/position_m", json!([0, 0]))
            .unwrap()
            .contains("too short")
    );
    // Keys of irregular waves in regular ones.
    assert_eq!(with("/waves/phase_deg", json!(10)), None);
    assert!(
        with("/waves/gamma", json!(3.3))
            .unwrap()
            .contains("must not be there")
    );
    assert!(
        with("/waves/kind", json!("irregular"))
            .unwrap()
            .contains("missing")
    );
    // One of two keys that say the same in another way.
    let material = good["materials"]
        .as_object()
        .unwrap()
        .keys()
        .next()
        .unwrap()
        .clone();
    let mut case = good.clone();
    case["materials"][&material]
        .as_object_mut()
        .unwrap()
        .remove("ea_n");
    assert!(fault(&rules, &case, "").is_some());
    case["materials"][&material]["strain"] = json!([0.0, 0.1]);
    case["materials"][&material]["tension_n"] = json!([0.0, 1e6]);
    assert_eq!(fault(&rules, &case, ""), None);
}
