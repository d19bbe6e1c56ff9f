//! What the columns of tables are: what each holds, its unit, and where it comes from.

/// What a column of a table is: by its title, which may be the beginning of it, and its head.
struct Explanation {
    /// What the title of the table holds; empty: any table.
    table: &'static str,
    /// The head of the column.
    head: &'static str,
    words: &'static str,
}

const fn of(head: &'static str, words: &'static str) -> Explanation {
    Explanation {
        table: "",
        head,
        words,
    }
}

const fn of_table(table: &'static str, head: &'static str, words: &'static str) -> Explanation {
    Explanation { table, head, words }
}

/// The columns of the tables on the screen; one of a table by its title goes before one of any table.
#[rustfmt::skip] // a table: one column a line
const ALL: &[Explanation] = &[
    of("", "What the row is of; the title of the table says of what the values are."),
    of("made fast", "The value with the rope made fast on the ship: its length is held."),
    of("on the winch", "The value with the rope on a winch that holds its tension."),
    of("force by motion", "The force or moment that all lines put on the body, by the motion of the column: a row of the stiffness matrix."),
    of("heave", "Vertical motion of the body, positive up, or the force along it."),
    of("quantity", "What is compared or stated, and of what. In the validation table from a [[published]] row of the file; the number in brackets is that of the note below."),
    of("outcome", "PASS within its tolerance, FAIL outside, DIFFERS known to differ for the reason stated, EDITED of inputs that you changed, NOT RUN without its run. Of trials: OK, REFUSED with a reason, WRONG."),
    of("published", "The value that the source prints, with as many digits. From the key value of its [[published]] row."),
    of("computed", "The value of the run or of the model, by the same definition as the published one."),
    of("error", "Numerical error of the computed value: of time step and mesh, estimated by companion runs or by a second mesh. Of trials: computed less expected."),
    of("difference", "Computed value less published value."),
    of("tolerance", "The difference that counts as agreement: the key tolerance_abs or tolerance_rel of the [[published]] row."),
    of("kind", "Whether the source gives a number printed, one read off a figure, or one of another program."),
    of_table("Nodes", "greatest", "The quantity of which the node has the greatest value along the line."),
    of("greatest", "Greatest value over all time steps of the run."),
    of("least", "Smallest value over all time steps of the run."),
    of("arc", "Unstretched length along the line from end A."),
    of("x", "First coordinate, in the axes of the file."),
    of("y", "Second coordinate, in the axes of the file."),
    of("z", "Height above still water; negative below."),
    of("tension", "Effective tension of the line there, from the solution of the run or of the model."),
    of("curvature", "Curvature of the line there: one over its radius."),
    of("moment", "Bending moment there: bending stiffness times curvature."),
    of("response", "Whether the place is a local greatest of the response."),
    of("rms", "Root mean square of the motion about its mean over the time window of the analysis."),
    of("section", "The section of the line, by its name in the file."),
    of("greatest tension", "Greatest tension of the line, or of all lines, in this state or over the run."),
    of("at arc", "Where along the line it is, as unstretched length from end A."),
    of("breaking load", "Breaking load of the material: the key break_load_n."),
    of("used", "Share of the limit that the load uses; 100 % is the limit."),
    of("least radius", "Least radius of curvature along the section."),
    of("allowed", "What the case allows: the least radius of its section, or the error of its trial."),
    of("mode", "Number of the natural mode, the lowest frequency first."),
    of("frequency", "Natural frequency about the state at rest; added mass is in, drag is not."),
    of("period", "Natural period: one over the frequency."),
    of("WKB", "The same by WKB theory of a taut line with slowly changing tension and mass, for comparison."),
    of("moves", "The direction in which the mode moves: in the plane of the line, across it, or along it."),
    of("of kind", "Number of the mode among those of its direction."),
    of("half waves", "Half waves of the shape along the line."),
    of("out of plane", "Share of the motion across the plane of the line."),
    of("case", "The case, by its file."),
    of("trial", "What is tried: the method and the setting of a [[trial]] of the case; the number is that of its note."),
    of("solver", "The solver with its settings."),
    of("expected", "The value of a closed form or of a converged run."),
    of("steps", "Accepted time steps."),
    of("iterations", "Newton iterations, or evaluations of the forces of explicit methods."),
    of("work", "Newton iterations, or evaluations of the forces of explicit methods."),
    of("rejections", "Steps that were tried, refused and tried again with half the step."),
    of("rej.", "Steps that were tried, refused and tried again with half the step."),
    of("layer", "A layer of the cable from the inside out, by its name in the file."),
    of("made of", "The units of the layer with their number, or its material."),
    of("lay angle", "Angle between the units of the layer and the axis of the cable; positive right-handed."),
    of("pitch radius", "Radius of the helix on which the axes of the units lie."),
    of("lay length", "Length of the cable in which a unit turns once about it."),
    of("cover", "Share of the circumference that the units of the layer fill."),
    of("outer diameter", "Outer diameter of the layer."),
    of("mass", "Mass by length."),
    of("rigid core, Theta = 0", "The value with a core that does not give way under the pressure of the helices."),
    of("incompressible core, Theta = 1", "The value with a core that gives way at constant volume."),
    of("model error", "The spread of the two assumptions on the core: an error of the model, apart from those of numbers."),
    of("theory", "The theory by which the value is computed, with its source."),
    of("value", "The value, with its unit."),
    of("basis", "From what it is computed."),
    of("unit", "A unit of the layer: a wire, tube or conductor."),
    of("count", "How many there are."),
    of("share", "Share of the whole that this part takes."),
    of("force per unit", "Axial force in one unit at the tension stated."),
    of("stress", "Axial stress in the unit: its force by its area."),
    of("utilisation", "Stress by the allowable stress of the material; 100 % is the limit."),
    of("length of rope", "Unstretched length of rope between the two ends."),
    of("length", "Length of the rope."),
    of("horizontal tension", "Horizontal part of the tension, the same all along a rope at rest."),
    of("tension at the platform", "Tension at the end on the platform."),
    of("at the platform", "Tension at the end on the platform."),
    of("tension at the ship", "Tension at the end on the ship."),
    of("at the ship", "Tension at the end on the ship."),
    of("sag at the cargo", "Height of the straight line between the ends above the cargo."),
    of("clearance of the cargo", "Height of the lowest point of the cargo above still water."),
    of("clearance", "Height of the lowest point of the cargo above still water."),
    of("from the platform", "Horizontal distance of the cargo from the platform."),
    of("rope", "The rope, by its construction and strength class."),
    of("diameter", "Nominal diameter."),
    of("use of breaking load", "Greatest tension by the breaking load of the rope."),
    of("ratio", "The value of the model by that of the finite-element check."),
    of("end tension", "Tension at the end of the rope for this place of the cargo."),
    of("horizontal component", "Horizontal part of the tension at the end."),
    of("natural period", "Period in which the cargo swings freely."),
    of("inextensible", "The model of the paper: a rope that does not stretch."),
    of("paper", "The value that the paper prints."),
    of("parabola", "The rope as a parabola: small sag, weight by horizontal length."),
    of("elastic", "The exact elastic catenary with the cargo on it."),
    of("discretised", "The line of segments of the solver."),
    of("channel", "A quantity at a place over time: tension, position, force. The name is that of its column in history.csv."),
    of("mean", "Mean over the time of the run."),
    of("std dev", "Standard deviation over the time of the run."),
    of("deviation", "Standard deviation over the time of the run."),
    of("min", "Smallest value over the run."),
    of("max", "Greatest value over the run."),
    of("time error", "Error of the time step, estimated by companion runs with other steps."),
    of("mesh error", "Error of the mesh, estimated by companion runs on other meshes."),
    of("model", "The model that gives the values of the row."),
    of("amplitude ratio of a period", "Amplitude by that of one period before: how fast the motion decays."),
    of("motion", "One of the six motions of the ship."),
    of("target rms", "Root mean square of the spectrum that the motion is made from."),
    of("target m0", "Area below the spectrum that the motion is made from."),
    of("m0", "Area below the spectrum of the record."),
    of("target Tz", "Mean zero up-crossing period of the spectrum that the motion is made from."),
    of("Tz", "Mean zero up-crossing period of the record."),
    of("expected max", "The greatest value expected of a Gaussian process of this length."),
    of("skewness", "Third moment of the record by the cube of its deviation: 0 for a Gaussian process."),
    of("excess", "Fourth moment of the record by the fourth power of its deviation, less 3: 0 for a Gaussian process."),
    of("crossings", "Up-crossings of the mean in the record."),
    of("heading", "Direction of the bow, in the axes of the file."),
    of("static stability", "Whether a small turn of the ship is turned back by the loads at rest."),
    of("dynamic stability", "Whether small motions about the equilibrium die out: no eigenvalue has a positive real part."),
    of("yaw stiffness", "Moment that turns the ship back, by angle."),
    of("pull", "Force of the mooring line on the ship."),
    of("bow towards", "Direction of the bow."),
    of("bow from anchor", "Distance of the bow from the anchor."),
    of("stiffness along", "Stiffness of the mooring line along its direction."),
    of("stiffness across", "Stiffness of the mooring line across its direction."),
    of("half or double", "Time in which the motion falls to half or grows to double."),
    of("eigenvalues", "Eigenvalues of the small motions about the equilibrium."),
    of("load", "The load: current, wind, waves, mooring line."),
    of("surge", "Force along the ship, or motion along it."),
    of("sway", "Force across the ship, or motion across it."),
    of("yaw, about the centre", "Moment about the centre of the ship."),
    of("yaw, about the mooring", "Moment about the point where the mooring line is made fast."),
    of("offset", "Horizontal distance of the body from its place at rest."),
    of("restoring force", "Horizontal force of all lines that pulls the body back."),
    of("down", "Vertical force of all lines on the body, positive down."),
    of("in line", "The line in which the tension is greatest."),
    of("of breaking load", "Tension by the breaking load of the material."),
    of("of break", "Tension by the breaking load of the material."),
    of("anchor uplift", "Greatest upward pull of a line on its anchor."),
    of("result", "The result that is asked for."),
    of("wanted", "The value that it is to have."),
    of("comes to", "The value that it has in the solution found."),
    of("with", "The key that is changed."),
    of("at", "The value found, or the time of the value at its left."),
    of("load towards", "Direction of the steady load."),
    of("in", "The line in which the tension is greatest."),
    of("offset, line lost", "The same with the worst line lost."),
    of("lost", "The line of which the loss is worst."),
    of("tension, line lost", "Greatest tension in the lines that are left."),
    of("governing", "Which state governs."),
    of("mostly", "What moves most in this mode."),
    of("at rest", "How the equilibrium was found, and how it differs from the others."),
    of("line", "The line, by its name in the file."),
    of("from", "The point or body at which the line begins."),
    of("to", "The point or body at which the line ends."),
    of("tension at from", "Tension at the beginning of the line."),
    of("at from", "Tension at the beginning of the line."),
    of("tension at to", "Tension at the end of the line."),
    of("at to", "Tension at the end of the line."),
    of("angle", "Angle of the line to the horizontal at the end at its left; positive upwards along the line."),
    of("on the bed", "Length of the line that lies on the sea bed."),
    of("on bed", "Length of the line that lies on the sea bed."),
    of("point", "The point, by its name in the file."),
    of("held", "How it is held: fixed, free, or on a body."),
    of("pull of the lines", "Force of all lines on the point."),
    of("error of place", "Error of the place by the meshes of all divided lines, from the same system with twice the segments."),
    of("error of pull", "The same of the force of all lines."),
    of("error of angles", "The same of the angle by which the body is turned."),
    of("upwards", "Vertical part of it, positive up."),
    of("body", "The body, by its name in the file."),
    of("roll", "Turn about the body's own x, last."),
    of("pitch", "Turn about the body's y, before the roll."),
    of("yaw", "Turn about the vertical, first."),
    of("lines x", "First component of the force of all lines on the body."),
    of("lines y", "Second component of the force of all lines on the body."),
    of("lines z", "Vertical component of the force of all lines on the body."),
    of("pin x", "First component of the force of the pins on the body."),
    of("pin y", "Second component of the force of the pins on the body."),
    of("pin z", "Vertical component of the force of the pins on the body."),
    of("least distance", "Least distance between the two lines."),
    of("from line", "The other line."),
    of("from a body", "Least distance of the line from a body that it is not made fast to."),
    of("which", "The body."),
    of("above the bed", "Least height of the line above the sea bed."),
    of("below the surface", "Least depth of the line below still water."),
    of("at the end", "Value at the end of the run."),
    of("check", "The check, by its name in the file; its kind and its limits are in a [[checks]] table."),
    of("verdict", "Whether the limit is kept with certainty, exceeded with certainty, or within the errors of the limit."),
    of("numerical", "What the numerical error of the runs adds to or takes from the share used."),
    of("sample", "Interval of the share used that the sample of seeds leaves open."),
    of("place", "Where it is: a line with the length along it, a point, a body."),
    of("sea", "Number of the sea: the load cases that differ by their seeds alone."),
    of("load case", "The load case that governs, by its number."),
    of("time", "The time at which it governs."),
    of("settings", "What is set in this sea."),
    of("p", "Share of the time in which the sea is met: the key probability."),
    of("damage in service", "Damage by Miner's sum over the time of service; 1 is failure."),
    of("life", "Time after which the damage is 1."),
];

/// What a column is, with the unit of its head; absent where nothing is known of it.
#[must_use]
pub fn known(title: &str, head: &str) -> Option<&'static str> {
    let head = bare(head);
    let named = |of: &&Explanation| of.head.eq_ignore_ascii_case(head);
    let mut of_title = ALL
        .iter()
        .filter(|of| !of.table.is_empty() && title.contains(of.table));
    let any = || ALL.iter().filter(|of| of.table.is_empty()).find(named);
    let found = of_title.find(named).or_else(any)?;
    Some(found.words)
}

/// What a column is, in sentences.
#[must_use]
pub fn words(title: &str, head: &str) -> String {
    let unit = match unit(head) {
        Some(unit) => format!(" Unit: {unit}."),
        None => String::new(),
    };
    match known(title, head) {
        Some(words) => format!("{words}{unit}"),
        None => format!("The values of \"{head}\" for what is at the left of each row.{unit}"),
    }
}

/// The head without its unit.
fn bare(head: &str) -> &str {
    head.split_once(" [").map_or(head, |(bare, _)| bare).trim()
}

/// The unit in the head.
fn unit(head: &str) -> Option<&str> {
    let (_, behind) = head.split_once('[')?;
    behind.split_once(']').map(|(unit, _)| unit)
}
