//! Files of currents as MoorDyn v2 writes them: by height and time, and over a grid of places and times.
//!
//! ```text
//! current_profile_dynamic.txt         current_profile_4d.txt
//! title                               2 1 2 2               counts of x, y, z and t
//! title                               -50 50                x
//! title                               0                     y
//! title                               -30 0                 z
//! -40 -20 0             z             0 15                  t
//! title                               -50 0 -30 0  1 0 0    x y z t  u v w
//! 0    0 0.2 0.4        t u u u       -50 0 -30 15 2 0 0
//! 10   0 0.4 0.8 0 0 0  t u u u v v v ...
//! ```
//!
//! A row by height and time has the velocities along x at all heights, then those along y, then those upwards; the last ones may be left
//! out and are zero.

use super::attachments::{PlacedNumber, PlacedWord};
use super::diagnostic::Finding;
use super::placed_words::{lines, numbers, whole};

/// Time and place t, x, y, z \[s, m\], and velocity \[m/s\].
pub(super) type CurrentRow = ([PlacedNumber; 4], [PlacedNumber; 3]);

/// How far a place of a row may be from that of its axis, by the size of the numbers: they are written with fewer digits.
const SAME_PLACE: f64 = 1e-9;

/// The line of the heights in a file by height and time, and the first of its rows, from 0.
const HEIGHTS: usize = 4;
const FIRST_ROW: usize = 6;

/// The current of a file in one of these formats.
///
/// # Errors
/// The first fault.
pub(super) fn foreign_current(text: &str) -> Result<Vec<CurrentRow>, Finding> {
    let lines: Vec<Vec<PlacedWord<'_>>> = lines(text).collect();
    let counts = lines.first().map(Vec::as_slice).unwrap_or_default();
    match counts {
        [_, _, _, _] if counts.iter().all(|word| word.0.parse::<usize>().is_ok()) => {
            over_a_grid(&lines, counts)
        }
        _ => by_height(&lines),
    }
}

/// Rows of a time and the velocities at all heights.
fn by_height(lines: &[Vec<PlacedWord<'_>>]) -> Result<Vec<CurrentRow>, Finding> {
    let no_format = "is no table with the columns u_m_per_s and v_m_per_s, and no file of MoorDyn by height and time, or over a grid";
    let heights = lines.get(HEIGHTS).map(Vec::as_slice).unwrap_or_default();
    if lines.len() <= FIRST_ROW || heights.is_empty() {
        let remedy =
            "write heights on line 5, and from line 7 on rows of a time and the velocities there";
        return Err(Finding::new(&(0..0), "", no_format, remedy));
    }
    let heights = rising(numbers(heights)?, "heights")?;
    let n = heights.len();
    let zero = PlacedNumber {
        value: 0.0,
        span: 0..0,
    };
    let mut rows = Vec::new();
    let mut times = Vec::new();
    for line in lines.iter().skip(FIRST_ROW).filter(|line| !line.is_empty()) {
        let given = numbers(line)?;
        let (time, velocities) = match given.split_first() {
            Some((time, velocities)) if velocities.len() >= n => (time, velocities),
            _ => {
                let problem = format!("the row has {} numbers for {n} heights", given.len());
                let remedy = "write the time, then the velocities along x at all heights, along y and upwards";
                return Err(Finding::new(&whole(line), "", problem, remedy));
            }
        };
        // Components that are not there at all heights are left out, as MoorDyn does.
        let of = |component: usize, k: usize| {
            let all = velocities.get(component * n..(component + 1) * n);
            all.map_or_else(|| zero.clone(), |all| all[k].clone())
        };
        for (k, height) in heights.iter().enumerate() {
            rows.push((
                [time.clone(), zero.clone(), zero.clone(), height.clone()],
                [of(0, k), of(1, k), of(2, k)],
            ));
        }
        times.push(time.clone());
    }
    rising(times, "times")?;
    Ok(rows)
}

/// Counts, places and times along the axes, rows of place, time and velocity.
fn over_a_grid(
    lines: &[Vec<PlacedWord<'_>>],
    counts: &[PlacedWord<'_>],
) -> Result<Vec<CurrentRow>, Finding> {
    let axis = |k: usize, name: &str| axis(lines.get(k + 1), &counts[k], name);
    let axes = [axis(0, "x")?, axis(1, "y")?, axis(2, "z")?, axis(3, "t")?];
    let mut rows = Vec::new();
    for line in lines.iter().skip(5).filter(|line| !line.is_empty()) {
        let numbers = numbers(line)?;
        let count = numbers.len();
        let [x, y, z, t, u, v, w] = <[PlacedNumber; 7]>::try_from(numbers).map_err(|_| {
            let problem = format!("the row has {count} numbers");
            Finding::new(
                &whole(line),
                "",
                problem,
                "write x y z t and the velocity u v w",
            )
        })?;
        let at = [
            on_axis(&axes[3], t, "t")?,
            on_axis(&axes[0], x, "x")?,
            on_axis(&axes[1], y, "y")?,
            on_axis(&axes[2], z, "z")?,
        ];
        rows.push((at, [u, v, w]));
    }
    let wanted = axes.iter().map(Vec::len).fold(1, usize::saturating_mul);
    if rows.len() != wanted {
        let sizes = axes.each_ref().map(|axis| axis.len().to_string());
        let problem = format!(
            "{} rows follow for a grid of {}",
            rows.len(),
            sizes.join(" by ")
        );
        let remedy = "write a row x y z t u v w for every place and time, each once";
        return Err(Finding::new(&counts[0].1, "", problem, remedy));
    }
    Ok(rows)
}

/// The places along an axis, as many as its count says, rising.
fn axis(
    line: Option<&Vec<PlacedWord<'_>>>,
    count: &PlacedWord<'_>,
    name: &str,
) -> Result<Vec<PlacedNumber>, Finding> {
    let places = numbers(line.map(Vec::as_slice).unwrap_or_default())?;
    if count.0.parse() != Ok(places.len()) || places.is_empty() {
        let at = line.map_or(count.1.clone(), |line| whole(line));
        let problem = format!(
            "{} values of {name} for a count of {}",
            places.len(),
            count.0
        );
        let remedy = "give as many values as the count says";
        return Err(Finding::new(&at, "", problem, remedy));
    }
    rising(places, &format!("values of {name}"))
}

/// These numbers, which rise.
fn rising(numbers: Vec<PlacedNumber>, what: &str) -> Result<Vec<PlacedNumber>, Finding> {
    let back = numbers
        .windows(2)
        .find(|pair| pair[1].value <= pair[0].value);
    if let Some(pair) = back {
        let problem = format!(
            "the {what} do not rise: {} follows {}",
            pair[1].value, pair[0].value
        );
        let remedy = "give them in rising order, each once";
        return Err(Finding::new(&pair[1].span, "", problem, remedy));
    }
    Ok(numbers)
}

/// The value of an axis that a number of a row means.
fn on_axis(
    axis: &[PlacedNumber],
    given: PlacedNumber,
    name: &str,
) -> Result<PlacedNumber, Finding> {
    let near = |place: &&PlacedNumber| {
        let size = place.value.abs().max(given.value.abs());
        (place.value - given.value).abs() <= SAME_PLACE * size
    };
    let value = axis.iter().find(near).map(|place| place.value);
    let value = value.ok_or_else(|| {
        let problem = format!("{} is no value of {name}", given.value);
        Finding::new(
            &given.span,
            "",
            problem,
            "take one of those of its axis above",
        )
    })?;
    Ok(PlacedNumber { value, ..given })
}

#[cfg(test)]
mod tests {
    use super::*;

    const BY_HEIGHT: &str = "title\n\n\n\n-40 -20 0\n\n0 0 0.2 0.4\n10 0 0.4 0.8 1 2 3\n";
    const GRID: &str = "1 1 2 2\n5\n0\n-30 0\n0 15\n5 0 -30 0 1 2 3\n5.0 0 -30 15 4 5 6\n5 0 -0 0 7 8 9\n5 0 0 15 1 1 1\n";

    fn rows(text: &str) -> Vec<[f64; 7]> {
        let rows = foreign_current(text).unwrap();
        let row = |(at, velocity): &CurrentRow| {
            let mut all = at.iter().chain(velocity);
            [0; 7].map(|_: i32| all.next().unwrap().value)
        };
        rows.iter().map(row).collect()
    }

    #[test]
    fn both_formats_are_read() {
        let found = rows(BY_HEIGHT);
        assert_eq!(found.len(), 6);
        assert_eq!(found[2], [0.0, 0.0, 0.0, 0.0, 0.4, 0.0, 0.0]);
        assert_eq!(found[4], [10.0, 0.0, 0.0, -20.0, 0.4, 2.0, 0.0]);
        let found = rows(GRID);
        assert_eq!(found[1], [15.0, 5.0, 0.0, -30.0, 4.0, 5.0, 6.0]);
        assert_eq!(found[2], [0.0, 5.0, 0.0, 0.0, 7.0, 8.0, 9.0]);
    }

    #[test]
    fn faults_have_their_place() {
        let fault = |text: &str| {
            let fault = foreign_current(text).unwrap_err();
            (text.get(fault.span).unwrap().to_owned(), fault.problem)
        };
        let of = |place: &str, problem: &str| (place.to_owned(), problem.to_owned());
        let found = fault(&BY_HEIGHT.replace("0.4 0.8 1", "0.4 fast 1"));
        assert_eq!(found, of("fast", "`fast` is not a number"));
        let found = fault(&BY_HEIGHT.replace("0 0 0.2 0.4", "0 0 0.2"));
        assert_eq!(found, of("0 0 0.2", "the row has 3 numbers for 3 heights"));
        let found = fault(&BY_HEIGHT.replace("\n10 ", "\n0 "));
        assert_eq!(found, of("0", "the times do not rise: 0 follows 0"));
        let found = fault(&BY_HEIGHT.replace("-40 -20", "-10 -20"));
        assert_eq!(found, of("-20", "the heights do not rise: -20 follows -10"));
        let found = fault(&GRID.replace("-30 0\n0 15\n", "-30 0\n0 15 20\n"));
        assert_eq!(found, of("0 15 20", "3 values of t for a count of 2"));
        let found = fault(&GRID.replace("5 0 -0 0 7 8 9\n", ""));
        assert_eq!(
            found,
            of("1", "3 rows follow for a grid of 1 by 1 by 2 by 2")
        );
        let found = fault(&GRID.replace("5 0 -0 0 7", "5 0 -1 0 7"));
        assert_eq!(found, of("-1", "-1 is no value of z"));
        let found = fault("0 0 0\n");
        assert!(found.1.starts_with("is no table"), "{}", found.1);
    }
}
