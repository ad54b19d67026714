//! Tables by columns read back by the forms' own readers: every number to the bit, nulls where a position is singular.

use arrow_array::{Array, Float64Array, RecordBatch};
use arrow_ipc::reader::FileReader;
use kinegon::cycle::{Drive, Path, Steps, Sweep};
use kinegon::format::{ColumnFormat, Columns, columns_of};
use kinegon::study::{Column, Content};
use kinegon::{Scene, Solution, solve};
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;

/// A parallelogram: at 0° and 180° its links lie in line and rates are not determined.
const PARALLELOGRAM: &str = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" },
    "ground": { "A": [0, 0], "D": [100, 0] },
    "links": {
        "1": { "points": ["A", "B"], "lengths": { "AB": 40 }, "drive": { "angle": 50, "omega": 1 } },
        "2": { "points": ["B", "C"], "lengths": { "BC": 100 } },
        "3": { "points": ["D", "C"], "lengths": { "DC": 40 } } },
    "near": { "C": [125, 30] } }"#;

/// The table of the parallelogram as (header, rows, batches of both forms).
fn written() -> (Vec<String>, Vec<Option<f64>>, [Vec<RecordBatch>; 2]) {
    let scene = Scene::read(PARALLELOGRAM).expect("a scene");
    let Solution { mechanism, pose, .. } = solve(&scene).expect("it can be solved");
    let drive = Drive::new(&mechanism, None).expect("a drive");
    let mut path = Path::new(&mechanism, &pose, drive).expect("a path");
    path.cover(Some(100.0), Some(260.0)).expect("a range");
    let names = ["omega(3)", "v(C)"].map(String::from);
    let steps = Steps::new(100.0, 260.0, 1.0).expect("steps");
    let sweep = Sweep::new(&path, steps, Some(&names)).expect("quantities");
    let numbers = sweep.rows(0..sweep.steps.count());

    let mut arrow = Columns::new(ColumnFormat::Arrow, &columns_of(&sweep), Vec::new()).expect("memory can be written");
    arrow.rows(&numbers).expect("memory can be written");
    let arrow = std::io::Cursor::new(arrow.finish().expect("memory can be written"));
    let arrow = FileReader::try_new(arrow, None).expect("an Arrow file");

    let mut parquet =
        Columns::new(ColumnFormat::Parquet, &columns_of(&sweep), Vec::new()).expect("memory can be written");
    parquet.rows(&numbers).expect("memory can be written");
    let parquet = parquet.finish().expect("memory can be written");
    let parquet = ParquetRecordBatchReaderBuilder::try_new(bytes::Bytes::from(parquet));
    let parquet = parquet.and_then(|b| b.build()).expect("a Parquet file");

    let batches = [arrow.map(|b| b.expect("a batch")).collect(), parquet.map(|b| b.expect("a batch")).collect()];
    (sweep.header(), numbers, batches)
}

#[test]
fn both_forms_hold_the_table() {
    let (header, numbers, forms) = written();
    assert_eq!(header, ["angle(1)", "omega(3)", "v(C).x", "v(C).y"]);
    let nulls = numbers.iter().filter(|x| x.is_none()).count();
    assert_eq!(nulls, 3, "only the position at 180° is singular");
    for batches in forms {
        let mut read = Vec::new();
        for batch in &batches {
            let names: Vec<String> = batch.schema().fields().iter().map(|f| f.name().clone()).collect();
            assert_eq!(names, header);
            let columns: Vec<&Float64Array> =
                batch.columns().iter().map(|c| c.as_any().downcast_ref().expect("numbers")).collect();
            for row in 0..batch.num_rows() {
                read.extend(columns.iter().map(|c| c.is_valid(row).then(|| c.value(row))));
            }
        }
        assert_eq!(read, numbers);
    }
}

#[test]
fn a_file_says_where_its_rows_come_from() {
    let columns = [Column { name: "omega(3).max".to_owned(), content: Content::Number, unit: "rad/s".to_owned() }];
    let origin =
        [("kinegon.seed", "7"), ("kinegon.version", "0.1.0")].map(|(key, said)| (key.to_owned(), said.to_owned()));
    let written = |format| {
        let mut table = Columns::with_origin(format, &columns, &origin, Vec::new()).expect("memory can be written");
        table.rows(&[1.0, f64::NAN]).expect("memory can be written");
        table.finish().expect("memory can be written")
    };
    let arrow = FileReader::try_new(std::io::Cursor::new(written(ColumnFormat::Arrow)), None).expect("an Arrow file");
    let parquet = ParquetRecordBatchReaderBuilder::try_new(bytes::Bytes::from(written(ColumnFormat::Parquet)));
    let parquet = parquet.expect("a Parquet file");
    let said = parquet.metadata().file_metadata().key_value_metadata().expect("it has some");
    for (key, value) in &origin {
        assert_eq!(arrow.schema().metadata().get(key), Some(value));
        assert_eq!(parquet.schema().metadata().get(key), Some(value));
        // For readers that know nothing of Arrow.
        assert!(said.iter().any(|one| one.key == *key && one.value.as_ref() == Some(value)), "{key}");
    }
}
