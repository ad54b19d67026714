//! The sentences of figures and reports, each declared once: its key in the catalogues and the names of its blanks.
//! Each declaration gives a method of [`Language`], so the compiler checks that every blank is filled.

use super::catalogue::{Declared, Language};

/// Declares the sentences of a group and a method for each: `title;` gives `title(&self) -> &str`, and `cross(image);`
/// gives `cross(&self, image: &str) -> String`. Names of points are passed in backticks, numbers as text.
macro_rules! sentences {
    ($group:path => $($(#[$about:meta])+ $key:ident $(($($blank:ident),+))?;)+) => {
        use super::Group;
        use crate::words::catalogue::{Declared, Language};

        /// Index of each sentence in [`SENTENCES`].
        #[expect(non_camel_case_types, reason = "they are the keys of the catalogues")]
        #[derive(Clone, Copy)]
        enum Key { $($key),+ }

        /// Index of the group's first sentence among all.
        const FIRST: usize = super::before($group as usize);

        /// The keys and blanks of every catalogue.
        pub(super) const SENTENCES: &[Declared] =
            &[$(Declared { key: stringify!($key), blanks: &[$($(stringify!($blank)),+)?] }),+];

        impl Language {
            $(sentences!(@method $(#[$about])+ $key $(($($blank),+))?);)+
        }
    };
    (@method $(#[$about:meta])+ $key:ident) => {
        $(#[$about])+
        #[must_use]
        pub fn $key(&self) -> &str {
            self.sentences[FIRST + Key::$key as usize].plain()
        }
    };
    (@method $(#[$about:meta])+ $key:ident ($($blank:ident),+)) => {
        $(#[$about])+
        #[must_use]
        pub fn $key(&self, $($blank: &str),+) -> String {
            self.sentences[FIRST + Key::$key as usize].filled(&[$($blank),+])
        }
    };
}

mod check;
mod construction;
mod exercise;
mod figure;
mod mechanism;

/// What sentences are about, in the order of [`GROUPS`].
#[derive(Clone, Copy)]
enum Group {
    Construction,
    Figure,
    Mechanism,
    Check,
    Exercise,
}

/// The declarations, group by group.
const GROUPS: [&[Declared]; 5] =
    [construction::SENTENCES, figure::SENTENCES, mechanism::SENTENCES, check::SENTENCES, exercise::SENTENCES];

/// How many sentences stand in the first groups.
const fn before(groups: usize) -> usize {
    let (mut count, mut group) = (0, 0);
    while group < groups {
        count += GROUPS[group].len();
        group += 1;
    }
    count
}

/// The declarations of all sentences.
pub(super) fn sentences() -> impl Iterator<Item = &'static Declared> {
    GROUPS.into_iter().flatten()
}

impl Language {
    /// Headings of the columns in the report on a student's values.
    #[must_use]
    pub fn check_columns(&self) -> [&str; 8] {
        [
            self.check_column_quantity(),
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
