//! Tables of load cases.

use super::{GOOD, assert_fault, faults};

/// The fault of a file with this table of load cases, behind the lines of the good one.
fn with(table: &str) -> (seacable::case::Diagnostic, u32) {
    let text = format!("{GOOD}\n[[load_cases]]\n{table}");
    let line = GOOD.lines().count() as u32 + 3;
    let mut found = faults(&text);
    assert_eq!(found.len(), 1, "{table}: {found:#?}");
    (found.remove(0), line)
}

#[test]
fn tables_that_say_too_little_or_too_much() {
    let key = "key = \"materials.chain.diameter_m\"\n";
    for (table, row, column, name, problem, remedy) in [
        ("zip = \"a\"\n", 0, 1, "key", "sets nothing", "add `key"),
        (key, 1, 7, "key", "needs the values", "give either"),
        (
            &format!("{key}values = [0.1]\nrange = \"0.1..0.2/2\"\n"),
            1,
            7,
            "key",
            "once",
            "give either",
        ),
        (
            &format!("{key}values = [0.1, -0.1]\n"),
            2,
            16,
            "values",
            "out of range",
            "greater than 0 m",
        ),
        (
            &format!("{key}range = \"0.1..0.2\"\n"),
            2,
            9,
            "range",
            "lacks the number of values",
            "write A..B/N",
        ),
        (
            &format!("{key}range = \"0.1..0.2/2\"\nprobability = [0.5]\n"),
            3,
            15,
            "probability",
            "1 probabilities of 2",
            "one for each",
        ),
        (
            &format!("{key}range = \"0.1..0.2/2\"\nprobability = [0.5, 0.4]\n"),
            3,
            15,
            "probability",
            "add up to 0.9",
            "add up to 1",
        ),
        (
            "key = \"case.title\"\nvalues = [\"a\"]\n",
            1,
            7,
            "key",
            "is not a number",
            "takes one number",
        ),
        (
            "key = \"materials.chain.diametr_m\"\nvalues = [1.0]\n",
            1,
            7,
            "key",
            "there is no key",
            "did you mean",
        ),
        (
            &format!("{key}file = \"a.csv\"\n"),
            2,
            8,
            "file",
            "a key and a file",
            "a table of its own",
        ),
        (
            "file = \"a.csv\"\nvalues = [1.0]\n",
            2,
            10,
            "values",
            "the file has its own",
            "leave it out",
        ),
    ] {
        let (fault, line) = with(table);
        let line = if row == 0 { line - 1 } else { line + row - 1 };
        assert_fault(
            &fault,
            (line, column),
            &format!("load_cases.1.{name}"),
            problem,
            remedy,
        );
    }
}

#[test]
fn tables_that_go_together_have_as_many_values() {
    let table = "key = \"materials.chain.diameter_m\"\nvalues = [0.1, 0.2]\nzip = \"a\"\n\n\
                 [[load_cases]]\nkey = \"solver.duration_s\"\nvalues = [1.0]\nzip = \"a\"\n";
    let (fault, line) = with(table);
    let place = (line + 7, 7);
    assert_fault(
        &fault,
        place,
        "load_cases.2.zip",
        "a table of 2 rows, and has 1",
        "as many values",
    );
}

#[test]
fn a_file_is_found_and_read_with_the_case() {
    let (fault, line) = with("file = \"no_such.csv\"\n");
    assert_fault(
        &fault,
        (line, 8),
        "load_cases.1.file",
        "no_such.csv cannot be read",
        "beside the case file",
    );
    let carried = format!(
        "{GOOD}\n[[load_cases]]\nfile = \"a.csv\"\n[files.\"a.csv\"]\ntext = \"solver.duration_s\\n5\\nfive\\n\"\n"
    );
    let found = faults(&carried);
    assert!(
        found[0].file.ends_with("a.csv") && found[0].line == 3,
        "{found:#?}"
    );
}
