use super::figures::{FigureOptions, Figures, GivenStyle, stem};
use super::message::{Failure, warn};
use super::options::{GivenScales, Paper, scale_option};
use super::output::FileSet;
use crate::check::{self, AnswerKey, Checked, Measured};
use crate::construction::Solution;
use crate::drawing::{FigureSheets, overlay};
use crate::sheet::Sheet;
use clap::Args;
use std::path::{Path, PathBuf};

/// The student's drawing over the right figure, to be printed.
#[derive(Debug, Args)]
pub(super) struct Correction {
    /// Also draw it: the student's points and lines over the right figure at the student's scales, the first wrong
    /// steps marked, and a table of the values. Into a folder, or a file whose ending gives the format.
    #[arg(long, value_name = "FOLDER|FILE")]
    draw: Option<PathBuf>,
    #[command(flatten)]
    forms: FigureOptions,
    #[command(flatten)]
    paper: Paper,
    #[command(flatten)]
    scales: GivenScales,
}

impl Correction {
    /// Refuses options of a drawing where none is made: for a folder of forms, or without `--draw`.
    pub(super) fn refuse_drawing_options(&self, is_folder: bool) -> Result<(), Failure> {
        if self.draw.is_some() {
            return match is_folder {
                false => Ok(()),
                true => Err(Failure::misuse("--draw draws one form, here is a folder", "name one of its files")),
            };
        }
        if self.scales.is_given() || self.paper.is_given() || self.forms.style.is_some() {
            let options = Sheet::ALL.map(|sheet| format!("--{}", scale_option(sheet))).join(", ");
            let keys = Sheet::ALL.map(Sheet::scale_key).join(", ");
            return Err(Failure::misuse(
                format!("{options}, --page, --orientation and --style are of a drawing, which is not asked for"),
                format!("add `--draw out/`; the scales of the student's own sheet stand in the form, as {keys}"),
            ));
        }
        Ok(())
    }

    /// Draws the checked values into a set of files if that was asked for. The files of the scene and of the values are not written over.
    pub(super) fn write(
        &self,
        files: &mut FileSet,
        solution: &Solution,
        [scene_file, values_file]: [&Path; 2],
        measured: &Measured,
        key: &AnswerKey<'_>,
        checked: &Checked,
    ) -> Result<(), Failure> {
        let Some(output) = &self.draw else {
            return Ok(());
        };
        if output == Path::new("-") {
            return Err(Failure::misuse(
                "the report is on stdout, so the drawing cannot be there too",
                "name a folder or a file after --draw",
            ));
        }
        let mut solution = solution.clone();
        let figure = &mut solution.scene.figure;
        // Scales: from the options, else from the form, else from the scene.
        measured.put_scales_into(figure);
        let style = GivenStyle::read(self.forms.style.as_deref())?;
        style.put_into(figure);
        self.paper.put_into(figure);
        self.scales.put_into(figure);
        let redrawn = check::redrawn(measured, key, checked, &solution.wording()).map_err(Failure::from)?;
        FigureSheets::new(&solution).overflow_warnings().iter().for_each(|text| warn(text));
        let mut sheets = overlay(&solution, &redrawn);
        style.put_on(&mut sheets);
        let name = format!("{}-check", stem(values_file));
        let names = [name.clone(), format!("{name}-values")]
            .into_iter()
            .chain((2..).map(|number| format!("{name}-values-{number}")));
        let inputs = [("scene", scene_file), ("form", values_file)];
        let drawings = names.zip(sheets.into_iter().map(|sheet| vec![sheet])).collect();
        Figures::at(output, &self.forms).write(files, &inputs, drawings, false, |_| {
            Err(Failure::misuse("a check has no page to step through", "the formats are svg, png, pdf and tikz"))
        })
    }
}
