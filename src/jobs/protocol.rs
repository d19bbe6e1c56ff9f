//! What a job and a screen say to each other over the socket of the job: a JSON object a line, of one name and its content.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::status::JobStatus;
use crate::run::{DecimatedRecord, LineShape};

/// What a job says.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FromJob {
    /// The first line.
    Hello(Hello),
    /// Where it stands.
    Status(JobStatus),
    /// These channels are recorded; rows that were said before are of no use any more.
    Channels(Vec<String>),
    /// What has been recorded since the last rows, or since the beginning.
    Rows(Rows),
    /// It has ended; the last line.
    Ended(JobStatus),
    /// The screen is of another version, and follows the files of the job instead.
    OtherVersion(u32),
}

/// What a job is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Hello {
    /// Version of what is said.
    pub version: u32,
    /// Version of the program.
    pub program: String,
    /// Number of the job.
    pub job: u64,
}

/// Output times of a run.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Rows {
    /// Times \[s\].
    #[serde(serialize_with = "finite", deserialize_with = "or_nan")]
    pub time: Vec<f64>,
    /// Values of each channel at these times, channel by channel.
    pub values: Vec<Values>,
    /// Shapes of the line.
    pub shapes: Vec<Shape>,
}

/// Values of a channel.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Values(#[serde(serialize_with = "finite", deserialize_with = "or_nan")] pub Vec<f64>);

/// A line at one instant.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Shape {
    /// Time \[s\].
    pub time: f64,
    /// Number of the line.
    #[serde(default)]
    pub line: usize,
    /// Coordinates of the nodes \[m\], node by node.
    pub coordinates: Values,
    /// Tensions at the nodes \[N\].
    pub tension: Values,
}

/// What a screen says.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ToJob {
    /// It listens from now on.
    Follow {
        /// Version of what is said.
        version: u32,
        /// Whether it wants what is recorded, from the beginning.
        rows: bool,
    },
    /// Stop with a checkpoint.
    Cancel,
    /// It listens no more; the job goes on.
    Detach,
}

impl Rows {
    /// What a record holds.
    #[must_use]
    pub fn of_record(record: &DecimatedRecord) -> Self {
        let history = record.history();
        let values = history.channels.iter();
        Self {
            time: history.time.clone(),
            values: values.map(|c| Values(c.values.clone())).collect(),
            shapes: record.shapes().iter().map(Shape::of_line_shape).collect(),
        }
    }
}

impl Shape {
    fn of_line_shape(shape: &LineShape) -> Self {
        Self {
            time: shape.time,
            line: shape.line,
            coordinates: Values(shape.nodes.iter().flatten().copied().collect()),
            tension: Values(shape.tension.clone()),
        }
    }
}

impl From<Shape> for LineShape {
    fn from(shape: Shape) -> Self {
        let coordinates = shape.coordinates.0.chunks_exact(3);
        Self {
            time: shape.time,
            line: shape.line,
            nodes: coordinates
                .map(|node| [node[0], node[1], node[2]])
                .collect(),
            tension: shape.tension.0,
            ..LineShape::default()
        }
    }
}

/// JSON has no word for a number that is not finite: it is absent.
fn finite<S: Serializer>(values: &[f64], to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(
        values
            .iter()
            .map(|value| value.is_finite().then_some(value)),
    )
}

fn or_nan<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<f64>, D::Error> {
    let values = Vec::<Option<f64>>::deserialize(from)?;
    Ok(values.into_iter().map(|v| v.unwrap_or(f64::NAN)).collect())
}

/// A message as a line.
///
/// # Errors
/// It has no text, which is a fault of the program.
pub fn line(message: &impl Serialize) -> std::io::Result<String> {
    let mut text = serde_json::to_string(message)?;
    text.push('\n');
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::ChannelQuantity;
    use crate::status::{JobPhase, VERSION};

    #[test]
    fn a_message_is_a_line_and_read_back_to_the_same_bits() {
        let mut record = DecimatedRecord::new([ChannelQuantity::Tension.at("a|b")]);
        record.row(0.1, &[1.0 / 3.0]);
        record.row(0.2, &[f64::NAN]);
        record.add_shapes(&[LineShape {
            time: 0.2,
            line: 0,
            nodes: vec![[0.0, -1e-300, 2.0], [0.1, 0.2, 0.3]],
            tension: vec![1e5, 2e5],
            ..LineShape::default()
        }]);
        let text = line(&FromJob::Rows(Rows::of_record(&record))).unwrap();
        assert!(text.ends_with('\n') && text.lines().count() == 1);
        assert!(text.contains("null"), "{text}");
        let Ok(FromJob::Rows(rows)) = serde_json::from_str(&text) else {
            panic!("{text}");
        };
        assert_eq!(rows.time, [0.1, 0.2]);
        assert_eq!(rows.values[0].0[0].to_bits(), (1.0_f64 / 3.0).to_bits());
        assert!(rows.values[0].0[1].is_nan());
        assert_eq!(LineShape::from(rows.shapes[0].clone()), record.shapes()[0]);
    }

    #[test]
    fn the_words_of_the_protocol_are_these() {
        let said = |message: &FromJob| line(message).unwrap();
        let hello = Hello {
            version: VERSION,
            program: "0.2.0".to_owned(),
            job: 7,
        };
        assert_eq!(
            said(&FromJob::Hello(hello)),
            "{\"hello\":{\"version\":1,\"program\":\"0.2.0\",\"job\":7}}\n"
        );
        let ended = said(&FromJob::Ended(JobStatus::new(JobPhase::Done)));
        assert!(ended.starts_with("{\"ended\":{\"version\":1,\"phase\":\"done\","));
        let heard: ToJob =
            serde_json::from_str("{\"follow\":{\"version\":1,\"rows\":true}}").unwrap();
        assert_eq!(
            heard,
            ToJob::Follow {
                version: 1,
                rows: true
            }
        );
        assert_eq!(
            serde_json::from_str::<ToJob>("\"cancel\"").unwrap(),
            ToJob::Cancel
        );
    }
}
