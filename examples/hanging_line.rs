//! Builds a line in code, solves its static equilibrium and reads the tensions.
//!
//! ```sh
//! cargo run --example hanging_line
//! ```

use std::error::Error;
use std::io::{self, Write};

use seacable::case::{Case, End, EndKind, Ends, Material, Section};
use seacable::scene;
use seacable::statics::equilibrium::EquilibriumSearch;

/// Tensions \[N\] at the nodes from end A to end B of 120 m of chain between two points 100 m apart at one height.
pub(crate) fn tensions() -> Result<Vec<f64>, Box<dyn Error>> {
    let ends = Ends {
        a: End::new("left", EndKind::Fixed, Some([0.0, 0.0, -10.0])),
        b: End::new("right", EndKind::Fixed, Some([100.0, 0.0, -10.0])),
    };
    let mut case = Case::new("A chain between two points", ends);
    let chain = Material::new(0.14, 97.0, 8.0e8);
    case.materials.insert("chain".to_owned(), chain);
    case.line.push(Section {
        name: "chain".to_owned(),
        material: "chain".to_owned(),
        length_m: 120.0,
        segments: 60,
    });

    let scene = scene::build(&case, 1)?;
    let mut state = scene.initial_state();
    EquilibriumSearch::default().run(&scene, 0.0, &mut state)?;
    Ok(scene.tensions(&state))
}

/// Prints the tensions at the ends and in the middle.
pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let tensions = tensions()?;
    let mut out = io::stdout().lock();
    for (place, node) in [
        ("end A", 0),
        ("middle", tensions.len() / 2),
        ("end B", tensions.len() - 1),
    ] {
        writeln!(out, "{place}: {:.2} kN", tensions[node] / 1e3)?;
    }
    Ok(())
}
