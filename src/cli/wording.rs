use crate::scene::{DecimalMark, Figure, LanguageName, NotationName};
use clap::builder::{PossibleValue, PossibleValuesParser, StringValueParser, TypedValueParser};
use clap::{Arg, Args, Command};
use std::ffi::OsStr;

/// How things are said and written, in place of what the scene's figure asks for.
#[derive(Debug, Default, Args)]
pub(super) struct Words {
    /// Notation of poles, images and parts of accelerations.
    #[arg(long, value_parser = one_of(NotationName::ALL, NotationName::as_str))]
    notation: Option<NotationName>,
    /// Language of headings and captions.
    #[arg(long, value_parser = one_of(LanguageName::ALL, LanguageName::as_str))]
    language: Option<LanguageName>,
    /// Decimal mark of numbers.
    #[arg(long, value_parser = one_of(DecimalMark::ALL, DecimalMark::as_str))]
    decimal: Option<DecimalMark>,
}

impl Words {
    /// Overrides a scene's figure by the options that are given.
    pub(super) fn put_into(&self, figure: &mut Figure) {
        figure.notation = self.notation.unwrap_or(figure.notation);
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
pub(super) fn one_of<T: Copy + Send + Sync + 'static, const N: usize>(
    all: [T; N],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(all.map(name))
        .map(move |given| all.into_iter().find(|value| name(*value) == given).expect("only known names come through"))
}
