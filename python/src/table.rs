use crate::refused::Refused;
use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::{ArrayRef, Float64Array, RecordBatch, RecordBatchIterator, StringArray, UInt64Array};
use arrow_buffer::{Buffer, NullBuffer, ScalarBuffer};
use arrow_schema::{Field, Schema};
use kinegon::format::{csv_header, csv_rows};
use kinegon::study::{Column, Content, Status};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyCapsule, PyDict};
use std::collections::HashMap;
use std::sync::Arc;

/// Bytes from which a table is made only if that is asked for.
const HUGE: usize = 1_000_000_000;

/// A table of f64 in one piece of memory, column after column, which NumPy and Arrow read as it lies there.
#[pyclass(frozen, module = "kinegon._kinegon")]
pub struct Table {
    /// Names of the columns.
    #[pyo3(get)]
    names: Vec<String>,
    /// Their units.
    #[pyo3(get)]
    units: Vec<String>,
    /// How many rows there are.
    #[pyo3(get)]
    rows: usize,
    /// Of a study's table, the column whose numbers are places in [`Status::ALL`]; its first column has whole numbers.
    #[pyo3(get)]
    status: Option<usize>,
    /// The symbols of their quantities in markup; empty where there is none.
    #[pyo3(get)]
    symbols: Vec<String>,
    /// NaN where there is no number.
    data: Buffer,
    notes: Notes,
}

/// What is to be told of the motion of a table.
#[derive(Clone, Default, FromPyObject, IntoPyObject)]
#[pyo3(from_item_all)]
pub struct Notes {
    /// Extreme and change points on the way.
    pub events: Vec<String>,
    /// Limit positions.
    pub limits: Vec<String>,
    /// That a part of the range cannot be reached.
    pub cut: Option<String>,
}

/// The memory of a table without numbers; the hint says how it gets smaller.
pub fn empty(rows: usize, columns: usize, is_huge: bool, hint: &str) -> Result<Vec<f64>, Refused> {
    let bytes = rows.saturating_mul(columns).saturating_mul(size_of::<f64>());
    if bytes > HUGE && !is_huge {
        let message = format!("the table would have {rows} rows and {} GB", bytes.div_ceil(HUGE));
        return Err(Refused::new("KinegonError", message, Some(hint)));
    }
    let mut data: Vec<f64> = Vec::new();
    if data.try_reserve_exact(rows.saturating_mul(columns)).is_err() {
        return Err(Refused::new("KinegonError", "the table does not fit into memory", None));
    }
    data.resize(rows * columns, f64::NAN);
    Ok(data)
}

impl Table {
    /// The table of these columns.
    pub fn of(names: Vec<String>, units: Vec<String>, rows: usize, data: Vec<f64>, notes: Notes) -> Table {
        let symbols = vec![String::new(); names.len()];
        Table { names, units, rows, status: None, symbols, data: Buffer::from_vec(data), notes }
    }

    /// The table of a study whose status is in that column.
    pub fn with_status(self, column: Option<usize>) -> Table {
        Table { status: column, ..self }
    }

    /// The table with symbols for its columns.
    pub fn with_symbols(self, symbols: Vec<String>) -> Table {
        Table { symbols, ..self }
    }

    fn columns(&self) -> Vec<Column> {
        let content = |index: usize| match self.status {
            Some(status) if index == status => Content::Status,
            Some(_) if index == 0 => Content::Index,
            _ => Content::Number,
        };
        let column = |(index, name): (usize, &String)| Column {
            name: name.clone(),
            content: content(index),
            unit: self.units[index].clone(),
        };
        self.names.iter().enumerate().map(column).collect()
    }

    /// A column in the same memory, null where there is no number; whole numbers and words in memory of their own.
    fn column(&self, index: usize) -> ArrayRef {
        let values = ScalarBuffer::<f64>::new(self.data.clone(), index * self.rows, self.rows);
        if self.status == Some(index) {
            let word = |x: &f64| Status::ALL.get(*x as usize).map(|status| status.word());
            return Arc::new(values.iter().map(word).collect::<StringArray>());
        }
        if self.status.is_some() && index == 0 {
            return Arc::new(UInt64Array::from_iter_values(values.iter().map(|x| *x as u64)));
        }
        let is_number: Vec<bool> = values.iter().map(|x| !x.is_nan()).collect();
        let nulls = NullBuffer::from(is_number);
        Arc::new(Float64Array::new(values, Some(nulls).filter(|nulls| nulls.null_count() > 0)))
    }

    fn batch(&self) -> PyResult<RecordBatch> {
        let columns: Vec<ArrayRef> = (0..self.names.len()).map(|index| self.column(index)).collect();
        let field = |((name, unit), column): ((&String, &String), &ArrayRef)| {
            let unit = HashMap::from([("unit".to_owned(), unit.clone())]);
            Field::new(name, column.data_type().clone(), true).with_metadata(unit)
        };
        let fields: Vec<Field> = self.names.iter().zip(&self.units).zip(&columns).map(field).collect();
        RecordBatch::try_new(Arc::new(Schema::new(fields)), columns)
            .map_err(|error| PyValueError::new_err(error.to_string()))
    }
}

#[pymethods]
impl Table {
    /// A table from its bytes, for pickles.
    #[new]
    fn new(
        names: Vec<String>,
        units: Vec<String>,
        rows: usize,
        status: Option<usize>,
        symbols: Vec<String>,
        data: &[u8],
        notes: Notes,
    ) -> PyResult<Table> {
        if symbols.len() != names.len()
            || names.len() != units.len()
            || Some(data.len()) != rows.checked_mul(names.len() * size_of::<f64>())
        {
            return Err(PyValueError::new_err("a table has a name, a unit and a number in each row for each column"));
        }
        let numbers = data.as_chunks::<8>().0.iter().map(|bytes| f64::from_ne_bytes(*bytes)).collect();
        Ok(Table::of(names, units, rows, numbers, notes).with_status(status).with_symbols(symbols))
    }

    /// Its bytes, for pickles.
    fn bytes<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, &self.data)
    }

    /// Rows from `first` to before `last` as CSV, as the program writes them; before the first row the names.
    fn csv(&self, py: Python<'_>, first: usize, last: usize) -> String {
        py.detach(|| {
            let columns = self.columns();
            let data = ScalarBuffer::<f64>::from(self.data.clone());
            let row = |row: usize| (0..columns.len()).map(move |column| column * self.rows + row);
            let numbers: Vec<f64> = (first..last.min(self.rows)).flat_map(row).map(|place| data[place]).collect();
            let head = if first == 0 { csv_header(&columns) } else { String::new() };
            head + &csv_rows(&columns, &numbers)
        })
    }

    /// What is to be told of the motion.
    fn notes(&self) -> Notes {
        self.notes.clone()
    }

    /// Where the numbers lie, for NumPy: rows × columns, read-only.
    #[getter]
    fn __array_interface__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let size = size_of::<f64>();
        let interface = PyDict::new(py);
        interface.set_item("version", 3)?;
        interface.set_item("typestr", if cfg!(target_endian = "little") { "<f8" } else { ">f8" })?;
        interface.set_item("shape", (self.rows, self.names.len()))?;
        interface.set_item("strides", (size, size * self.rows))?;
        interface.set_item("data", (self.data.as_ptr() as usize, true))?;
        Ok(interface)
    }

    /// The table for readers of Arrow, as one batch; no numbers are copied.
    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        // A reader that wants other types casts them itself.
        let _ = requested_schema;
        let batch = self.batch()?;
        let reader = RecordBatchIterator::new([Ok(batch.clone())], batch.schema());
        PyCapsule::new_with_value(py, FFI_ArrowArrayStream::new(Box::new(reader)), c"arrow_array_stream")
    }
}
