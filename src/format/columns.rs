use super::table::status;
use crate::study::{Column, Content};
use arrow_array::{ArrayRef, Float64Array, RecordBatch, StringArray, UInt64Array};
use arrow_ipc::writer::FileWriter;
use arrow_schema::{DataType, Field, Schema};
use parquet::arrow::ArrowWriter;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use std::collections::BTreeMap;
use std::io::{Error, Result, Write};
use std::sync::Arc;

/// A file format that holds a table by columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnFormat {
    /// Apache Arrow's file format.
    Arrow,
    /// Apache Parquet.
    Parquet,
}

/// A writer of tables by columns; null where there is no number.
pub struct Columns<W: Write + Send> {
    contents: Vec<Content>,
    schema: Arc<Schema>,
    output: Output<W>,
}

enum Output<W: Write + Send> {
    Arrow(Box<FileWriter<W>>),
    Parquet(Box<ArrowWriter<W>>),
}

impl<W: Write + Send> Columns<W> {
    /// A table with these columns.
    ///
    /// # Errors
    /// The head of the file cannot be written.
    pub fn new(format: ColumnFormat, columns: &[Column], out: W) -> Result<Self> {
        Self::with_origin(format, columns, &[], out)
    }

    /// A table with these columns, in whose metadata stands where it comes from, by keys.
    ///
    /// # Errors
    /// The head of the file cannot be written.
    pub fn with_origin(format: ColumnFormat, columns: &[Column], origin: &[(String, String)], out: W) -> Result<Self> {
        let field = |column: &Column| {
            let (kind, may_lack) = match column.content {
                Content::Index => (DataType::UInt64, false),
                Content::Status => (DataType::Utf8, false),
                Content::Number => (DataType::Float64, true),
            };
            Field::new(&column.name, kind, may_lack)
        };
        let fields: Vec<Field> = columns.iter().map(field).collect();
        let said: BTreeMap<String, String> = origin.iter().cloned().collect();
        let schema = Arc::new(Schema::new(fields).with_metadata(said));
        let output = match format {
            ColumnFormat::Arrow => Output::Arrow(Box::new(FileWriter::try_new(out, &schema).map_err(Error::other)?)),
            ColumnFormat::Parquet => {
                // Readers that know nothing of Arrow find it there.
                let said = origin.iter().map(|(key, said)| KeyValue::new(key.clone(), said.clone())).collect();
                let said = (!origin.is_empty()).then_some(said);
                let properties = WriterProperties::builder().set_key_value_metadata(said).build();
                let writer = ArrowWriter::try_new(out, schema.clone(), Some(properties));
                Output::Parquet(Box::new(writer.map_err(Error::other)?))
            }
        };
        Ok(Self { contents: columns.iter().map(|column| column.content).collect(), schema, output })
    }

    /// Adds rows, as [`Sweep::rows`](crate::cycle::Sweep::rows) and [`Study::rows`](crate::study::Study::rows) give them.
    ///
    /// # Errors
    /// They cannot be written.
    pub fn rows<T: Copy + Into<Option<f64>>>(&mut self, numbers: &[T]) -> Result<()> {
        let array = |(index, content): (usize, &Content)| -> ArrayRef {
            let values = numbers.iter().skip(index).step_by(self.contents.len());
            let values = values.map(|&number| number.into().filter(|x: &f64| x.is_finite()));
            match content {
                Content::Index => Arc::new(values.map(|x| x.map(|x| x as u64)).collect::<UInt64Array>()),
                Content::Status => Arc::new(values.map(|x| x.map(status)).collect::<StringArray>()),
                Content::Number => Arc::new(values.collect::<Float64Array>()),
            }
        };
        let arrays = self.contents.iter().enumerate().map(array).collect();
        let batch = RecordBatch::try_new(self.schema.clone(), arrays).map_err(Error::other)?;
        match &mut self.output {
            Output::Arrow(writer) => writer.write(&batch).map_err(Error::other),
            Output::Parquet(writer) => writer.write(&batch).map_err(Error::other),
        }
    }

    /// Writes the end of the file and returns the output.
    ///
    /// # Errors
    /// The end cannot be written.
    pub fn finish(self) -> Result<W> {
        match self.output {
            Output::Arrow(mut writer) => writer.finish().and_then(|()| writer.into_inner()).map_err(Error::other),
            Output::Parquet(writer) => writer.into_inner().map_err(Error::other),
        }
    }
}
