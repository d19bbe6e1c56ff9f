//! Tables of lines at rest from files: composite lines as JSON, lines in a current as JSON and CSV, and what is wrong in them.

use seacable::study::lines::solve;

/// Lines in a current, as in `cases/benchmarks`, with the force on their ends from the differential equations of the
/// stretched line (the pull on end B is its negative).
const IN_CURRENT: &str = "\
Ax,Ay,Az,Bx,By,Bz,L,w_Npm,EA_N,d_m,Cd,CdAx,rho,Ux,Uy,Uz,FBx,FBy,FBz,FAx,FAy,FAz
-600,0,-800,0,0,0,1050,200,1e9,0.2,1.2,0,1025,0,0.5,0,70071.38720506744,-19383.70266910543,219715.25653232716,69582.94325942842,12643.17310291285,10211.737677053125
-600,0,-800,0,0,0,1050,200,1e9,0.2,1.2,0,1025,0,1,0,92063.6885788808,-71033.7977202199,240287.13219953587,88314.28809950638,49510.34824673665,34537.82177089581
-600,0,-800,0,0,0,1050,200,1e9,0.2,1.2,0,1025,0.5,0,0,65210.013949465,0,234919.84969346266,82414.77437595406,0,15331.82155916878
";

fn text(input: &str) -> String {
    String::from_utf8(solve(input.as_bytes()).unwrap().text).unwrap()
}

#[test]
fn lines_in_a_current_agree_with_their_differential_equations() {
    let answered = text(IN_CURRENT);
    let mut rows = csv::Reader::from_reader(answered.as_bytes());
    let head = rows.headers().unwrap().clone();
    let mut seen = 0;
    for row in rows.records() {
        let row = row.unwrap();
        let cell = |name: &str| row[head.iter().position(|h| h == name).unwrap()].to_owned();
        let number = |name: &str| cell(name).parse::<f64>().unwrap();
        assert_eq!(cell("status"), "ok");
        let top = number("tension_b_n");
        for (axis, short) in ["x", "y", "z"].iter().zip(["x", "y", "z"]) {
            let a = number(&format!("pull_a_{axis}_n")) - number(&format!("FA{short}"));
            let b = number(&format!("pull_b_{axis}_n")) + number(&format!("FB{short}"));
            assert!(a.abs() < 1e-7 * top && b.abs() < 1e-7 * top, "{a} {b}");
        }
        assert!(number("error_n") < 2e-5 * top);
        seen += 1;
    }
    assert_eq!(seen, 3);
}

#[test]
fn a_current_that_turns_with_depth_and_a_line_of_sections_go_into_json() {
    let uniform = r#"{"a_m": [-600, 0, -800], "b_m": [0, 0, 0], "sections": [[1050, 200, 1e9]], "diameter_m": 0.2, "drag_normal": 1.2, "current": [[0, 0.0, 0.5]]}"#;
    let same = r#"{"a_m": [-600, 0, -800], "b_m": [0, 0, 0], "sections": [[400, 200, 1e9], [650, 200, 1e9, 0]], "diameter_m": 0.2, "drag_normal": 1.2, "current": [[0, 0, 0.5], [300, 0, 0.5], [800, 0, 0.5]]}"#;
    let turning = r#"{"a_m": [-600, 0, -800], "b_m": [0, 0, 0], "sections": [[1050, 200, 1e9]], "diameter_m": 0.2, "drag_normal": 1.2, "current": [[0, 0.5, 0.0], [400, 0.0, 0.5], [800, -0.5, 0.0]]}"#;
    let answered = text(&[uniform, same, turning].join("\n"));
    let number = |line: &str, key: &str| -> f64 {
        let from = line.find(&format!("\"{key}\": ")).unwrap() + key.len() + 4;
        let rest = &line[from..];
        rest[..rest.find([',', '}']).unwrap()].parse().unwrap()
    };
    let lines: Vec<&str> = answered.lines().collect();
    assert!(
        lines
            .iter()
            .all(|line| line.ends_with("\"status\": \"ok\"}")),
        "{answered}"
    );
    for key in ["pull_a_x_n", "pull_a_y_n", "pull_b_y_n", "pull_b_z_n"] {
        let (one, two) = (number(lines[0], key), number(lines[1], key));
        assert!((one - two).abs() < 1e-6 * 231_431.0, "{key} {one} {two}");
    }
    assert!((number(lines[0], "pull_a_y_n") - 12643.173).abs() < 0.02);
    // The pulls on the ends carry weight and drag: the current that turns back on itself nearly cancels along x.
    let along = number(lines[2], "pull_a_x_n") + number(lines[2], "pull_b_x_n");
    assert!(along.abs() < 0.5 * number(lines[2], "pull_a_y_n").abs() + 2e4);
}

#[test]
fn composite_lines_come_back_with_what_they_were_given() {
    let input = r#"{"note": "kept as it is"}
{"i": 2, "segs": [[239.7979341562233, 5.697653987502144, 63601376.77722106], [458.78236611981254, 449.8691781114444, 526545247.87139016], [36.18529859894904, 3472.161980188858, 1298621762.5371437]], "depth": 306.8483848668721, "radius": 548.828173132568}

{"sections": [[900, 1200, 5e8], [100, 600, 5e8]], "x_m": 900, "z_m": 150, "bed_below_a_m": 0, "friction": 0.5, "status": "old"}"#;
    let written = solve(input.as_bytes()).unwrap();
    assert_eq!((written.rows, written.refused), (2, 0));
    let answered = String::from_utf8(written.text).unwrap();
    let lines: Vec<&str> = answered.lines().collect();
    assert_eq!(lines[0], r#"{"note": "kept as it is"}"#);
    assert!(lines[1].starts_with(r#"{"i": 2, "segs": [[239.79"#));
    assert!(
        lines[1].contains(r#""h_b_n": 46500.8859398826"#),
        "{}",
        lines[1]
    );
    assert!(lines[1].contains(r#""shape": "partly on bed", "status": "ok""#));
    assert_eq!(lines[2], "");
    assert!(lines[3].contains(r#""friction": 0.5, "h_b_n""#) && !lines[3].contains("old"));
}

#[test]
fn an_error_in_a_line_is_reported_with_its_place_and_stops_no_other() {
    let input = r#"{"sections": [[100, 1e3]], "x_m": 1, "z_m": 2}
{"sections": [[100, 1e3, 1e9]], "x_m": "a", "z_m": 2}
{"sections": [[100, 1e3, 1e9]], "z_m": 2}
{"x_m": 5,
{"sections": [[100, 1e3, -1]], "x_m": 50, "z_m": 2}
{"sections": [[100, 1e3, 1e9]], "x_m": 50, "z_m": 2, "friction": 1}
{"sections": [[100, 1e3, 1e9]], "a_m": [0, 0, -200], "b_m": [0, 0, 1], "diameter_m": 0.1, "drag_normal": 1, "current": [[0, 1, 0]]}
{"sections": [[100, 1e3, 1e9]], "x_m": 80, "z_m": 2, "x_m": 81}
{"sections": [[100, 1e3, 1e9]], "x_m": 80, "z_m": 2}"#;
    let written = solve(input.as_bytes()).unwrap();
    assert_eq!((written.rows, written.refused), (9, 8));
    let answered = String::from_utf8(written.text).unwrap();
    for (line, words) in answered.lines().zip([
        "line 1, column 15, sections: [length_m",
        "line 2, column 40, x_m: a number is needed",
        "line 3: the key x_m is missing",
        "line 4, column 11: EOF while parsing",
        "line 5: the axial stiffness EA [N] is -1",
        "line 6: there is a slope or friction but no bed",
        "line 7: b_m: the ends are 201.000000 m apart",
        "x_m: given twice",
        "\"status\": \"ok\"",
    ]) {
        assert!(line.contains(words), "{line}");
    }
    let columns = "Ax,Ay,Az,Bx,By,Bz,L,w_Npm,EA_N,d_m,Cd,CdAx,rho,Ux,Uy,Uz";
    let rows = "-600,0,-800,0,0,0,1050,200,1e9,0.2,1.2,0,1025,0,much,0\n\
                -600,0,-800,0,0,0,1050,200,1e9,0.2,1.2,0,1025,0,1,0.5\n\
                -600,0,-800,0,0,0,1050\n";
    let answered = text(&format!("{columns}\n{rows}"));
    assert!(
        answered.contains("line 2, column current_y_m_per_s"),
        "{answered}"
    );
    assert!(
        answered.contains("line 3, column current_z_m_per_s"),
        "{answered}"
    );
    assert!(answered.contains("line 4: 7 cells where the first line names 16 columns"));
    assert!(
        solve(b"Ux,Uy\n1,2\n")
            .unwrap_err()
            .to_string()
            .contains("a_x_m")
    );
}
