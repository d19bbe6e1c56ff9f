//! Quick looks at the seas of a sweep: the same tables, runs in time beside them, and what has none.

use std::fs;
use std::path::Path;

use crate::sweep_checks::{CHAIN, sweep, value};

const SEAS: [&str; 4] = [
    "--vary",
    "waves.1.significant_height_m=2,3",
    "--vary",
    "waves.1.seed=1..3/3",
];
fn write(dir: &Path, text: &str) {
    fs::write(dir.join("chain.toml"), text).unwrap();
}

#[test]
fn a_quick_look_says_what_runs_in_time_say_and_how_far_it_is_from_them() {
    let dir = tempfile::tempdir().unwrap();
    let check = "\n[[checks]]\nname = \"strength\"\nkind = \"safety-factor\"\nfactor = 2.0\nbreak_load_n = 2e6\n";
    write(
        dir.path(),
        &format!("{CHAIN}{check}\n[statistics]\nfrom_s = 10.0\n"),
    );
    let args = ["chain.toml", "--quick", "--sampled", "1", "--out", "all"];
    let words: Vec<&str> = args.into_iter().chain(SEAS).collect();
    let (status, out, err) = sweep(dir.path(), &words);
    assert_eq!(status, Some(0), "{out}{err}");
    let squeezed = out.split_whitespace().collect::<Vec<_>>().join(" ");
    for word in [
        "strength",
        "passes",
        "Quick looks beside runs in time",
        "2 chain|b",
        "times as much a sea",
        "in no verdict",
        "within the interval of the sample",
    ] {
        assert!(squeezed.contains(word), "{word} in {out}");
    }
    // The sampled sea is stored, and the sweep goes on with the others.
    let stored = |dir: &Path| fs::read_dir(dir).unwrap().count();
    assert_eq!(
        stored(dir.path()),
        2 + 3,
        "the file, the folder and three runs"
    );
    let (status, out, err) = sweep(dir.path(), &["--resume", "all"]);
    assert_eq!(status, Some(0), "{out}{err}");
    let seas = fs::read_to_string(dir.path().join("all/seas.csv")).unwrap();
    let in_time = value(&seas, "2", "deviation");
    // A CSV of the looks has the same columns.
    let words: Vec<&str> = ["chain.toml", "--quick", "--csv"]
        .into_iter()
        .chain(SEAS)
        .collect();
    let (_, csv, _) = sweep(dir.path(), &words);
    // Of a record of some twenty waves, whose deviation scatters by 15 %.
    let quick = value(&csv, "2", "deviation");
    assert!((quick / in_time - 1.0).abs() < 0.3, "{quick} {in_time}");
    assert!(value(&csv, "2", "greatest") > value(&csv, "1", "greatest"));
}

/// The feature adds files, and leaves the others as they are.
#[test]
fn tables_are_written_as_parquet_where_the_program_can() {
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), CHAIN);
    let args = [
        "chain.toml",
        "--parquet",
        "--out",
        "all",
        "--set",
        "solver.duration_s=5",
    ];
    let words: Vec<&str> = args
        .into_iter()
        .chain(["--vary", "waves.1.seed=1..2/2"])
        .collect();
    let (status, out, err) = sweep(dir.path(), &words);
    if cfg!(feature = "parquet") {
        assert_eq!(status, Some(0), "{out}{err}");
        for table in ["results", "seas", "checks"] {
            let file = fs::read(dir.path().join(format!("all/{table}.parquet"))).unwrap();
            assert!(
                file.starts_with(b"PAR1") && file.ends_with(b"PAR1"),
                "{table}"
            );
            assert!(dir.path().join(format!("all/{table}.csv")).is_file());
        }
    } else {
        assert_eq!(status, Some(2), "{out}{err}");
        assert!(err.contains("--features parquet"), "{err}");
        assert!(!dir.path().join("all").exists());
    }
}

#[test]
fn what_has_no_quick_look_says_why() {
    let dir = tempfile::tempdir().unwrap();
    let table = "kind = \"moved\"\ntable_time_s = [0.0, 30.0, 60.0]\ntable_x_m = [0.0, 1.0, 0.0]\ntable_y_m = [0.0, 0.0, 0.0]\ntable_z_m = [0.0, 0.0, 0.0]\nposition_m = [0.0, 0.0, -1.0]";
    let moved = CHAIN.replace("kind = \"fixed\"\nposition_m = [0.0, 0.0, -1.0]", table);
    write(dir.path(), &moved);
    let words: Vec<&str> = ["chain.toml", "--quick"].into_iter().chain(SEAS).collect();
    let (status, out, _) = sweep(dir.path(), &words);
    assert_eq!(status, Some(1), "{out}");
    let found = out.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        found.contains("top is moved by a table; run it in time"),
        "{out}"
    );
    write(dir.path(), CHAIN.split("[[waves]]").next().unwrap());
    let words = ["chain.toml", "--quick", "--vary", "seabed.depth_m=50,60"];
    let (status, out, err) = sweep(dir.path(), &words);
    assert_eq!(status, Some(2), "{out}{err}");
    assert!(err.contains("this system has no [solver]"), "{err}");
}
