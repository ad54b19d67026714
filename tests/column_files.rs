//! Arrow and Parquet files of the program hold the numbers of its CSV, to the bit; nulls where that has nothing.

use arrow_array::{Array, Float64Array, RecordBatch};
use arrow_ipc::reader::FileReader;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use std::collections::BTreeMap;
use std::fs::File;
use std::path::Path;
use support::files;
use support::program::{kinegon, scratch, stderr};

/// Runs the program in a folder, which must go well.
fn run(folder: &Path, arguments: &[&str]) {
    let output = kinegon().current_dir(folder).args(arguments).output().expect("the program runs");
    assert_eq!(output.status.code(), Some(0), "{arguments:?}\n{}", stderr(&output));
}

fn batches(file: &Path) -> Vec<RecordBatch> {
    let open = || File::open(file).expect("it was written");
    let is_arrow = file.extension().is_some_and(|ending| ending == "arrow");
    let all: Result<Vec<RecordBatch>, _> = match is_arrow {
        true => FileReader::try_new(open(), None).expect("an Arrow file").collect(),
        false => {
            let reader = ParquetRecordBatchReaderBuilder::try_new(open()).and_then(|builder| builder.build());
            reader.expect("a Parquet file").collect()
        }
    };
    all.expect("all can be read")
}

/// The columns of numbers by their names.
fn numbers(batches: &[RecordBatch]) -> BTreeMap<String, Vec<Option<f64>>> {
    let mut columns: BTreeMap<String, Vec<Option<f64>>> = BTreeMap::new();
    for batch in batches {
        for (field, column) in batch.schema().fields().iter().zip(batch.columns()) {
            if let Some(column) = column.as_any().downcast_ref::<Float64Array>() {
                columns.entry(field.name().clone()).or_default().extend(column.iter());
            }
        }
    }
    columns
}

/// Holds both forms of what a command writes to its CSV; so many columns have numbers.
fn held_to_csv(name: &str, command: &[&str], least: usize) {
    let folder = scratch(&format!("column-files-{name}"));
    for ending in ["csv", "arrow", "parquet"] {
        run(&folder, &[command, &["-o", &format!("table.{ending}")]].concat());
    }
    let mut reader = csv::Reader::from_path(folder.join("table.csv")).expect("it was written");
    let head = reader.headers().expect("a head").clone();
    let rows: Vec<csv::StringRecord> = reader.records().map(|row| row.expect("a row")).collect();
    for ending in ["arrow", "parquet"] {
        let batches = batches(&folder.join(format!("table.{ending}")));
        let names: Vec<String> = batches[0].schema().fields().iter().map(|field| field.name().clone()).collect();
        assert!(names.iter().eq(head.iter()), "{names:?}");
        let columns = numbers(&batches);
        assert!(columns.len() >= least && rows.len() > 100, "{ending}: {:?}", columns.keys());
        for (index, name) in head.iter().enumerate() {
            let Some(column) = columns.get(name) else { continue };
            let expected: Vec<Option<f64>> = rows.iter().map(|row| row[index].parse().ok()).collect();
            assert!(*column == expected, "{name} of table.{ending}");
        }
    }
}

#[test]
fn studies_by_columns_are_those_in_text() {
    let study = files::path("examples/studies/four-bar.json");
    held_to_csv("study", &["study", study.to_str().expect("a plain path")], 7);
}

#[test]
fn tables_by_columns_are_those_in_text() {
    let scene = files::path("examples/figure-2.json");
    held_to_csv("sweep", &["sweep", scene.to_str().expect("a plain path"), "--step", "1"], 20);
}
