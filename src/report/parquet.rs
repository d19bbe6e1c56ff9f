//! Tables of sweeps as Apache Parquet files, beside their CSV, for programs that read many load cases: a feature of the build.
//!
//! Columns have the names and the order of the CSV, whole numbers as `INT64`, other numbers as `DOUBLE`, to the last bit of what the CSV
//! says, all else as `UTF8`; what a CSV leaves empty is null. Units stand in the names, as there.

use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as Kind};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::Type;

/// A column of a table.
struct ParquetColumn {
    name: String,
    /// Its fields; nothing where they are empty.
    fields: Vec<Option<String>>,
    kind: Kind,
}

/// A table in the text of a CSV file as a Parquet file.
///
/// # Errors
/// A text that is no table, or what the format refuses.
pub fn of_csv(csv: &[u8]) -> Result<Vec<u8>, ParquetError> {
    let columns = columns(csv).map_err(|error| ParquetError::External(Box::new(error)))?;
    let fields: Result<Vec<_>, ParquetError> = columns.iter().map(ParquetColumn::field).collect();
    let schema = Type::group_type_builder("table")
        .with_fields(fields?)
        .build()?;
    let mut file = Vec::new();
    let properties = Arc::new(WriterProperties::builder().build());
    let mut writer = SerializedFileWriter::new(&mut file, Arc::new(schema), properties)?;
    let mut rows = writer.next_row_group()?;
    for column in &columns {
        if let Some(mut out) = rows.next_column()? {
            column.write(&mut out)?;
            out.close()?;
        }
    }
    rows.close()?;
    writer.close()?;
    Ok(file)
}

fn columns(csv: &[u8]) -> Result<Vec<ParquetColumn>, csv::Error> {
    let mut reader = csv::Reader::from_reader(csv);
    let names = reader.headers()?.clone();
    let mut fields = vec![Vec::new(); names.len()];
    for record in reader.records() {
        for (column, field) in fields.iter_mut().zip(&record?) {
            column.push((!field.is_empty()).then(|| field.to_owned()));
        }
    }
    let columns = names
        .iter()
        .zip(fields)
        .map(|(name, fields)| ParquetColumn {
            name: name.to_owned(),
            kind: kind(&fields),
            fields,
        });
    Ok(columns.collect())
}

/// The narrowest kind that holds all fields as they are written.
fn kind(fields: &[Option<String>]) -> Kind {
    let mut given = fields.iter().flatten();
    let is_whole = |field: &String| field.parse::<i64>().is_ok_and(|n| n.to_string() == *field);
    if given.clone().next().is_none() || given.clone().any(|field| field.parse::<f64>().is_err()) {
        Kind::BYTE_ARRAY
    } else if given.all(is_whole) {
        Kind::INT64
    } else {
        Kind::DOUBLE
    }
}

impl ParquetColumn {
    fn field(&self) -> Result<Arc<Type>, ParquetError> {
        let text = (self.kind == Kind::BYTE_ARRAY).then_some(LogicalType::String);
        let field = Type::primitive_type_builder(&self.name, self.kind)
            .with_repetition(Repetition::OPTIONAL)
            .with_logical_type(text);
        field.build().map(Arc::new)
    }

    fn write(&self, out: &mut SerializedColumnWriter<'_>) -> Result<(), ParquetError> {
        let given: Vec<i16> = self
            .fields
            .iter()
            .map(|field| field.is_some().into())
            .collect();
        let fields = self.fields.iter().flatten();
        let levels = Some(given.as_slice());
        match self.kind {
            Kind::INT64 => {
                let values: Vec<i64> = fields.filter_map(|field| field.parse().ok()).collect();
                out.typed::<Int64Type>()
                    .write_batch(&values, levels, None)?;
            }
            Kind::DOUBLE => {
                let values: Vec<f64> = fields.filter_map(|field| field.parse().ok()).collect();
                out.typed::<DoubleType>()
                    .write_batch(&values, levels, None)?;
            }
            _ => {
                let values: Vec<ByteArray> = fields.map(|field| field.as_str().into()).collect();
                out.typed::<ByteArrayType>()
                    .write_batch(&values, levels, None)?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use super::*;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;

    #[test]
    fn a_table_comes_back_to_the_bit() {
        let csv = "load case,height_m,state,tension_n,missing\n1,2.5,done,1234567.8901234567,\n2,,\"failed, twice\",-1e-300,\n3,4,done,0.1,\n";
        let file = of_csv(csv.as_bytes()).unwrap();
        let reader = read(&file);
        let rows: Vec<Vec<Field>> = reader
            .get_row_iter(None)
            .unwrap()
            .map(|row| {
                row.unwrap()
                    .into_columns()
                    .into_iter()
                    .map(|(_, field)| field)
                    .collect()
            })
            .collect();
        let text = |text: &str| Field::Str(text.to_owned());
        let expected = [
            vec![
                Field::Long(1),
                Field::Double(2.5),
                text("done"),
                Field::Double(1_234_567.890_123_456_7),
                Field::Null,
            ],
            vec![
                Field::Long(2),
                Field::Null,
                text("failed, twice"),
                Field::Double(-1e-300),
                Field::Null,
            ],
            vec![
                Field::Long(3),
                Field::Double(4.0),
                text("done"),
                Field::Double(0.1),
                Field::Null,
            ],
        ];
        assert_eq!(rows, expected);
        let names = reader
            .metadata()
            .file_metadata()
            .schema()
            .get_fields()
            .to_vec();
        let names: Vec<&str> = names.iter().map(|field| field.name()).collect();
        assert_eq!(
            names,
            ["load case", "height_m", "state", "tension_n", "missing"]
        );
    }

    #[test]
    fn a_table_without_rows_is_one() {
        let file = of_csv(b"a,b\n").unwrap();
        let reader = read(&file);
        assert_eq!(reader.metadata().file_metadata().num_rows(), 0);
    }

    fn read(content: &[u8]) -> SerializedFileReader<std::fs::File> {
        let mut file = tempfile::tempfile().unwrap();
        file.write_all(content).unwrap();
        SerializedFileReader::new(file).unwrap()
    }
}
