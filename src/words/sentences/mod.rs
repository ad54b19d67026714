//! The sentences of figures, steps and reports, each declared once: its key and its blanks. What they say stands in `*.ftl` under the same
//! keys. A declaration gives a method of [`Language`], so the compiler checks that every blank is filled.

use super::Language;
use crate::message::{Declared, Message};
use crate::sheet::Sheet;

/// Declares the sentences and a method for each: `title;` gives `title(&self) -> &str`, and `cross(image);` gives
/// `cross(&self, image: &str) -> String`. Names of points are passed in backticks, numbers as text.
macro_rules! sentences {
    ($($(#[$about:meta])* $key:ident $(($($blank:ident),+))?;)+) => {
        /// All sentences of this file.
        pub(super) static DECLARED: &[Declared] = &[
            $(Declared { key: stringify!($key), blanks: &[$($(stringify!($blank)),+)?] }),+
        ];

        impl Language {
            $(sentences!(@method $(#[$about])* $key $(($($blank),+))?);)+
        }
    };
    (@method $(#[$about:meta])* $key:ident) => {
        $(#[$about])*
        #[doc = concat!("`", stringify!($key), "` of the catalogues.")]
        #[must_use]
        pub fn $key(&self) -> &str {
            self.words(stringify!($key))
        }
    };
    (@method $(#[$about:meta])* $key:ident ($($blank:ident),+)) => {
        $(#[$about])*
        #[doc = concat!("`", stringify!($key), "` of the catalogues.")]
        #[must_use]
        pub fn $key(&self, $($blank: &str),+) -> String {
            self.filled(&Declared { key: stringify!($key), blanks: &[$(stringify!($blank)),+] }, &[$($blank),+])
        }
    };
}

mod construction;
mod figures;
mod students;

/// All sentences.
#[must_use]
pub fn declared() -> Vec<Declared> {
    let of_sheets = Sheet::ALL.iter().flat_map(|sheet| of_sheet(*sheet));
    [construction::DECLARED, figures::DECLARED, students::DECLARED]
        .into_iter()
        .flatten()
        .chain(of_sheets)
        .copied()
        .collect()
}

/// What is said of a sheet: its heading, its name within a sentence, and its description for readers who cannot see it.
fn of_sheet(sheet: Sheet) -> &'static [Declared; 3] {
    macro_rules! of {
        ($key:literal) => {
            &[
                Declared { key: $key, blanks: &[] },
                Declared { key: concat!("named_", $key), blanks: &[] },
                Declared { key: concat!("described_", $key), blanks: &[] },
            ]
        };
    }
    match sheet {
        Sheet::Scheme => of!("scheme"),
        Sheet::Velocity => of!("velocity_plan"),
        Sheet::Acceleration => of!("acceleration_plan"),
        Sheet::Centers => of!("centers"),
        Sheet::Forces => of!("force_plan"),
        Sheet::Lever => of!("lever"),
        Sheet::Speeds => of!("speeds"),
    }
}

/// A sheet within a message.
pub fn sheet_told(sheet: Sheet) -> Message {
    let [_, named, _] = of_sheet(sheet);
    Message::of(named, Vec::new())
}

impl Language {
    /// Heading of a sheet.
    #[must_use]
    pub fn sheet(&self, sheet: Sheet) -> &str {
        self.words(of_sheet(sheet)[0].key)
    }

    /// A sheet within a sentence.
    #[must_use]
    pub fn named_sheet(&self, sheet: Sheet) -> &str {
        self.words(of_sheet(sheet)[1].key)
    }

    /// A sheet in the description of a figure, for readers who cannot see it.
    #[must_use]
    pub fn described_sheet(&self, sheet: Sheet) -> &str {
        self.words(of_sheet(sheet)[2].key)
    }

    /// Headings of the columns in the report on a student's values.
    #[must_use]
    pub fn check_columns(&self) -> [&str; 8] {
        [
            self.column_quantity(),
            self.check_column_written(),
            self.check_column_expected(),
            self.check_column_difference(),
            self.check_column_on_paper(),
            self.check_column_percent(),
            self.check_column_allowed(),
            self.check_column_verdict(),
        ]
    }

    /// Headings of the columns in the table of points in a photograph.
    #[must_use]
    pub fn photo_columns(&self) -> [&str; 6] {
        [
            self.photo_column_point(),
            self.photo_column_right(),
            self.photo_column_found(),
            self.photo_column_off(),
            self.photo_column_band(),
            self.check_column_verdict(),
        ]
    }
}
