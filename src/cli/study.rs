use super::files;
use super::message::{Failure, Source, note};
use super::output::FileSet;
use super::parts::{Parts, ROWS};
use super::pieces::{Output, Pieces};
use super::table::TableFormat;
use crate::format;
use crate::scene::Scene;
use crate::study::{Column, Content, SceneGiven, Status, Study, StudyError, StudyFile};
use clap::Args;
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Rows that a core computes at a time.
const CHUNK: u64 = 512;

const AFTER_HELP: &str = "\
A study is a file as
  { \"kinegon_study\": 1, \"scene\": \"four-bar.json\",
    \"vary\": { \"2.BC\": { \"from\": 130, \"to\": 150, \"count\": 9 }, \"3.CD\": { \"plus_minus\": 0.5 } }, \"count\": 1000, \"seed\": 7,
    \"cycle\": { \"from\": 0, \"to\": 360, \"step\": 5 },
    \"want\": { \"omega(3)\": [\"max\", \"min\"], \"alpha(3)\": [\"max_abs\"] } }
The table has a row for each mechanism. A row hangs on the study and its own index alone, so any rows may be computed anywhere.
What is done is kept in FILE.parts: a run that was stopped goes on from there when it is started again, and comes to the same bytes.

Examples:
  kinegon study study.json -o all.csv                     all rows, on all cores
  kinegon study study.json -o some.csv --rows 0..1000     some rows, in a file
  kinegon study study.json -o all.csv --rows 0..9000 --parts   for one of many
  kinegon study study.json -o all.csv                     the missing, and joins
  kinegon schema study                                    what a study may say";

/// Compute many mechanisms that differ from one scene in some numbers: a row of figures over the cycle for each.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct StudyCommand {
    /// Study file, `-` for stdin.
    study: PathBuf,
    /// File to write, or `-` for stdout.
    #[arg(short, long, value_name = "FILE", default_value = "-")]
    output: PathBuf,
    /// Form of the table; without it that of the file's ending, else CSV.
    #[arg(long, value_enum)]
    format: Option<TableFormat>,
    /// These rows only, the first and the one after the last, as 0..1000.
    #[arg(long, value_name = "A..B", value_parser = rows)]
    rows: Option<Range<u64>>,
    /// Leave the rows in FILE.parts for a run that joins them. Rows are kept in parts of 4096: those that begin in --rows are computed.
    #[arg(long)]
    parts: bool,
    /// Print how many rows the study has, and compute none.
    #[arg(long, conflicts_with_all = ["rows", "parts", "output"])]
    count: bool,
}

/// The rows of an argument as `0..1000`.
fn rows(text: &str) -> Result<Range<u64>, String> {
    let ends = text.split_once("..").and_then(|(from, to)| Some(from.parse().ok()?..to.parse().ok()?));
    ends.filter(|rows: &Range<u64>| rows.start < rows.end)
        .ok_or_else(|| "not rows as 0..1000, from less to more".to_owned())
}

impl StudyCommand {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let format = self.table_format()?;
        let source = files::read_text("study", &self.study)?;
        let file = StudyFile::read(&source.text).map_err(|error| source.fail(error))?;
        let (scene_source, scene) = self.scene(&source, &file)?;
        let study = file.of(scene).map_err(|error| self.about(error, &source, &scene_source))?;
        if self.count {
            return files::print(format!("{}\n", study.count()).as_bytes());
        }
        files::refuse_overwriting("study", &self.study, &self.output)?;
        if let SceneGiven::Path(_) = file.scene() {
            files::refuse_overwriting("scene", Path::new(&scene_source.name), &self.output)?;
        }
        let rows = self.wanted_rows(&study)?;
        let table = Table { study: &study, columns: study.columns(), format, place: &self.output };
        let in_file = self.output != Path::new("-") && !super::output::is_special(&self.output);
        if self.parts && !in_file {
            let hint = "name the file: -o results.csv".to_owned();
            return Err(Failure::misuse("parts belong to a file, and none is named", hint));
        }
        if !self.parts && (!in_file || rows.end - rows.start <= ROWS) && !Parts::are_there(&self.output) {
            return table.write_at_once(rows);
        }
        let text = format!("{}\n{}\n{}", env!("CARGO_PKG_VERSION"), source.text, scene_source.text);
        let all = if self.parts { 0..study.count() } else { rows.clone() };
        let parts = Parts::open(&self.output, &text, &all, table.columns.len())?;
        let blocks: Vec<Range<u64>> = Parts::blocks(&all).filter(|b| !self.parts || rows.contains(&b.start)).collect();
        let missing: Vec<Range<u64>> = blocks.iter().filter(|block| !parts.has(block)).cloned().collect();
        if missing.len() < blocks.len() {
            let done = blocks.len() - missing.len();
            note(&format!("{done} of {} parts are there already", blocks.len()));
        }
        table.compute(&missing, |block, numbers| parts.write(block, numbers).map(|()| true))?;
        if self.parts {
            return Ok(());
        }
        table.join(&parts, &blocks)?;
        parts.remove();
        Ok(())
    }

    /// The scene of a study: from its file, whose path is from the study's folder, or from the study itself.
    fn scene(&self, source: &Source, file: &StudyFile) -> Result<(Source, Scene), Failure> {
        let of = match file.scene() {
            SceneGiven::Path(path) => {
                let folder = self.study.parent().filter(|_| self.study != Path::new("-")).unwrap_or(Path::new(""));
                files::read(&folder.join(path))?
            }
            SceneGiven::Inline(text) => Source { name: source.name.clone(), text },
        };
        let scene = Scene::read(&of.text);
        // The lines that a message shows are those of the study.
        let shown = if of.name == source.name { source } else { &of };
        let scene = scene.map_err(|error| shown.fail(error))?;
        Ok((of, scene))
    }

    /// An error about the study, or about its scene.
    fn about(&self, error: StudyError, study: &Source, scene: &Source) -> Failure {
        match error {
            StudyError::Study(_) => study.fail(error),
            other => scene.fail(other),
        }
    }

    fn wanted_rows(&self, study: &Study) -> Result<Range<u64>, Failure> {
        let count = study.count();
        match &self.rows {
            None => Ok(0..count),
            Some(rows) if rows.end <= count => Ok(rows.clone()),
            Some(_) => Err(Failure::misuse(format!("the study has {count} rows"), format!("rows from 0..{count}"))),
        }
    }

    fn table_format(&self) -> Result<TableFormat, Failure> {
        let ending = self.output.extension().and_then(|e| e.to_str());
        let format = self.format.or_else(|| TableFormat::of_ending(ending.unwrap_or("csv")));
        match format {
            Some(TableFormat::Jsonl) if self.format.is_some() => {
                Err(Failure::misuse("a study's table is not written as JSON lines", "--format csv"))
            }
            Some(TableFormat::Jsonl) | None => Err(Failure::misuse(
                format!("no form of a study's table for files ending in `.{}`", ending.unwrap_or_default()),
                TableFormat::hint(ending, |format| format != TableFormat::Jsonl),
            )),
            Some(format) => Ok(format),
        }
    }
}

/// The table of a study's rows.
struct Table<'a> {
    study: &'a Study,
    columns: Vec<Column>,
    format: TableFormat,
    place: &'a Path,
}

impl Table<'_> {
    /// Computes blocks of rows on all cores and passes them to `put` in order, until that returns false.
    fn compute(
        &self,
        blocks: &[Range<u64>],
        mut put: impl FnMut(&Range<u64>, &[f64]) -> Result<bool, Failure>,
    ) -> Result<(), Failure> {
        let chunks = |block: &Range<u64>| {
            let end = block.end;
            (block.start..end).step_by(CHUNK as usize).map(move |first| first..end.min(first + CHUNK))
        };
        let chunks: Vec<Range<u64>> = blocks.iter().flat_map(chunks).collect();
        let unit = (chunks.len() > 1).then_some("times 512 rows");
        let pieces = Pieces { count: chunks.len(), size: 1, per_core: 4, unit };
        let mut blocks = blocks.iter();
        let (mut block, mut numbers) = (blocks.next(), Vec::new());
        pieces.each(
            |piece| (chunks[piece.start].end, self.study.rows(chunks[piece.start].clone())),
            |(end, rows): (u64, Vec<f64>)| {
                numbers.extend(rows);
                let Some(whole) = block.filter(|block| block.end == end) else {
                    return Ok(true);
                };
                block = blocks.next();
                put(whole, &std::mem::take(&mut numbers))
            },
        )
    }

    /// Computes and writes rows without parts.
    fn write_at_once(&self, rows: Range<u64>) -> Result<(), Failure> {
        let mut files = FileSet::default();
        let Some(mut writer) = Writer::new(self, &mut files)? else {
            return Ok(());
        };
        let blocks: Vec<Range<u64>> = Parts::blocks(&rows).collect();
        self.compute(&blocks, |_, numbers| writer.block(numbers))?;
        writer.end(files)
    }

    /// Writes the rows of all parts.
    fn join(&self, parts: &Parts, blocks: &[Range<u64>]) -> Result<(), Failure> {
        let mut files = FileSet::default();
        let Some(mut writer) = Writer::new(self, &mut files)? else {
            return Ok(());
        };
        for block in blocks {
            writer.block(&parts.read(block)?)?;
        }
        writer.end(files)
    }
}

/// A table that is written block by block.
struct Writer<'a> {
    table: &'a Table<'a>,
    form: Form,
    /// How many mechanisms there are of each status.
    tally: BTreeMap<usize, u64>,
}

enum Form {
    Text(Output),
    #[cfg(feature = "arrow")]
    Columns(format::Columns<Output>),
}

#[cfg(feature = "arrow")]
impl Form {
    fn columns(form: format::ColumnFormat, table: &Table, out: Output) -> Result<Form, Failure> {
        format::Columns::new(form, &table.columns, out).map(Form::Columns).map_err(|error| table.unwritable(error))
    }
}

impl<'a> Writer<'a> {
    /// The head of the table; `None` if nobody reads stdout.
    fn new(table: &'a Table, files: &mut FileSet) -> Result<Option<Self>, Failure> {
        let mut out = Output::new(files, table.place)?;
        let form = match table.format {
            #[cfg(feature = "arrow")]
            TableFormat::Parquet => Form::columns(format::ColumnFormat::Parquet, table, out)?,
            #[cfg(feature = "arrow")]
            TableFormat::Arrow => Form::columns(format::ColumnFormat::Arrow, table, out)?,
            TableFormat::Csv | TableFormat::Jsonl => {
                if !out.put(&format::csv_header(&table.columns))? {
                    return Ok(None);
                }
                Form::Text(out)
            }
        };
        Ok(Some(Writer { table, form, tally: BTreeMap::new() }))
    }

    /// Adds rows; false if nobody reads on.
    fn block(&mut self, numbers: &[f64]) -> Result<bool, Failure> {
        let columns = &self.table.columns;
        let status = columns.iter().position(|column| column.content == Content::Status).unwrap_or_default();
        for row in numbers.chunks_exact(columns.len()) {
            *self.tally.entry(row[status] as usize).or_default() += 1;
        }
        match &mut self.form {
            Form::Text(out) => out.put(&format::csv_rows(columns, numbers)),
            #[cfg(feature = "arrow")]
            Form::Columns(out) => out.rows(numbers).map(|()| true).map_err(|error| self.table.unwritable(error)),
        }
    }

    /// Puts the table into its place and says what became of the mechanisms.
    fn end(self, files: FileSet) -> Result<(), Failure> {
        match self.form {
            Form::Text(out) => out.end()?,
            #[cfg(feature = "arrow")]
            Form::Columns(out) => out.finish().map_err(|error| self.table.unwritable(error))?.end()?,
        }
        files.finish()?;
        let told = self.tally.iter().filter_map(|(status, count)| Some((Status::ALL.get(*status)?.word(), count)));
        let told: Vec<String> = told.map(|(word, count)| format!("{count} {word}")).collect();
        note(&format!("mechanisms: {}", told.join(", ")));
        Ok(())
    }
}

#[cfg(feature = "arrow")]
impl Table<'_> {
    fn unwritable(&self, error: format::ColumnsError) -> Failure {
        match error {
            format::ColumnsError::Io(error) => files::unwritable(self.place, &error),
            other => Failure::outside(format!("{} cannot be written: {other}", self.place.display())),
        }
    }
}
