use crate::cycle::Sweep;
use arrow_array::{ArrayRef, Float64Array, RecordBatch};
use arrow_ipc::writer::FileWriter;
use arrow_schema::{ArrowError, DataType, Field, Schema};
use parquet::arrow::ArrowWriter;
use parquet::errors::ParquetError;
use std::io::{self, Write};
use std::sync::Arc;

/// Why a table by columns could not be written.
#[derive(Debug, thiserror::Error)]
pub enum ColumnsError {
    /// The place that it goes to does not take it.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The form does not allow it.
    #[error(transparent)]
    Arrow(#[from] ArrowError),
    /// The form does not allow it.
    #[error(transparent)]
    Parquet(#[from] ParquetError),
}

/// A table written by columns of f64, in Apache Arrow's or Parquet's file format; null where there is no number.
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
    /// The beginning cannot be written.
    pub fn arrow(sweep: &Sweep, out: W) -> Result<Self, ColumnsError> {
        let schema = schema(sweep);
        let output = Output::Arrow(Box::new(FileWriter::try_new(out, &schema)?));
        Ok(Self { schema, output })
    }

    /// A table in Parquet's file format.
    ///
    /// # Errors
    /// The beginning cannot be written.
    pub fn parquet(sweep: &Sweep, out: W) -> Result<Self, ColumnsError> {
        let schema = schema(sweep);
        let output = Output::Parquet(Box::new(ArrowWriter::try_new(out, schema.clone(), None)?));
        Ok(Self { schema, output })
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
        let batch = RecordBatch::try_new(self.schema.clone(), (0..width).map(column).collect())?;
        match &mut self.output {
            Output::Arrow(writer) => writer.write(&batch)?,
            Output::Parquet(writer) => writer.write(&batch)?,
        }
        Ok(())
    }

    /// Writes the end, and gives back what was written to.
    ///
    /// # Errors
    /// It cannot be written.
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
