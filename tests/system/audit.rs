//! The second opinion on files of MoorDyn: what it repeats of that program, what it finds, and that it finds nothing where nothing is.

use seacable::audit::finding::{AuditFinding, Topic};
use seacable::audit::lumped::equilibrium::{Unknowns, at_rest, stiffness};
use seacable::audit::lumped::forces::Loads;
use seacable::audit::lumped::relaxation::{
    Ended, RelaxationSettings, Relaxed, dynamic, stationary,
};
use seacable::audit::lumped::{LumpedModel, build};
use seacable::audit::{Audit, audit};
use seacable::import::to_case::sea::sea_of;
use seacable::import::{ImportOptions, moordyn};
use seacable::numerics::V3;
use seacable::report::audit::{findings, page};
use std::path::Path;

/// A line of the spar of OC3 (Jonkman 2010, NREL/TP-500-47535, section 5).
const CLEAN: &str = "\
--------------------- MoorDyn Input File ------------------------------------
A line of the spar of OC3
----------------------- LINE TYPES ------------------------------------------
TypeName   Diam    Mass/m     EA         BA/-zeta    EI         Cd     Ca     CdAx    CaAx
(name)     (m)     (kg/m)     (N)        (N-s/-)     (N-m^2)    (-)    (-)    (-)     (-)
main       0.09    77.7066    384.243E6  -0.8        0          1.6    1.0    0.1     0.0
---------------------- POINTS -----------------------------------------------
ID    Type      X       Y       Z       Mass   Volume  CdA    Ca
(#)   (-)       (m)     (m)     (m)     (kg)   (m^3)   (m^2)  (-)
1     Fixed     853.87  0       -320.0  0      0       0      0
2     Coupled   5.2     0.0     -70.0   0      0       0      0
---------------------- LINES ------------------------------------------------
ID   LineType   AttachA  AttachB  UnstrLen  NumSegs  LineOutputs
(#)   (name)     (#)      (#)       (m)       (-)     (-)
1     main       1        2         902.2     20      -
---------------------- OPTIONS ----------------------------------------------
0.002         dtM
1025.0        WtrDnsty
320           WtrDpth
60            TmaxIC
------------------------- need this line ------------------------------------
";

/// A chain with a clump weight, which the file has too high.
const CLUMP: &str = "\
--------------------- MoorDyn Input File ------------------------------------
A chain with a clump weight
----------------------- LINE TYPES ------------------------------------------
TypeName   Diam    Mass/m     EA         BA/-zeta    EI         Cd     Ca     CdAx    CaAx
(name)     (m)     (kg/m)     (N)        (N-s/-)     (N-m^2)    (-)    (-)    (-)     (-)
chain      0.09    77.7066    384.243E6  -0.8        0          1.6    1.0    0.1     0.0
---------------------- POINTS -----------------------------------------------
ID    Type      X       Y       Z       Mass   Volume  CdA    Ca
(#)   (-)       (m)     (m)     (m)     (kg)   (m^3)   (m^2)  (-)
1     Fixed     400     0       -200.0  0      0       0      0
2     Free      200     0       -110.0  20000  2       1.0    1.0
3     Coupled   0       0       -20.0   0      0       0      0
---------------------- LINES ------------------------------------------------
ID   LineType   AttachA  AttachB  UnstrLen  NumSegs  LineOutputs
(#)   (name)     (#)      (#)       (m)       (-)     (-)
1     chain      1        2         230       20      -
2     chain      2        3         225       20      -
---------------------- OPTIONS ----------------------------------------------
0.002         dtM
1025.0        WtrDnsty
200           WtrDpth
60            TmaxIC
------------------------- need this line ------------------------------------
";

/// A lazy wave in coarse segments, its joints roughly where they rest.
const LAZY_WAVE: &str = "\
--------------------- MoorDyn Input File ------------------------------------
Lazy wave (inputs after Lozon et al. 2025)
---------------------- LINE TYPES -------------------------------------------
Name    Diam   MassDen  EA      BA/-zeta  EI      Cd   Ca   CdAx  CaAx
(-)     (m)    (kg/m)   (N)     (N-s/-)   (N-m2)  (-)  (-)  (-)   (-)
bare    0.160  36.70    4.69e8  -1.0      1.99e4  1.2  1.0  0.1   0.0
buoyant 0.290  59.53    4.69e8  -1.0      1.99e4  1.2  1.0  0.1   0.0
---------------------- ROD TYPES --------------------------------------------
Name  Diam  MassDen  Cd  Ca  CdEnd  CaEnd
(-)   (m)   (kg/m)   (-) (-) (-)    (-)
join  0.2   0        0   0   0      0
---------------------- RODS -------------------------------------------------
ID  RodType  Attachment  Xa  Ya  Za  Xb  Yb  Zb  NumSegs  Outputs
(-) (-)      (-)         (m) (m) (m) (m) (m) (m) (-)      (-)
1   join     Free        29.0  0  -60.0  29.0  0  -60.0  0  -
2   join     Free        74.0  0  -65.0  74.0  0  -65.0  0  -
---------------------- POINTS -----------------------------------------------
ID  Attachment  X    Y  Z     M  V  CdA  Ca
(-) (-)         (m)  (m) (m)  (kg) (m3) (m2) (-)
1   Fixed       125  0  -80   0  0  0    0
2   Coupled     5    0  -14   0  0  0    0
---------------------- LINES ------------------------------------------------
ID  LineType  AttachA  AttachB  UnstrLen  NumSegs  Outputs
(-) (-)       (-)      (-)      (m)       (-)      (-)
1   bare      2        R1A      68.114    7        -
2   buoyant   R1A      R2A      50.0      5        -
3   bare      R2A      1        52.101    5        -
---------------------- OPTIONS ----------------------------------------------
0.001  dtM
1e5    kBot
1e4    cBot
80     WtrDpth
60     TmaxIC
---------------------- need this line ---------------------------------------
";

fn of(text: &str) -> Audit {
    audit(text, "file.dat", &ImportOptions::default()).unwrap()
}

pub(crate) fn model_of(text: &str, finer: usize) -> LumpedModel {
    let mooring = moordyn::read(text, Path::new("")).unwrap();
    let sea = sea_of(&mooring, &ImportOptions::default()).unwrap();
    build::lumped(&mooring, &sea, finer).unwrap()
}

/// The defaults of MoorDyn in C++ with the step and time of the files above.
const SETTINGS: RelaxationSettings = RelaxationSettings {
    step: 0.002,
    interval: 1.0,
    longest: 60.0,
    drag_scale: 5.0,
    threshold: 0.001,
    courant: 0.0,
};

fn settings(model: &LumpedModel) -> RelaxationSettings {
    let shortest = seacable::audit::start::shortest_period(model);
    RelaxationSettings {
        courant: SETTINGS.step / shortest,
        ..SETTINGS
    }
}

fn topics(audit: &Audit) -> Vec<Topic> {
    audit.findings.iter().map(|finding| finding.topic).collect()
}

fn about<'a>(audit: &'a Audit, subject: &str) -> &'a AuditFinding {
    let mut all = audit.findings.iter();
    all.find(|finding| finding.subject == subject)
        .unwrap_or_else(|| panic!("nothing about {subject}: {}", page(audit)))
}

#[test]
fn nothing_is_found_in_a_clean_file() {
    let audit = of(CLEAN);
    assert_eq!(audit.findings, [], "{}", page(&audit));
    let line = &audit.lines[0];
    // MAP++ 1.20.10 has 911,089 N for this line with a friction of 0.001, which takes next to nothing.
    assert!(
        (line.tension.unwrap() / 911_140.0 - 1.0).abs() < 1e-4,
        "{line:?}"
    );
    // Half a segment's weight: 698 N/m times 22.6 m, times the sine of the angle at the end.
    let less = line.tension.unwrap() - line.mid_segment.unwrap();
    assert!((8e3..1.1e4).contains(&less), "{less}");
    assert!(line.by_segments().unwrap().abs() < 2e-3);
    assert_eq!(audit.starts.len(), 4);
    let step = audit.step.as_ref().unwrap();
    assert!(step.growth <= 0.0 && step.longest.unwrap() > 0.004);
    assert!(page(&audit).contains("Nothing was found."));
}

/// MoorDyn 2.7.2, `MoorDyn_Init`: the stationary scheme ends after 52 s with 900,625 N at B and 735,665 N at A, ICgenDynamic 1 after 0.25 s
/// with 879,557 and 717,142 N.
#[test]
fn the_ways_to_rest_end_where_moordyn_ends_them() {
    let model = model_of(CLEAN, 1);
    let ends = |relaxed: &Relaxed| {
        [
            model.end_tension(0, &relaxed.x),
            model.tension(0, 0, &relaxed.x),
        ]
    };
    let close = |found: [f64; 2], known: [f64; 2], within: f64| {
        for (found, known) in found.into_iter().zip(known) {
            assert!((found / known - 1.0).abs() < within, "{found} {known}");
        }
    };
    let still = stationary(&model, &settings(&model));
    assert_eq!((still.time.round(), still.ended), (52.0, Ended::Converged));
    close(ends(&still), [900_625.2, 735_664.5], 2e-5);
    let to_there = RelaxationSettings {
        longest: 0.25,
        threshold: 0.0,
        ..settings(&model)
    };
    let moved = dynamic(&model, &to_there, 0.01);
    close(ends(&moved), [879_556.8, 717_141.7], 5e-3);
}

/// MoorDyn 2.7.2, with the clump 60 m too high: the stationary scheme ends its 60 s with 192,401 N at the fairlead, the clump at
/// (199.989, 0, -110.042); ICgenDynamic 1 stops after 22.24 s with 700,249 N, the clump at (173.727, 0, -163.239).
#[test]
fn a_clump_that_is_too_high_stays_high() {
    let model = model_of(CLUMP, 1);
    let node = model.points[0].node;
    let still = stationary(&model, &settings(&model));
    assert_eq!(still.ended, Ended::OutOfTime);
    assert!((still.x[node] - V3::new(199.989, 0.0, -110.042)).norm() < 0.02);
    let tension = model.end_tension(1, &still.x);
    assert!((tension / 192_400.8 - 1.0).abs() < 0.02, "{tension}");
    let moved = dynamic(&model, &settings(&model), 0.01);
    assert!((moved.x[node] - V3::new(173.727, 0.0, -163.239)).norm() < 0.2);
    assert!((moved.time - 22.24).abs() < 0.5, "{}", moved.time);
    let audit = of(CLUMP);
    assert_eq!(
        topics(&audit),
        [Topic::Start, Topic::Start],
        "{}",
        page(&audit)
    );
    let far = about(&audit, "point 2");
    assert!(far.figure.unwrap().value > 50.0 && far.remedy.contains("begin at its equilibrium"));
    assert!(about(&audit, "TmaxIC").what.contains("C++ stationary"));
}

#[test]
fn coarse_segments_show_in_tension_and_curvature() {
    let audit = of(LAZY_WAVE);
    assert!(!topics(&audit).contains(&Topic::Mesh), "{}", page(&audit));
    let greatest = |which: usize| {
        let all = audit.lines.iter().filter_map(|line| line.curvature);
        all.map(|both| both[which]).fold(0.0, f64::max)
    };
    let [coarse, fine] = [greatest(0), greatest(1)];
    assert!((fine / 0.0968 - 1.0).abs() < 0.03, "{coarse} {fine}");
    assert!(coarse < 0.95 * fine, "{coarse} {fine}");
    let fewer = [
        ("68.114    7", "68.114    4"),
        ("50.0      5", "50.0      3"),
    ];
    let fewer = fewer.iter().fold(LAZY_WAVE.to_owned(), |file, (own, few)| {
        file.replace(own, few)
    });
    let audit = of(&fewer);
    let found: Vec<&str> = audit
        .findings
        .iter()
        .filter(|f| f.topic == Topic::Mesh)
        .map(|f| f.what.as_str())
        .collect();
    for what in ["at end B where the line has", "a greatest curvature of"] {
        assert!(
            found.iter().any(|one| one.contains(what)),
            "{what}: {found:?}"
        );
    }
    // What is proposed for a curvature was tried, and mends it.
    let bent = audit.findings.iter();
    let bent: Vec<_> = bent
        .filter(|f| f.what.contains("a greatest curvature of"))
        .collect();
    for finding in bent {
        let tried = [
            "or more segments, with which",
            "none by the segments",
            "none that was tried",
        ];
        assert!(
            tried.iter().any(|words| finding.remedy.contains(words)),
            "{finding:?}"
        );
    }
}

#[test]
fn a_step_that_is_too_long_is_found() {
    let audit = of(&CLEAN.replace("0.002         dtM", "0.05          dtM"));
    let found = about(&audit, "dtM");
    assert_eq!(found.topic, Topic::Step);
    let figure = found.figure.unwrap();
    assert!(
        figure.value == 0.05 && figure.reference < 0.03,
        "{figure:?}"
    );
    let by_default = of(&CLEAN.replace("0.002         dtM", ""));
    assert!(about(&by_default, "dtM").what.contains("Courant"));
    let longest = of(CLEAN).step.unwrap().longest.unwrap();
    // The limit is that of the march itself, from next to rest: beyond it what is small grows.
    let mut model = model_of(CLEAN, 1);
    model.start = at_rest(&model, &model.start).unwrap();
    let rest = model.start.clone();
    let moved = |step: f64| {
        let settings = RelaxationSettings {
            step,
            longest: 20.0,
            threshold: 0.0,
            ..settings(&model)
        };
        let found = dynamic(&model, &settings, 0.1);
        let apart = found.x.iter().zip(&rest).map(|(x, rest)| (x - rest).norm());
        apart.fold(0.0, f64::max)
    };
    let (below, beyond) = (moved(0.9 * longest), moved(1.3 * longest));
    assert!(below < 1e-3 && beyond > 1e-2, "{below} {beyond}");
}

/// Faults that are on record, each in one file: what is changed, and the subject and line of what is found.
#[test]
fn settings_against_intent_are_found_where_they_are() {
    let cases = [
        ("-0.8 ", "0.8  ", "line type main", 6, "damps nothing"),
        ("-0.8 ", "-800 ", "line type main", 6, "critical"),
        ("0.09 ", "0.05 ", "line type main", 6, "more than steel"),
        ("902.2", "800.0", "line 1", 15, "more than its length"),
        (
            "320           WtrDpth",
            "300           WtrDpth",
            "point 1",
            10,
            "below the bed",
        ),
        (
            "320           WtrDpth",
            "WtrDpth 320",
            "WtrDpth",
            19,
            "behind its name",
        ),
        (
            "60            TmaxIC",
            "60 TmaxIC\n0.5 FrictionCoefficient",
            "FricDamp",
            21,
            "next to none at rest",
        ),
        (
            "60            TmaxIC",
            "0 TmaxIC\n0.1 mu_kA",
            "mu_kA",
            21,
            "does not know",
        ),
    ];
    for (from, to, subject, line, what) in cases {
        let text = CLEAN.replacen(from, to, 1);
        let audit = of(&text);
        let found = about(&audit, subject);
        assert!(found.what.contains(what), "{to}: {found:?}");
        let span = found.span.as_ref().unwrap();
        let (row, _) = seacable::audit::settings::row_and_column(&text, span);
        assert_eq!(row, line, "{to}: {found:?}");
        assert!(!found.remedy.is_empty());
        assert_eq!(findings(&audit).rows.len(), audit.findings.len());
    }
}

#[test]
fn forces_are_the_gradient_of_the_energy_and_the_stiffness_theirs() {
    for text in [CLEAN, CLUMP, LAZY_WAVE] {
        let model = model_of(text, 1);
        let rest = at_rest(&model, &model.start).unwrap();
        // Somewhere near rest, with tension everywhere.
        let x: Vec<V3> = rest
            .iter()
            .enumerate()
            .map(|(k, place)| match model.free[k] {
                true => place + V3::new(0.1 * (k as f64).sin(), 0.05 * (k as f64).cos(), 1e-3),
                false => *place,
            })
            .collect();
        let still = vec![V3::zeros(); x.len()];
        let mut loads = Loads::of_model(&model);
        model.evaluate(&x, &still, 0.0, &mut loads);
        let force = loads.force.clone();
        let scale = force.iter().map(V3::norm).fold(0.0, f64::max);
        let unknowns = Unknowns::of_model(&model);
        let matrix = stiffness(&model, &unknowns, &x);
        let size = 1e-5;
        for node in (0..x.len()).filter(|node| model.free[*node]) {
            for axis in 0..3 {
                let moved = |by: f64| {
                    let mut x = x.clone();
                    x[node][axis] += by;
                    x
                };
                let slope =
                    (model.energy(&moved(size)) - model.energy(&moved(-size))) / (2.0 * size);
                assert!(
                    (slope + force[node][axis]).abs() < 2e-4 * scale,
                    "{node} {axis}: {slope} {}",
                    force[node][axis]
                );
                let column = unknowns.first[node].unwrap() + axis;
                let tangent = matrix.column(column);
                let mut ahead = Loads::of_model(&model);
                model.evaluate(&moved(size), &still, 0.0, &mut ahead);
                let mut behind = Loads::of_model(&model);
                model.evaluate(&moved(-size), &still, 0.0, &mut behind);
                let greatest = tangent.amax();
                for other in (0..x.len()).filter(|node| model.free[*node]) {
                    let by = (behind.force[other] - ahead.force[other]) / (2.0 * size);
                    for k in 0..3 {
                        let row = unknowns.first[other].unwrap() + k;
                        assert!(
                            (by[k] - tangent[row]).abs() <= 1e-4 * greatest + 1e-3,
                            "{node} {axis} on {other} {k}: {} {}",
                            by[k],
                            tangent[row]
                        );
                    }
                }
            }
        }
    }
}

/// Numbers of a file turned about at random: whatever is read is audited without a panic.
#[test]
fn no_file_makes_an_audit_panic() {
    let mut random = seacable::numerics::random::Random::new(7, 0);
    let values = ["0", "-1", "1e-9", "1e9", "nan", "1", "x", "-0.5", "1e300"];
    for text in [CLEAN, CLUMP, LAZY_WAVE] {
        let text = text
            .replace("60     TmaxIC", "1 TmaxIC")
            .replace("60            TmaxIC", "1 TmaxIC");
        let words: Vec<usize> = text
            .match_indices(|letter: char| letter.is_ascii_digit())
            .map(|(at, _)| at)
            .collect();
        for _ in 0..15 {
            let mut pick = |count: usize| (random.uniform() * count as f64) as usize % count;
            let at = words[pick(words.len())];
            let end = text[at..]
                .find(char::is_whitespace)
                .map_or(text.len(), |end| at + end);
            let changed = format!(
                "{}{}{}",
                &text[..at],
                values[pick(values.len())],
                &text[end..]
            );
            if let Ok(audit) = audit(&changed, "file.dat", &ImportOptions::default()) {
                assert!(!page(&audit).is_empty());
            }
        }
    }
}

#[test]
fn more_segments_than_are_repeated_are_not_judged() {
    let text = CLEAN.replace("902.2     20 ", "902.2     100000000 ");
    assert_ne!(text, CLEAN);
    let audit = of(&text);
    let why = "100000000 segments are more than the 12000 that are repeated here";
    let found = audit.not_judged.iter().any(|one| one.contains(why));
    assert!(found, "{:?}", audit.not_judged);
}

#[test]
fn short_segments_rest_within_what_rounding_leaves() {
    let model = model_of(CLEAN, 40);
    let started = std::time::Instant::now();
    let rest = at_rest(&model, &model.start).unwrap();
    assert!(started.elapsed().as_secs() < 60);
    let coarse = model_of(CLEAN, 1);
    let few = at_rest(&coarse, &coarse.start).unwrap();
    for line in 0..model.lines.len() {
        let [fine, coarse] = [
            model.end_tension(line, &rest),
            coarse.end_tension(line, &few),
        ];
        assert!((fine / coarse - 1.0).abs() < 0.05, "{fine} {coarse}");
    }
}

#[test]
fn a_single_segment_gives_its_tension() {
    let audit = of(&CLEAN.replace("902.2     20 ", "902.2     1 "));
    let found = audit.findings.iter().filter(|one| one.topic == Topic::Mesh);
    for one in found {
        assert!(one.what.starts_with("1 segment gives"), "{}", one.what);
    }
}
