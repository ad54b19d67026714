use super::centers::{CenterOptions, PoleOptions, check_figure};
use super::cycle::{refuse_nothing, split_names};
use super::figures::{Figures, Made, OfScene, Sheets, stem};
use super::files;
use super::film::FilmOptions;
use super::message::{Failure, Source, note, refuse, warn};
use super::options::{Look, Markers, one_of};
use super::output::FileSet;
use super::solve::{Mode, show_warnings, solve};
use super::style::GivenStyle;
use crate::construction::{NumberedStep, Solution};
use crate::cycle::Traces;
use crate::drawing::{Drawing, FigureSheets, Steps};
use crate::editing::{with_figure, with_mode};
use crate::format::{OpenScene, workbench};
use crate::order_of_figure;
use crate::scene::{Figure, LengthUnit, Scene, SizeLimit, StyleName, ValuesShown};
use crate::sheet::{Order, Sheet};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// The scenes of figures 1 and 2 of Quintero et al. (2011), drawn if no scene is named.
const PAPER: [(&str, &str); 2] = [
    ("figure-1", include_str!("../../examples/figure-1.json")),
    ("figure-2", include_str!("../../examples/figure-2.json")),
];

/// A sheet to be worked on with ruler and pencil.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum WorkSheet {
    /// With all plans and the lengths measured in them.
    Filled,
    /// With the scheme and with empty panels for the plans.
    Blank,
}

const AFTER_HELP: &str = "\
Examples:
  kinegon draw scene.json                       to out/, as SVG and PNG
  kinegon draw scene.json -o figure.pdf         one file; or .svg .tex .html
  kinegon draw scene.json -o film.gif           a turn of the drive; or .apng
  kinegon draw scene.json --steps -o lesson/    a sheet for each step
  kinegon draw scene.json --values=m -o v.svg   with values, in m/s and m/s²
  kinegon draw scene.json --centers=all -o c.pdf  with all instant centres
  kinegon draw scene.json --worksheet -o w.pdf  to measure on, with a table
  kinegon draw scene.json --worksheet=blank -o b.pdf  sheets for the plans
  kinegon draw scene.json --page 16x9 --style lecture -o hall.pdf";

#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct Draw {
    /// Scene file, `-` for stdin; without one the two figures of Quintero et al. (2011).
    scene: Option<PathBuf>,
    /// Write a sheet for each step of the construction: figure-01, figure-02 … `coarse` joins the steps that a lecturer
    /// shows together.
    #[arg(long, value_name = "fine|coarse", num_args = 0..=1, default_missing_value = "fine",
        conflicts_with_all = ["upto", "layered"])]
    steps: Option<String>,
    /// Write the sheet as it stands after this step alone.
    #[arg(long, value_name = "N", conflicts_with = "layered")]
    upto: Option<usize>,
    /// Write one SVG whose groups `step-01`, `step-02` … a slide program can reveal one after another.
    #[arg(long)]
    layered: bool,
    /// Draw a work sheet: the figure with a table of all measured lengths and a ruler that shows whether it was printed
    /// at 100 %. A table without room beside the panels goes on a second sheet, figure-2. `blank` draws what a student
    /// gets: the scheme with what is given, and sheets with the poles of the plans.
    #[arg(long, value_name = "filled|blank", num_args = 0..=1, require_equals = true, default_missing_value = "filled",
        value_enum, hide_possible_values = true)]
    worksheet: Option<WorkSheet>,
    /// Put Willis' table of the trains of wheels beside the panels.
    #[arg(long)]
    willis: bool,
    /// Draw the paths of these points over the whole cycle of the drive, as "F, M", in place of those that the scene's
    /// figure names.
    #[arg(long, value_name = "POINTS")]
    trace: Vec<String>,
    /// Let the paths go on beyond limits of the drive, dashed, in other assembly modes.
    #[arg(long)]
    beyond_limits: bool,
    /// Draw the links pale in N equally spaced positions over that cycle.
    #[arg(long, value_name = "N")]
    ghosts: Option<u16>,
    #[command(flatten)]
    poles: PoleOptions,
    #[command(flatten)]
    centers: CenterOptions,
    /// Show values at vectors, links and lengths; velocities and accelerations with this unit of length, as `m` for m/s.
    #[arg(long, value_name = "UNIT", num_args = 0..=1, require_equals = true, default_missing_value = "own", value_parser = values())]
    values: Option<ValuesShown>,
    /// The panel that takes most of the sheet; a plan has the scheme as a small companion.
    #[arg(long, value_name = "PANEL", value_parser = one_of(&Sheet::ALL, Sheet::as_str))]
    focus: Option<Sheet>,
    // A page was once a film of so many positions of one drive; it now moves all drives to any position.
    #[arg(long, value_name = "N", hide = true)]
    positions: Option<String>,
    /// Write the sheets of steps, a film's pictures, points or pixels even if they are very many.
    #[arg(long)]
    pub(super) yes: bool,
    #[command(flatten)]
    film: FilmOptions,
    #[command(flatten)]
    pub(super) figures: Figures,
    #[command(flatten)]
    look: Look,
    #[command(flatten)]
    markers: Markers,
    #[command(flatten)]
    mode: Mode,
}

impl Draw {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let (scene, steps) = self.scene_and_steps()?;
        let scenes = match &scene {
            Some(path) => vec![(stem(path), files::read(path)?)],
            None => {
                let source = |name: &str, text: &str| Source::new(format!("{name}.json"), text.to_owned());
                PAPER.map(|(name, text)| (name.to_owned(), source(name, text))).to_vec()
            }
        };
        let style = self.figures.style()?;
        if self.is_blank() {
            self.check_blank()?;
        }
        let is_moved = self.figures.has_page() || self.figures.has_film();
        let is_stepwise = steps.is_some() || self.layered || is_moved;
        if self.figures.has_page() {
            self.check_page(&style)?;
        }
        if self.figures.has_film() {
            self.check_film()?;
        }
        let most = if is_stepwise { SizeLimit::STEPS } else { SizeLimit::FIGURE };
        let (mut drawings, mut solved) = (Vec::new(), Vec::new());
        for (name, source) in scenes {
            let solution = solve(&source, most, self.mode.number, |f| self.put_into(f, &style), order_of_figure)?;
            self.check_shown(&solution.scene)?;
            #[cfg(feature = "png")]
            self.refuse_large(&solution.scene.figure)?;
            self.refuse_crowded(solution.mechanism.points.len())?;
            let traces = source.checked(Traces::new(&solution, None))?;
            let figure = &solution.scene.figure;
            if !figure.beyond_limits && traces.times.as_ref().is_some_and(|times| times.is_stopped) {
                note("the paths end where limits stop the drive; --beyond-limits draws the rest of the curves, dashed");
            }
            show_warnings(&solution);
            drawings.extend(match self.figures.is_film() {
                true => vec![(name, Made::Sheets(Vec::new()))],
                false => self.sheets(name, &solution, traces, steps, &style)?,
            });
            solved.push((source, solution));
        }
        let inputs: Vec<(&str, &Path)> = scene.iter().map(|scene| ("scene", scene.as_path())).collect();
        let mut files = FileSet::default();
        let are_finished = drawings.len() == solved.len();
        let of_scene = |index: usize, made| match (solved.get(index), made) {
            (Some((source, solution)), OfScene::Page) if are_finished => self.page(source, solution),
            #[cfg(feature = "png")]
            (Some((source, solution)), OfScene::Film(format)) if are_finished => {
                let dpi = self.figures.options.dpi_of(solution.scene.figure.page.size_mm()[0]);
                if !self.yes {
                    self.film.refuse_long(source, solution, dpi)?;
                }
                self.film.file(source, solution, &style, format, dpi)
            }
            _ => refuse("a page has all steps", "leave out --steps"),
        };
        let kind = match (self.layered, self.is_blank()) {
            (true, _) => Sheets::Layered,
            (false, true) => Sheets::Joined,
            (false, false) => Sheets::Apart,
        };
        self.figures.write(&mut files, &inputs, drawings, kind, of_scene)?;
        files.finish()
    }

    /// Whether sheets to be drawn on are asked for.
    fn is_blank(&self) -> bool {
        self.worksheet == Some(WorkSheet::Blank)
    }

    /// Refuses what sheets to be drawn on do not have.
    fn check_blank(&self) -> Result<(), Failure> {
        let (steps, values) = (self.steps.is_some() || self.upto.is_some() || self.layered, self.values.is_some());
        let wrong = [
            (steps, "sheets to be drawn on have no steps", "leave out --steps, --upto and --layered"),
            (values, "sheets to be drawn on tell no values", "leave out --values"),
            (
                self.figures.has_page(),
                "a page has no sheets to be drawn on",
                "name a file that ends in `.pdf`, or a folder",
            ),
        ];
        match wrong.into_iter().find(|(is_given, ..)| *is_given) {
            Some((_, message, hint)) => refuse(message, format!("{hint}; or `--worksheet` for the filled sheet")),
            None => Ok(()),
        }
    }

    /// The scene and the steps that are asked for. In `--steps scene.json` the scene is no kind of steps.
    fn scene_and_steps(&self) -> Result<(Option<PathBuf>, Option<Steps>), Failure> {
        match (self.steps.as_deref(), &self.scene) {
            (None, scene) => Ok((scene.clone(), None)),
            (Some("fine"), scene) => Ok((scene.clone(), Some(Steps::Fine))),
            (Some("coarse"), scene) => Ok((scene.clone(), Some(Steps::Coarse))),
            (Some(path), None) => Ok((Some(path.into()), Some(Steps::Fine))),
            (Some(other), Some(_)) => {
                refuse(format!("there are no `{other}` steps"), "--steps is fine, also without a word, or coarse")
            }
        }
    }

    /// Overrides a scene's figure by the options that are given.
    fn put_into(&self, figure: &mut Figure, style: &GivenStyle) {
        style.put_into(figure);
        self.look.put_into(figure);
        self.markers.put_into(figure);
        figure.worksheet = (figure.worksheet || self.worksheet.is_some()) && !self.is_blank();
        figure.willis |= self.willis;
        figure.values = self.values.or(figure.values);
        if !self.trace.is_empty() {
            figure.trace = split_names(&self.trace);
        }
        figure.beyond_limits |= self.beyond_limits;
        figure.ghosts = self.ghosts.map(usize::from).or(figure.ghosts);
        self.poles.put_into(figure);
        self.centers.put_into(figure);
        figure.focus = self.focus.or(figure.focus);
        figure.step = self.upto.or(figure.step).filter(|_| self.steps.is_none() && !self.layered && !self.is_blank());
    }

    /// Refuses what options name and the scene does not have.
    fn check_shown(&self, scene: &Scene) -> Result<(), Failure> {
        refuse_nothing("--trace", &self.trace, &scene.figure.trace)?;
        self.poles.check(&scene.figure)?;
        self.centers.check(&scene.figure)?;
        check_figure(scene)
    }

    /// The workbench with a scene open, with what the command line asks for written into it, and its steps shown, from
    /// the first or from the one that is asked for.
    fn page(&self, source: &Source, solution: &Solution) -> Result<Vec<u8>, Failure> {
        let own = source.checked(Scene::read(&source.text))?;
        let step = solution.scene.figure.step.unwrap_or(1);
        let figure = Figure { step: own.figure.step, ..solution.scene.figure.clone() };
        let asked = || match self.mode.number {
            Some(mode) => with_mode(&with_figure(&source.text, &figure)?, mode),
            None => with_figure(&source.text, &figure),
        };
        let text = source.checked(asked())?;
        Ok(workbench(Some(OpenScene { text: &text, step: Some(step) })).into_bytes())
    }

    /// Refuses or tells what has no place on a page.
    fn check_page(&self, style: &GivenStyle) -> Result<(), Failure> {
        if let GivenStyle::File(_) = style {
            return refuse(
                "a page has the styles that a scene can name, not that of a file",
                format!("--style is one of {}", StyleName::ALL.map(StyleName::as_str).join(", ")),
            );
        }
        for (option, is_given) in [("--positions", self.positions.is_some()), ("--drive", self.film.drive.is_some())] {
            if is_given {
                note(&format!("{option} does nothing: a page moves every drive to any position"));
            }
        }
        Ok(())
    }

    /// Refuses what a film does not show.
    fn check_film(&self) -> Result<(), Failure> {
        let wrong = [
            (self.steps.is_some(), "--steps"),
            (self.layered, "--layered"),
            (self.worksheet.is_some(), "--worksheet"),
            (self.upto.is_some(), "--upto"),
        ];
        match wrong.into_iter().find(|(is_given, _)| *is_given) {
            Some((_, option)) => refuse(
                format!("a film shows the finished figure in motion, which does not go with {option}"),
                format!("leave out {option}, or name a file or --format that is no film"),
            ),
            None => Ok(()),
        }
    }

    /// The sheets that are asked for, with a word on what does not fit on them.
    fn sheets(
        &self,
        name: String,
        solution: &Solution,
        traces: Traces,
        steps: Option<Steps>,
        style: &GivenStyle,
    ) -> Result<Vec<(String, Made)>, Failure> {
        let figures = FigureSheets::with_traces(solution, traces.into());
        figures.overflow_warnings().iter().for_each(|warning| warn(&warning.to_string()));
        let figure = &solution.scene.figure;
        if steps.is_some() || figure.step.is_some() {
            return self.step_sheets(name, solution, &figures, steps, style);
        }
        let name = if self.layered { format!("{name}-layered") } else { name };
        let mut sheets = if self.is_blank() { solution.drawing_sheets(&name) } else { figures.sheets() };
        if self.is_blank() || figure.worksheet {
            note_markers(figure, sheets.first());
        } else if let Some(sheet) = sheets.first() {
            figures.cost_of_list().iter().for_each(|cost| note(&cost.to_string()));
            let missing = figures.values_without_room(sheet).join(", ");
            if !missing.is_empty() {
                note(&format!("no room for the values of {missing}; they are in a table on the next sheet"));
            }
            if figures.is_willis_apart() {
                note("no room for Willis' table beside the panels; it is on a further sheet");
            }
            let left_out = figures.values_left_out(sheet);
            if left_out > 0 {
                let values = match left_out {
                    1 => "1 value that is no main result; --values adds a table with it".to_owned(),
                    count => format!("{count} values that are no main results; --values adds a table with them"),
                };
                note(&format!("no room for {values}"));
            }
            let parts = sheets.iter().skip(1).filter(|sheet| !sheet.panels.is_empty()).count();
            if parts > 0 {
                let sheets = if parts == 1 { "1 further sheet shows" } else { &format!("{parts} further sheets show") };
                note(&format!("names crowd: {sheets} parts of the plans, larger"));
            }
        }
        style.put_on(&mut sheets);
        Ok(vec![(name, Made::Sheets(sheets))])
    }

    /// The sheets of the steps that were asked for, each under its name.
    fn step_sheets(
        &self,
        name: String,
        solution: &Solution,
        figures: &FigureSheets<'_>,
        steps: Option<Steps>,
        style: &GivenStyle,
    ) -> Result<Vec<(String, Made)>, Failure> {
        let wanted = solution.scene.figure.step;
        let mut all = figures.steps(steps.unwrap_or(Steps::Fine));
        style.put_on([&mut all]);
        let count = all.steps.len();
        let digits = count.to_string().len().max(2);
        let scene = &solution.scene;
        // `steps` counts on through the plan of accelerations, for which the figure may have no panel.
        let has_more = order_of_figure(scene) == Order::Velocity;
        if let Some(step) = wanted.filter(|step| !(1..=count).contains(step)) {
            let listed = match has_more {
                true => " in the figure's panels; `kinegon steps` also lists those of the acceleration plan",
                false => "; `kinegon steps` lists them",
            };
            let hint = format!("the construction has steps 1 to {count}{listed}");
            return refuse(format!("there is no step {step}"), hint);
        }
        if has_more && wanted.is_none() {
            note(
                "the figure has no panel for the acceleration plan: no sheets for its steps, which `kinegon steps` lists",
            );
        }
        let shown = shown_steps(solution, steps);
        let is_shown = |step: &usize| wanted.map_or(shown.get(step - 1) == Some(&true), |wanted| *step == wanted);
        let shown: Vec<usize> = (1..=count).filter(is_shown).collect();
        if !self.yes && shown.len() > 1 {
            self.refuse_many(&all, &shown, steps)?;
        }
        let all = Rc::new(all);
        let sheet = |step: usize| (format!("{name}-{step:0digits$}"), Made::After(all.clone(), step));
        Ok(shown.into_iter().map(sheet).collect())
    }
}

/// Reads the unit of length of values: `own` is the scene's, `none` shows no values.
fn values() -> impl TypedValueParser<Value = ValuesShown> {
    let names = LengthUnit::ALL.map(LengthUnit::as_str);
    PossibleValuesParser::new(names.into_iter().chain(["own", "none"])).map(|given| match given.as_str() {
        "none" => ValuesShown::Hidden,
        unit => ValuesShown::Shown(LengthUnit::ALL.into_iter().find(|known| known.as_str() == unit)),
    })
}

/// Says why a sheet to be drawn on has no markers, unless that was asked for.
fn note_markers(figure: &Figure, sheet: Option<&Drawing>) {
    if sheet.is_some_and(|sheet| sheet.code.is_some()) || !figure.markers {
        return;
    }
    note(match figure.has_markers() {
        true => {
            "the sheet has no room for markers at its scales: a photograph of it cannot be read; on a larger page, or at \
             coarser scales, it has them"
        }
        false => "sheets in a projector's proportions have no markers: a photograph of them cannot be read",
    });
}

/// By step: whether it is drawn in a panel. With a focus the steps of the other plan are left out.
fn shown_steps(solution: &Solution, steps: Option<Steps>) -> Vec<bool> {
    let construction = &solution.construction;
    let panels = solution.scene.figure.shown_panels();
    let is_shown = |step: &NumberedStep<'_>| solution.scene.figure.focus.is_none() || panels.contains(&step.sheet);
    match steps {
        Some(Steps::Coarse) => {
            let passages = construction.passages();
            passages.iter().map(|passage| construction.steps_of(passage).any(|step| is_shown(&step))).collect()
        }
        _ => construction.numbered_steps().map(|step| is_shown(&step)).collect(),
    }
}
