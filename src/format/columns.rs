use super::table::status;
use crate::cycle::Sweep;
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

/// A writer of tables by columns of f64, in Apache Arrow's or Parquet's file format; null where there is no number.
pub struct Columns<W: Write + Send> {
    schema: Arc<Schema>,
    output: Output<W>,
}

enum Output<W: Write + Send> {
    Arrow(Box<FileWriter<W>>),
    Parquet(Box<ArrowWriter<W>>),
}

impl<W: Write + Send> Columns<W> {
    /// A table in Arrow's file format.
    ///
    /// # Errors
    /// The head of the file cannot be written.
    pub fn arrow(sweep: &Sweep, out: W) -> Result<Self, ColumnsError> {
        Self::arrow_of(schema(sweep), out)
    }

    fn arrow_of(schema: Arc<Schema>, out: W) -> Result<Self, ColumnsError> {
        let output = Output::Arrow(Box::new(FileWriter::try_new(out, &schema)?));
        Ok(Self { schema, output })
    }

    /// A table in Parquet's file format.
    ///
    /// # Errors
    /// The head of the file cannot be written.
    pub fn parquet(sweep: &Sweep, out: W) -> Result<Self, ColumnsError> {
        Self::parquet_of(schema(sweep), out)
    }

    fn parquet_of(schema: Arc<Schema>, out: W) -> Result<Self, ColumnsError> {
        let output = Output::Parquet(Box::new(ArrowWriter::try_new(out, schema.clone(), None)?));
        Ok(Self { schema, output })
    }

    /// A study's table in Arrow's file format.
    ///
    /// # Errors
    /// The head of the file cannot be written.
    pub fn study_arrow(columns: &[Column], out: W) -> Result<Self, ColumnsError> {
        Self::arrow_of(Arc::new(study_schema(columns)), out)
    }

    /// A study's table in Parquet's file format.
    ///
    /// # Errors
    /// The head of the file cannot be written.
    pub fn study_parquet(columns: &[Column], out: W) -> Result<Self, ColumnsError> {
        Self::parquet_of(Arc::new(study_schema(columns)), out)
    }

    /// Adds rows of a study, as [`Study::rows`](crate::study::Study::rows) gives them.
    ///
    /// # Errors
    /// They cannot be written.
    pub fn study_rows(&mut self, columns: &[Column], numbers: &[f64]) -> Result<(), ColumnsError> {
        self.add(study_arrays(columns, numbers))
    }

    /// Adds rows, as [`Sweep::rows`] gives them.
    ///
    /// # Errors
    /// They cannot be written.
    pub fn rows(&mut self, numbers: &[Option<f64>]) -> Result<(), ColumnsError> {
        let width = self.schema.fields().len();
        let column = |index: usize| -> ArrayRef {
            let values = numbers.iter().skip(index).step_by(width).copied();
            Arc::new(values.collect::<Float64Array>())
        };
        self.add((0..width).map(column).collect())
    }

    fn add(&mut self, arrays: Vec<ArrayRef>) -> Result<(), ColumnsError> {
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

fn schema(sweep: &Sweep) -> Arc<Schema> {
    let field = |name: String| Field::new(name, DataType::Float64, true);
    Arc::new(Schema::new(sweep.header().into_iter().map(field).collect::<Vec<_>>()))
}

/// The columns of a study as Arrow has them.
fn study_schema(columns: &[Column]) -> Schema {
    let field = |column: &Column| {
        let (kind, may_lack) = match column.content {
            Content::Index => (DataType::UInt64, false),
            Content::Status => (DataType::Utf8, false),
            Content::Number => (DataType::Float64, true),
        };
        Field::new(&column.name, kind, may_lack)
    };
    Schema::new(columns.iter().map(field).collect::<Vec<_>>())
}

/// Rows of a study by columns.
fn study_arrays(columns: &[Column], numbers: &[f64]) -> Vec<ArrayRef> {
    let width = columns.len();
    let array = |(index, column): (usize, &Column)| -> ArrayRef {
        let values = numbers.iter().skip(index).step_by(width).copied();
        match column.content {
            Content::Index => Arc::new(values.map(|x| x as u64).collect::<UInt64Array>()),
            Content::Status => Arc::new(values.map(status).map(Some).collect::<StringArray>()),
            Content::Number => Arc::new(values.map(|x| x.is_finite().then_some(x)).collect::<Float64Array>()),
        }
    };
    columns.iter().enumerate().map(array).collect()
}
