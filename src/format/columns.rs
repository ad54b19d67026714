use super::table::status;
use crate::study::{Column, Content};
use arrow_array::{ArrayRef, Float64Array, RecordBatch, StringArray, UInt64Array};
use arrow_ipc::writer::FileWriter;
use arrow_schema::{ArrowError, DataType, Field, Schema};
use parquet::arrow::ArrowWriter;
use parquet::errors::ParquetError;
use std::io::{self, Write};
use std::sync::Arc;

/// Why a table by columns could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ColumnsError {
    /// The output cannot be written to.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// Arrow's writer refuses the table.
    #[error(transparent)]
    Arrow(#[from] ArrowError),
    /// Parquet's writer refuses the table.
    #[error(transparent)]
    Parquet(#[from] ParquetError),
}

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
    pub fn new(format: ColumnFormat, columns: &[Column], out: W) -> Result<Self, ColumnsError> {
        let field = |column: &Column| {
            let (kind, may_lack) = match column.content {
                Content::Index => (DataType::UInt64, false),
                Content::Status => (DataType::Utf8, false),
                Content::Number => (DataType::Float64, true),
            };
            Field::new(&column.name, kind, may_lack)
        };
        let schema = Arc::new(Schema::new(columns.iter().map(field).collect::<Vec<_>>()));
        let output = match format {
            ColumnFormat::Arrow => Output::Arrow(Box::new(FileWriter::try_new(out, &schema)?)),
            ColumnFormat::Parquet => Output::Parquet(Box::new(ArrowWriter::try_new(out, schema.clone(), None)?)),
        };
        Ok(Self { contents: columns.iter().map(|column| column.content).collect(), schema, output })
    }

    /// Adds rows, as [`Sweep::rows`](crate::cycle::Sweep::rows) and [`Study::rows`](crate::study::Study::rows) give them.
    ///
    /// # Errors
    /// They cannot be written.
    pub fn rows<T: Copy + Into<Option<f64>>>(&mut self, numbers: &[T]) -> Result<(), ColumnsError> {
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
        let batch = RecordBatch::try_new(self.schema.clone(), arrays)?;
        match &mut self.output {
            Output::Arrow(writer) => writer.write(&batch)?,
            Output::Parquet(writer) => writer.write(&batch)?,
        }
        Ok(())
    }

    /// Writes the end of the file and returns the output.
    ///
    /// # Errors
    /// The end cannot be written.
    pub fn finish(self) -> Result<W, ColumnsError> {
        match self.output {
            Output::Arrow(mut writer) => {
                writer.finish()?;
                Ok(writer.into_inner()?)
            }
            Output::Parquet(writer) => Ok(writer.into_inner()?),
        }
    }
}
