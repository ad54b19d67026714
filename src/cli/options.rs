//! Options that several commands have: the words, the sheet and its scales, the hand that draws.

use crate::construction::Tolerance;
use crate::scene::{
    CenterName, CoriolisName, DecimalMark, Figure, FrameName, LanguageName, NotationName, Page, ScalesFor, SlidingName,
    TurnedName,
};
use crate::sheet::{PerSheet, Scales, Sheet};
use clap::builder::{PossibleValue, PossibleValuesParser, StringValueParser, TypedValueParser};
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches};
use std::ffi::OsStr;

/// How things are said and written, in place of what the scene's figure asks for.
#[derive(Debug, Default, Args)]
pub(super) struct Words {
    /// Notation of poles, images and parts of accelerations.
    #[arg(long, value_parser = one_of(&NotationName::ALL, NotationName::as_str))]
    notation: Option<NotationName>,
    /// How motions along guides are written: by the slider as v_r(3/2), or by points of both links as v_B3B2.
    #[arg(long, value_parser = one_of(&SlidingName::ALL, SlidingName::as_str))]
    sliding: Option<SlidingName>,
    /// Index of Coriolis accelerations, in place of that of the notation.
    #[arg(long, value_parser = one_of(&CoriolisName::ALL, CoriolisName::as_str))]
    coriolis: Option<CoriolisName>,
    /// Letter of instant centres: P_13, I_13 or CIR_13.
    #[arg(long, value_name = "LETTER", value_parser = one_of(&CenterName::ALL, CenterName::as_str))]
    center_letter: Option<CenterName>,
    /// Number that the frame is called by, in place of a word.
    #[arg(long, value_parser = one_of(&FrameName::ALL, FrameName::as_str))]
    frame: Option<FrameName>,
    /// Sense in which figures and steps show the velocity plan turned by 90°; sheets to be drawn on, keys and checks have it as it is.
    #[arg(long, value_parser = one_of(&TurnedName::ALL, TurnedName::as_str))]
    turned: Option<TurnedName>,
    /// Language of headings and captions.
    #[arg(long, value_parser = one_of(&LanguageName::ALL, LanguageName::as_str))]
    language: Option<LanguageName>,
    /// Decimal mark of numbers.
    #[arg(long, value_parser = one_of(&DecimalMark::ALL, DecimalMark::as_str))]
    decimal: Option<DecimalMark>,
}

impl Words {
    /// Overrides a scene's figure by the options that are given.
    pub(super) fn put_into(&self, figure: &mut Figure) {
        figure.notation = self.notation.unwrap_or(figure.notation);
        figure.sliding = self.sliding.unwrap_or(figure.sliding);
        figure.coriolis = self.coriolis.or(figure.coriolis);
        figure.center_letter = self.center_letter.unwrap_or(figure.center_letter);
        figure.frame = self.frame.or(figure.frame);
        figure.turned = self.turned.or(figure.turned);
        figure.language = self.language.unwrap_or(figure.language);
        figure.decimal = self.decimal.unwrap_or(figure.decimal);
    }
}

/// Names that a shell completes, where any other text is taken, too, as the path of a file.
#[derive(Clone)]
pub(super) struct NamesAnd(pub Vec<&'static str>);

impl TypedValueParser for NamesAnd {
    type Value = String;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<String, clap::Error> {
        StringValueParser::new().parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(self.0.iter().map(PossibleValue::new)))
    }
}

/// Accepts the names of some values.
pub(super) fn one_of<T: Copy + Send + Sync>(
    all: &'static [T],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    let named = move |given: String| all.iter().copied().find(|value| name(*value) == given);
    PossibleValuesParser::new(all.iter().copied().map(name))
        .map(move |given| named(given).expect("only known names come through"))
}

/// The sheet of paper, in place of the one that the scene's figure asks for.
#[derive(Debug, Default, Args)]
pub(super) struct Paper {
    /// The sheet: 16x9 (320 mm × 180 mm) for the projector; `-portrait` or `-landscape` says which way it lies.
    #[arg(long, value_name = "NAME", value_parser = one_of(Page::NAMES.as_flattened(), |name| name))]
    page: Option<&'static str>,
    /// Which way the sheet lies.
    #[arg(long = "orientation", value_name = "ORIENTATION",
        value_parser = one_of(&[true, false], |is_landscape| if is_landscape { "landscape" } else { "portrait" }))]
    landscape: Option<bool>,
}

impl Paper {
    /// Whether one of its options is given.
    pub(super) fn is_given(&self) -> bool {
        self.page.is_some() || self.landscape.is_some()
    }

    /// Overrides a scene's figure by the options that are given.
    pub(super) fn put_into(&self, figure: &mut Figure) {
        let page = &mut figure.page;
        if let Some((name, given)) = self.page.and_then(|name| Some((name, Page::from_name(name)?))) {
            page.size = given.size;
            page.landscape = if name.contains('-') { given.landscape } else { page.landscape };
        }
        page.landscape = self.landscape.unwrap_or(page.landscape);
    }
}

/// The figure's scales, in place of those that the scene gives or that fit.
#[derive(Debug, Default, Args)]
pub(super) struct GivenScales {
    #[command(flatten)]
    mu: ScaleOptions,
    /// For which plans the other scales are chosen: the scene's own position, with one set for figure, steps, work
    /// sheet and page; each sheet for itself; or the largest plans of the whole cycle.
    #[arg(long, value_name = "FOR", value_parser = one_of(&ScalesFor::ALL, ScalesFor::as_str))]
    scales: Option<ScalesFor>,
}

fn scale(text: &str) -> Result<f64, String> {
    let scale = text.parse().map_err(|_| "not a number".to_owned())?;
    Figure::checked_scale(scale).map_err(|why| why.to_string())
}

/// An option for the scale of each sheet.
#[derive(Debug, Default)]
struct ScaleOptions(Scales);

/// The name of the option for a sheet's scale, as `mu-v`.
pub(super) fn scale_option(sheet: Sheet) -> String {
    sheet.facts().scale_key.replace('_', "-")
}

impl Args for ScaleOptions {
    fn augment_args(command: Command) -> Command {
        command.args(Sheet::ALL.map(|sheet| {
            Arg::new(sheet.facts().scale_key)
                .long(scale_option(sheet))
                .value_name("NUMBER")
                .value_parser(scale)
                .allow_negative_numbers(true)
                .help(format!("Scale of the {}: {} per mm of paper", sheet.name(), sheet.facts().scaled_units))
        }))
    }

    fn augment_args_for_update(command: Command) -> Command {
        ScaleOptions::augment_args(command)
    }
}

impl FromArgMatches for ScaleOptions {
    fn from_arg_matches(given: &ArgMatches) -> Result<ScaleOptions, clap::Error> {
        Ok(ScaleOptions(PerSheet::from_fn(|sheet| given.get_one(sheet.facts().scale_key).copied())))
    }

    fn update_from_arg_matches(&mut self, given: &ArgMatches) -> Result<(), clap::Error> {
        ScaleOptions::from_arg_matches(given).map(|read| *self = read)
    }
}

impl GivenScales {
    /// Whether one of its options is given.
    pub(super) fn is_given(&self) -> bool {
        self.scales.is_some() || self.mu.0.given().next().is_some()
    }

    /// Overrides a scene's figure by the options that are given.
    pub(super) fn put_into(&self, figure: &mut Figure) {
        figure.mu = self.mu.0.or(figure.mu);
        figure.scales = self.scales.unwrap_or(figure.scales);
    }
}

/// Words, sheet and scales, in place of what the scene's figure asks for.
#[derive(Debug, Default, Args)]
pub(super) struct Look {
    #[command(flatten)]
    words: Words,
    #[command(flatten)]
    pub paper: Paper,
    #[command(flatten)]
    scales: GivenScales,
}

impl Look {
    /// Overrides a scene's figure by the options that are given.
    pub(super) fn put_into(&self, figure: &mut Figure) {
        self.words.put_into(figure);
        self.paper.put_into(figure);
        self.scales.put_into(figure);
    }
}

/// Whether sheets to be drawn on have markers.
#[derive(Debug, Default, Args)]
pub(super) struct Markers {
    /// Leave out the markers by which a photograph of a sheet to be drawn on is read, and the sheets for the plans.
    #[arg(long)]
    no_markers: bool,
}

impl Markers {
    /// Overrides a scene's figure by the option, if it is given.
    pub(super) fn put_into(&self, figure: &mut Figure) {
        figure.markers &= !self.no_markers;
    }
}

/// How good a hand is.
#[derive(Debug, Args)]
pub(super) struct Hand {
    /// Limit of a hand drawing's error in a point set, or a length laid off or measured, in mm of paper [default: 0.3].
    #[arg(long = "pencil-mm", value_name = "MM", value_parser = limit, allow_negative_numbers = true)]
    pub mm: Option<f64>,
    /// Limit of a hand drawing's error in a direction, in degrees [default: 0.3].
    #[arg(long = "pencil-degrees", value_name = "DEGREES", value_parser = limit, allow_negative_numbers = true)]
    pub degrees: Option<f64>,
}

fn limit(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(limit) if (0.0..=Tolerance::LARGEST).contains(&limit) => Ok(limit),
        _ => Err(format!("not a number from 0 to {}", Tolerance::LARGEST)),
    }
}

impl Hand {
    /// Whether one of its options is given.
    pub(super) fn is_given(&self) -> bool {
        self.mm.is_some() || self.degrees.is_some()
    }

    /// The limits of the hand's errors; by default those of a sharp pencil.
    pub(super) fn tolerance(&self) -> Tolerance {
        let usual = Tolerance::default();
        Tolerance { mm: self.mm.unwrap_or(usual.mm), degrees: self.degrees.unwrap_or(usual.degrees) }
    }
}
