//! A ship's responses read from a file, and its motion in a sea made from them.
//!
//! # The file
//! CSV: a line of column names in any order, then a line an entry. `period_s`, then an amplitude and a phase for each degree
//! of freedom: `surge_m_per_m,surge_phase_deg` ... `roll_deg_per_m,roll_phase_deg` ... A phase is the lead over the wave's
//! crest at the ship's reference point. `heading_deg`, which may be left out, is the angle from where the bow points to where
//! the waves run (0 from astern, 180 from ahead), as in the tables of mean drift: one block of periods a heading. Between
//! headings and periods real and imaginary part are linear; headings up to 180 stand for the other side by symmetry.

use std::f64::consts::{PI, TAU};
use std::ops::Range;
use std::path::Path;

use super::DegreeOfFreedom;
use crate::case::carried::{Placed, placed, response_columns};
use crate::case::{Diagnostic, Finding};
use crate::physics::sea::{Component, DEGREES, Rao, Response, Spectrum, synthesise};
use crate::report::number::digits;
use crate::scene::response_entry;
use crate::ship::model::{Motion, SpectrumKind};
use crate::ship::motion::spectral_band::MotionRms;

/// Greatest responses that are taken for a ship's: metres a metre, and degrees a metre.
const MOST: [f64; 2] = [20.0, 90.0];

/// How a ship answers a sea at one angle.
#[derive(Debug, Clone, PartialEq)]
pub struct WaveResponse {
    /// Its responses at this angle.
    pub rao: Rao,
    /// The sea.
    pub spectrum: Spectrum,
    /// From where the bow points to where the waves run \[rad\].
    pub angle: f64,
    /// Where the bow points, from +x towards +y \[rad\].
    pub heading: f64,
    /// Share of the sea's energy at periods beyond those of the file.
    pub beyond: f64,
}

/// Entries of the file at one heading, in radians from the bow; at none where the file tells none.
struct Block {
    heading: Option<f64>,
    rao: Rao,
}

impl WaveResponse {
    /// Reads the file that the words name, from `folder`, for a ship that points along `heading` \[rad\].
    ///
    /// # Errors
    /// What is wrong with the file, with its line and column.
    pub fn read(settings: &Motion, heading: f64, folder: &Path) -> Result<Self, Diagnostic> {
        let path = folder.join(&settings.responses);
        let file = path.display().to_string();
        let text = std::fs::read_to_string(&path).map_err(|error| {
            Diagnostic::whole_file(
                &file,
                format!("the responses cannot be read: {error}"),
                "name a CSV file in motion.responses, from the folder of the ship's file",
            )
        })?;
        let blocks = blocks(&text, &file)?;
        let angle = (settings.waves_towards_deg.to_radians() - heading).rem_euclid(TAU);
        let rao = at_angle(&blocks, angle, &file)?;
        let gamma = match settings.spectrum {
            SpectrumKind::Jonswap => settings.gamma,
            SpectrumKind::PiersonMoskowitz => 1.0,
        };
        let spectrum =
            Spectrum::jonswap(settings.significant_height_m, settings.peak_period_s, gamma);
        let (low, high) = rao.span();
        let outside = |omega: f64| f64::from(u8::from(omega < low || omega > high));
        let [beyond] = spectrum.integrals(|omega| [outside(omega)]);
        Ok(Self {
            rao,
            spectrum,
            angle,
            heading,
            beyond: beyond / spectrum.variance.max(f64::MIN_POSITIVE),
        })
    }

    /// The sea of a seed, as it passes the ship's reference point.
    #[must_use]
    pub fn sea(&self, count: usize, seed: u64) -> Vec<Component> {
        synthesise(&self.spectrum, count, seed, 0)
    }

    /// The six motions in a sea.
    #[must_use]
    pub fn degrees(&self, sea: &[Component]) -> Vec<DegreeOfFreedom> {
        let each: Vec<Response> = sea.iter().map(|c| self.rao.response(c.omega)).collect();
        let degree = |i: usize| {
            let component = |(wave, response): (&Component, &Response)| Component {
                omega: wave.omega,
                amplitude: wave.amplitude * response[i].norm(),
                phase: wave.phase + response[i].arg(),
            };
            DegreeOfFreedom {
                mean: 0.0,
                asked: self.scatter(i),
                bands: Vec::new(),
                components: sea.iter().zip(&each).map(component).collect(),
            }
        };
        (0..6).map(degree).collect()
    }

    /// Root mean squares of a motion in the whole sea, by its spectrum times the square of the response.
    fn scatter(&self, degree: usize) -> MotionRms {
        let [m0, m2, m4] = self.spectrum.integrals(|omega| {
            let square = self.rao.response(omega)[degree].norm_sqr();
            let w2 = omega * omega;
            [square, square * w2, square * w2 * w2]
        });
        MotionRms {
            displacement: m0.sqrt(),
            velocity: m2.sqrt(),
            acceleration: m4.sqrt(),
        }
    }
}

/// The file as blocks of one heading each, by rising heading; one block at no heading where the file has no such column.
fn blocks(text: &str, file: &str) -> Result<Vec<Block>, Diagnostic> {
    let first = text
        .lines()
        .find(|line| !line.trim().is_empty() && !line.trim_start().starts_with('#'));
    let headed = first.is_some_and(|line| line.split(',').any(|c| c.trim() == "heading_deg"));
    let mut columns = vec!["heading_deg".to_owned()];
    columns.extend(response_columns());
    let wanted = &columns[usize::from(!headed)..];
    let mut rows = placed(text, file, wanted)?;
    for row in &mut rows {
        if !headed {
            row.insert(
                0,
                Placed {
                    value: 0.0,
                    span: 0..0,
                },
            );
        }
        fit(row, &columns).map_err(|finding| finding.at(file, text))?;
    }
    if rows.is_empty() {
        return Err(Diagnostic::whole_file(
            file,
            "the table has no entry",
            "give a line for each period",
        ));
    }
    rows.sort_by(|a, b| {
        let key = |r: &[Placed]| (r[0].value, -r[1].value);
        key(a)
            .partial_cmp(&key(b))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    if let Some(pair) = rows
        .windows(2)
        .find(|p| p[0][0].value == p[1][0].value && p[0][1].value == p[1][1].value)
    {
        let span = later(&pair[0][1].span, &pair[1][1].span);
        let finding = Finding::new(
            &span,
            "period_s",
            "the period stands twice",
            "give every period of a heading once",
        );
        return Err(finding.at(file, text));
    }
    let mut made = Vec::new();
    for block in rows.chunk_by(|a, b| a[0].value == b[0].value) {
        let of_row = |row: &Vec<Placed>| {
            let numbers: Vec<f64> = row.iter().skip(1).map(|placed| placed.value).collect();
            response_entry(&numbers)
        };
        let entries = block.iter().map(of_row).collect();
        let rao = Rao::new(entries).map_err(|error| {
            Diagnostic::whole_file(file, error.to_string(), "give periods greater than nought")
        })?;
        made.push(Block {
            heading: headed.then(|| block[0][0].value.to_radians()),
            rao,
        });
    }
    Ok(made)
}

fn later(a: &Range<usize>, b: &Range<usize>) -> Range<usize> {
    if a.start > b.start {
        a.clone()
    } else {
        b.clone()
    }
}

/// What no ship does.
fn fit(row: &[Placed], columns: &[String]) -> Result<(), Finding> {
    let refuse = |i: usize, problem: String, remedy: &str| {
        Err(Finding::new(&row[i].span, &columns[i], problem, remedy))
    };
    if !(0.0..360.0).contains(&row[0].value) {
        let problem = format!("{} is no angle from the bow", digits(row[0].value, 6));
        return refuse(0, problem, "give headings from 0 to below 360 degrees");
    }
    if row[1].value <= 0.0 {
        let problem = format!("a period of {} s is none", digits(row[1].value, 6));
        return refuse(1, problem, "give a period greater than nought");
    }
    for i in 0..6 {
        let at = 2 + 2 * i;
        let size = row[at].value;
        if size < 0.0 {
            let problem = format!("an amplitude of {} is negative", digits(size, 6));
            return refuse(
                at,
                problem,
                "give the amplitude without sign, and turn the phase by 180 degrees",
            );
        }
        if size > MOST[i / 3] {
            let problem = format!(
                "{} moves {} times the wave: no ship does",
                DEGREES[i],
                digits(size, 6)
            );
            return refuse(
                at,
                problem,
                "give metres a metre of wave amplitude, and degrees a metre",
            );
        }
    }
    Ok(())
}

/// The responses at an angle \[rad\] from 0 to a full turn, between the headings of the file.
fn at_angle(blocks: &[Block], angle: f64, file: &str) -> Result<Rao, Diagnostic> {
    let headings: Vec<f64> = blocks.iter().filter_map(|block| block.heading).collect();
    let (Some(first), Some(last)) = (headings.first(), headings.last()) else {
        // No heading is told: the responses are those of the ship as it lies.
        return Ok(blocks[0].rao.clone());
    };
    let half = *last <= PI + 1e-9;
    let (sought, mirrored) = if half && angle > PI {
        (TAU - angle, true)
    } else {
        (angle, false)
    };
    let next = headings.partition_point(|heading| *heading < sought - 1e-9);
    let between = |i: usize, j: usize, to: f64| {
        let share = (sought - headings[i]) / (to - headings[i]);
        blocks[i].rao.between(&blocks[j].rao, share)
    };
    let rao = match headings.get(next) {
        Some(heading) if (heading - sought).abs() <= 1e-9 => blocks[next].rao.clone(),
        Some(heading) if next > 0 => between(next - 1, next, *heading),
        // Around the full turn.
        None if !half && *first == 0.0 => between(next - 1, 0, TAU),
        _ => {
            let problem = format!(
                "the waves run at {} deg from the bow, and the table goes from {} to {} deg",
                digits(sought.to_degrees(), 4),
                digits(first.to_degrees(), 4),
                digits(last.to_degrees(), 4)
            );
            let remedy =
                "give responses for headings on both sides of it: from 0 to 180, or all around";
            return Err(Diagnostic::whole_file(file, problem, remedy));
        }
    };
    Ok(if mirrored { rao.mirrored() } else { rao })
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Complex;

    /// A file of two headings and two periods, with surge 1 m/m and sway of the heading's number.
    fn file(headings: &[f64]) -> String {
        let mut text = format!("heading_deg,{}\n", response_columns().join(","));
        for (n, heading) in headings.iter().enumerate() {
            for period in [5.0, 10.0] {
                text.push_str(&format!("{heading},{period},1,0,{n},90,1,0,0,0,0,0,0,0\n"));
            }
        }
        text
    }

    fn at(text: &str, degrees: f64) -> Result<Rao, String> {
        let blocks = blocks(text, "r.csv").map_err(|d| d.to_string())?;
        at_angle(&blocks, f64::to_radians(degrees), "r.csv").map_err(|d| d.to_string())
    }

    #[test]
    fn between_headings_and_on_the_other_side() {
        let text = file(&[0.0, 90.0, 180.0]);
        let sway = |degrees: f64| at(&text, degrees).unwrap().response(1.0)[1];
        assert!((sway(45.0) - Complex::new(0.0, 0.5)).norm() < 1e-12);
        assert!((sway(180.0) - Complex::new(0.0, 2.0)).norm() < 1e-12);
        // To starboard sway goes the other way.
        assert!((sway(315.0) + Complex::new(0.0, 0.5)).norm() < 1e-12);
        let around = file(&[0.0, 120.0, 240.0]);
        let sway = at(&around, 300.0).unwrap().response(1.0)[1];
        assert!((sway - Complex::new(0.0, 1.0)).norm() < 1e-12);
    }

    #[test]
    fn what_no_ship_does_is_told_with_line_and_column() {
        let good = file(&[0.0, 180.0]);
        let told = |from: &str, to: &str| at(&good.replacen(from, to, 1), 10.0).unwrap_err();
        assert!(
            told("0,5,1,", "0,5,-1,").starts_with("r.csv:2:5"),
            "{}",
            told("0,5,1,", "0,5,-1,")
        );
        assert!(told("180,10,", "180,5,").contains("stands twice"));
        assert!(told("0,10,1,", "0,10,400,").contains("no ship does"));
        assert!(told("0,5,", "0,-5,").contains("is none"));
        assert!(told("0,5,", "400,5,").contains("no angle"));
        assert!(told("0,5,1,", "0,5,").contains("13 values for 14 columns"));
        let aft = file(&[0.0, 60.0]);
        assert!(
            at(&aft, 100.0)
                .unwrap_err()
                .contains("100 deg from the bow")
        );
        assert!(at("", 0.0).unwrap_err().contains("empty"));
        assert!(
            at(&format!("{}\n", response_columns().join(",")), 0.0)
                .unwrap_err()
                .contains("no entry")
        );
    }
}
