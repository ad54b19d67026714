//! The table of a study; what is kept of it until all rows are there is in `parts.rs`.

use super::files;
use super::message::{Failure, Source, note, refuse};
use super::output::{FileSet, is_stream};
use super::parts::{Parts, ROWS, Use, folder};
use super::pieces::progress;
use super::table::{TableFormat, TableWriter};
use super::tables::put_tables;
use crate::format;
use crate::scene::Scene;
use crate::study::{Column, Content, SceneGiven, Status, Study, StudyError, StudyFile};
use clap::Args;
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Rows that the progress bar counts as one.
const STEP: u64 = 512;

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
        if self.format == Some(TableFormat::Jsonl) {
            return refuse("a study's table is not written as JSON lines", "--format csv");
        }
        let is_taken = |format| format != TableFormat::Jsonl;
        let format = TableFormat::of(self.format, &self.output, "a study's table", is_taken)?;
        let source = files::read_text("study", &self.study)?;
        let file = source.checked(StudyFile::read(&source.text))?;
        let (scene_source, scene) = self.scene(&source, &file)?;
        let study = file.of(scene).map_err(|error| match error {
            StudyError::Study(_) => source.fail(error),
            of_scene => scene_source.fail(of_scene),
        })?;
        if self.count {
            return files::print(format!("{}\n", study.count()).as_bytes());
        }
        files::refuse_overwriting("study", &self.study, &self.output)?;
        if let SceneGiven::Path(_) = file.scene() {
            files::refuse_overwriting("scene", Path::new(&scene_source.name), &self.output)?;
        }
        let count = study.count();
        let rows = self.rows.clone().unwrap_or(0..count);
        if rows.end > count {
            return refuse(format!("the study has {count} rows"), format!("rows from 0..{count}"));
        }
        let origin = file.origin(&scene_source.text);
        let table = Table { study: &study, columns: study.columns(), format, place: &self.output, origin };
        if self.parts && is_stream(&self.output) {
            return refuse("parts belong to a file, and none is named", "name the file: -o results.csv");
        }
        if !self.parts && (is_stream(&self.output) || rows.end - rows.start <= ROWS) && !folder(&self.output).is_dir() {
            let blocks: Vec<Range<u64>> = Parts::blocks(&rows).collect();
            return table.write(|put| table.compute(&blocks, |_, numbers| put(numbers)));
        }
        let text = format!("{}\n{}\n{}", env!("CARGO_PKG_VERSION"), source.text, scene_source.text);
        let all = if self.parts { 0..count } else { rows.clone() };
        let shared = if self.parts { Use::Some } else { Use::All };
        let parts = Parts::open(&self.output, &text, &all, table.columns.len(), shared)?;
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
        table.write(|put| blocks.iter().try_for_each(|block| put(&parts.read(block)?).map(drop)))?;
        parts.remove();
        Ok(())
    }

    /// The scene of a study: from its file, whose path is from the study's folder, or from the study itself.
    fn scene(&self, source: &Source, file: &StudyFile) -> Result<(Source, Scene), Failure> {
        let of = match file.scene() {
            SceneGiven::Path(path) => {
                let folder = self.study.parent().filter(|_| self.study != Path::new("-")).unwrap_or(Path::new(""));
                let path = folder.join(path);
                let name = path.display().to_string();
                let bytes = files::read_unnamed(&path, None, files::MOST).map_err(|why| {
                    let message = format!("{name}, which the study names as its scene, {why}");
                    Failure::misuse(message, "write the path of a scene file, from the study's folder")
                })?;
                let of = put_tables(files::utf8("scene", name, bytes)?, &path)?;
                if Scene::read(&of.text).is_err() && !files::is_below(&path, folder) {
                    // Somebody else's study may name any file: what stands in it is not shown.
                    let hint = format!("`kinegon structure {}` says what is wrong with it", of.name);
                    return refuse(format!("{}, which the study names as its scene, is none", of.name), hint);
                }
                of
            }
            SceneGiven::Inline(text) => Source::new(source.name.clone(), text),
        };
        let scene = Scene::read(&of.text);
        // The lines that a message shows are those of the study.
        let shown = if of.name == source.name { source } else { &of };
        let scene = shown.checked(scene)?;
        Ok((of, scene))
    }
}

/// The table of a study's rows.
struct Table<'a> {
    study: &'a Study,
    columns: Vec<Column>,
    format: TableFormat,
    place: &'a Path,
    origin: Vec<(String, String)>,
}

impl Table<'_> {
    /// Computes blocks of rows on all cores and passes them to `put` in order, until that returns false.
    fn compute(
        &self,
        blocks: &[Range<u64>],
        mut put: impl FnMut(&Range<u64>, &[f64]) -> Result<bool, Failure>,
    ) -> Result<(), Failure> {
        let steps = |block: &Range<u64>| (block.end - block.start).div_ceil(STEP);
        let all = blocks.iter().map(steps).sum();
        let bar = progress(all, (all > 1).then_some("times 512 rows"));
        for block in blocks {
            if !put(block, &self.study.rows_on_all_cores(block.clone()))? {
                return Ok(());
            }
            bar.inc(steps(block));
        }
        bar.finish_and_clear();
        Ok(())
    }

    /// Writes the table of the blocks of rows that `hand_over` passes on, until nobody reads stdout; says what became of the
    /// mechanisms.
    fn write(
        &self,
        hand_over: impl FnOnce(&mut dyn FnMut(&[f64]) -> Result<bool, Failure>) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let columns = &self.columns;
        let status = columns.iter().position(|column| column.content == Content::Status).unwrap_or_default();
        let mut tally: BTreeMap<usize, u64> = BTreeMap::new();
        let mut files = FileSet::default();
        let Some(mut table) = TableWriter::begin(&mut files, self.place, self.format, columns, &self.origin)? else {
            return Ok(());
        };
        hand_over(&mut |numbers| {
            numbers.chunks_exact(columns.len()).for_each(|row| *tally.entry(row[status] as usize).or_default() += 1);
            table.put(numbers, || format::csv_rows(columns, numbers))
        })?;
        table.end()?;
        files.finish()?;
        let told = tally.iter().filter_map(|(status, count)| Some((Status::ALL.get(*status)?.word(), count)));
        let told: Vec<String> = told.map(|(word, count)| format!("{count} {word}")).collect();
        note(&format!("mechanisms: {}", told.join(", ")));
        Ok(())
    }
}
