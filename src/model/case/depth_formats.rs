//! Files of depths as other programs write them: of MoorDyn with a row for each place, of MoorPy as a table.
//!
//! ```text
//! MoorDyn           MoorPy
//! 3 2               --- MoorPy Bathymetry Input File ---
//! -10 0 10          nGridX 3
//! -5 5              nGridY 2
//! -10 -5 -30                -10    0   10
//! ... x y z         -5       30   31   32
//!                    5       30   31   32
//! ```
//!
//! MoorDyn's z is a height, negative below still water; the rows of MoorPy are depths at y and, in their columns, at x.

use super::attachments::{PlacedNumber, PlacedWord};
use super::diagnostic::Finding;
use super::placed_words::{lines, numbers, whole};

/// Places and depths x, y, depth \[m\].
pub(super) type DepthRow = [PlacedNumber; 3];

/// How far a place of a row may be from that of its axis, by the size of the numbers: they are written with fewer digits.
const SAME_PLACE: f64 = 1e-9;

/// The depths of a file in one of these formats; nothing for a table in another one.
///
/// # Errors
/// The first fault.
pub(super) fn foreign_depths(text: &str) -> Result<Option<Vec<DepthRow>>, Finding> {
    let lines: Vec<Vec<PlacedWord<'_>>> = lines(text).filter(|line| !line.is_empty()).collect();
    let first = lines.first().map(Vec::as_slice);
    let second = lines.get(1).and_then(|line| line.first());
    if let Some([columns, rows]) = first
        && is_count(columns)
        && is_count(rows)
    {
        return of_rows(&lines, [columns, rows]).map(Some);
    }
    match second {
        Some((word, _)) if word.eq_ignore_ascii_case("nGridX") => of_table(&lines).map(Some),
        _ => Ok(None),
    }
}

/// MoorDyn: counts, places along x, places along y, rows.
fn of_rows(
    lines: &[Vec<PlacedWord<'_>>],
    counts: [&PlacedWord<'_>; 2],
) -> Result<Vec<DepthRow>, Finding> {
    let x = axis(lines.get(1), counts[0], "x")?;
    let y = axis(lines.get(2), counts[1], "y")?;
    let mut rows = Vec::new();
    for line in lines.iter().skip(3) {
        let numbers = numbers(line)?;
        let [at_x, at_y, z] = <[PlacedNumber; 3]>::try_from(numbers).map_err(|numbers| {
            let problem = format!("the row has {} numbers", numbers.len());
            Finding::new(&whole(line), "", problem, "write x, y and z")
        })?;
        rows.push([on_axis(&x, at_x, "x")?, on_axis(&y, at_y, "y")?, minus(z)]);
    }
    let wanted = x.len().saturating_mul(y.len());
    if rows.len() != wanted {
        let problem = format!(
            "{} rows follow for {} places by {}",
            rows.len(),
            x.len(),
            y.len()
        );
        let remedy = "write a row x y z for every pair of places, each once";
        return Err(Finding::new(&counts[0].1, "", problem, remedy));
    }
    Ok(rows)
}

/// MoorPy: names with counts, places along x, rows of a place along y and depths.
fn of_table(lines: &[Vec<PlacedWord<'_>>]) -> Result<Vec<DepthRow>, Finding> {
    let count = |line: usize, name: &str| -> Result<&PlacedWord<'_>, Finding> {
        let words = lines.get(line).map(Vec::as_slice).unwrap_or_default();
        match words {
            [key, count, ..] if key.0.eq_ignore_ascii_case(name) && is_count(count) => Ok(count),
            _ => {
                let at = words.first().map_or(0..0, |word| word.1.clone());
                let remedy = format!("write `{name}` and a whole number there");
                Err(Finding::new(&at, name, "the count is missing", remedy))
            }
        }
    };
    let x = axis(lines.get(3), count(1, "nGridX")?, "x")?;
    let counted = count(2, "nGridY")?;
    let mut rows = Vec::new();
    for line in lines.iter().skip(4) {
        let numbers = numbers(line)?;
        let Some((y, depths)) = numbers.split_first().filter(|(_, d)| d.len() == x.len()) else {
            let problem = format!(
                "the row has {} numbers for {} places",
                numbers.len(),
                x.len()
            );
            let remedy = "write y and a depth for every place along x";
            return Err(Finding::new(&whole(line), "", problem, remedy));
        };
        let row = x.iter().zip(depths);
        rows.extend(row.map(|(x, depth)| [x.clone(), y.clone(), depth.clone()]));
    }
    if Ok(rows.len())
        != counted
            .0
            .parse::<usize>()
            .map(|count| count.saturating_mul(x.len()))
    {
        let problem = format!("{} rows of depths follow", lines.len().saturating_sub(4));
        return Err(Finding::new(
            &counted.1,
            "nGridY",
            problem,
            "give their count",
        ));
    }
    Ok(rows)
}

/// The places along an axis, as many as its count says.
fn axis(
    line: Option<&Vec<PlacedWord<'_>>>,
    count: &PlacedWord<'_>,
    name: &str,
) -> Result<Vec<PlacedNumber>, Finding> {
    let places = numbers(line.map(Vec::as_slice).unwrap_or_default())?;
    if count.0.parse() != Ok(places.len()) {
        let at = line.map_or(count.1.clone(), |line| whole(line));
        let problem = format!(
            "{} places along {name} for a count of {}",
            places.len(),
            count.0
        );
        return Err(Finding::new(
            &at,
            "",
            problem,
            "give as many places as the count says",
        ));
    }
    Ok(places)
}

/// The place of an axis that a number of a row means.
fn on_axis(
    axis: &[PlacedNumber],
    given: PlacedNumber,
    name: &str,
) -> Result<PlacedNumber, Finding> {
    let near = |place: &&PlacedNumber| {
        let size = place.value.abs().max(given.value.abs());
        (place.value - given.value).abs() <= SAME_PLACE * size
    };
    let found = axis.iter().find(near);
    let value = found.map(|place| place.value).ok_or_else(|| {
        let problem = format!("{} is no place along {name}", given.value);
        Finding::new(&given.span, "", problem, "take one of the places above")
    })?;
    Ok(PlacedNumber { value, ..given })
}

fn minus(z: PlacedNumber) -> PlacedNumber {
    PlacedNumber {
        value: -z.value,
        ..z
    }
}

fn is_count(word: &PlacedWord<'_>) -> bool {
    word.0.parse::<usize>().is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(text: &str) -> Vec<[f64; 3]> {
        let rows = foreign_depths(text).unwrap().unwrap();
        rows.iter()
            .map(|row| [0, 1, 2].map(|k| row[k].value))
            .collect()
    }

    const MOORDYN: &str = "3 2\n-10.0 0 10\n-5 5\n-10 -5 -30\n0 -5 -31\n10 -5 -32\n-10 5 -33\n0 5 -34\n10.0000000001 5 -35\n";
    const MOORPY: &str = "--- MoorPy Bathymetry Input File ---\nnGridX 3\nnGridY 2\n   -10 0 10\n-5 30 31 32\n5 33 34 35\n";

    #[test]
    fn both_formats_have_the_same_depths() {
        assert_eq!(rows(MOORDYN), rows(MOORPY));
        assert_eq!(rows(MOORPY)[4], [0.0, 5.0, 34.0]);
        assert_eq!(foreign_depths("x_m,y_m,depth_m\n0,0,1\n"), Ok(None));
        assert_eq!(foreign_depths(""), Ok(None));
    }

    #[test]
    fn faults_have_their_place() {
        let fault = |text: &str| {
            let fault = foreign_depths(text).unwrap_err();
            (text.get(fault.span).unwrap().to_owned(), fault.problem)
        };
        let found = fault(&MOORDYN.replace("0 5 -34", "0 5 deep"));
        assert_eq!(
            found,
            ("deep".to_owned(), "`deep` is not a number".to_owned())
        );
        let found = fault(&MOORDYN.replace("0 5 -34", "1 5 -34"));
        assert_eq!(found, ("1".to_owned(), "1 is no place along x".to_owned()));
        let found = fault(&MOORDYN.replace("0 5 -34\n", ""));
        assert_eq!(
            found,
            ("3".to_owned(), "5 rows follow for 3 places by 2".to_owned())
        );
        let found = fault(&MOORDYN.replace("-5 5\n", "-5 5 6\n"));
        assert_eq!(found.1, "3 places along y for a count of 2");
        let found = fault(&MOORPY.replace("31 32", "31"));
        assert_eq!(
            found,
            (
                "-5 30 31".to_owned(),
                "the row has 3 numbers for 3 places".to_owned()
            )
        );
        let found = fault(&MOORPY.replace("nGridY 2", "nGridY 3"));
        assert_eq!(
            found,
            ("3".to_owned(), "2 rows of depths follow".to_owned())
        );
    }
}
