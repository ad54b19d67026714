//! Why a photograph is not read.

/// Why no sheet is read from a picture, and what to do.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Refusal {
    /// No sheet is there, or too little of it.
    #[error("{}", few(*.markers))]
    FewMarkers {
        /// How many different markers were found.
        markers: usize,
    },
    /// The markers are not where any camera would see those of a flat or evenly bent sheet.
    #[error("the sheet is not flat: its markers are {millimetres:.1} mm from where they would be on an even sheet")]
    NotEven {
        /// Root of the mean square of their distances, in mm.
        millimetres: f64,
    },
    /// The picture is so blurred that the markers are not where any camera would see them.
    #[error("the picture is blurred: edges on the sheet are {millimetres:.1} mm wide in it")]
    Blurred {
        /// Width of edges, in mm.
        millimetres: f64,
    },
    /// The sheet is rolled too much.
    #[error("the sheet is bent: its middle is {millimetres:.0} mm above or below its edges")]
    Bent {
        /// Height of the bend, in mm.
        millimetres: f64,
    },
    /// The small code cannot be read.
    #[error("the small code at the lower right corner of the sheet cannot be read")]
    NoCode,
    /// The code is of a sheet of another size.
    #[error(
        "the small code is of a page that is not that of the markers: the picture shows parts of two sheets, or a sheet that was cut"
    )]
    OtherPage,
}

impl Refusal {
    /// What to do.
    #[must_use]
    pub fn hint(&self) -> &'static str {
        match self {
            Refusal::FewMarkers { .. } => {
                "take the picture from above, with the whole sheet and all eight black squares in it, sharp and without a hand over them"
            }
            Refusal::NotEven { .. } | Refusal::Bent { .. } => {
                "press the sheet flat, under a sheet of glass or with weights on its edges, and take the picture again"
            }
            Refusal::Blurred { .. } => {
                "take the picture nearer, so that the sheet fills it, in more light, and hold the camera still"
            }
            Refusal::NoCode => {
                "take the picture nearer and sharper, with light on the code; nothing may be drawn over it"
            }
            Refusal::OtherPage => "photograph one whole sheet as it was printed",
        }
    }
}

/// What is said of that many markers.
fn few(markers: usize) -> String {
    match markers {
        0 => "no sheet with markers is found in the picture".to_owned(),
        1 => "only one of the sheet's eight markers is found in the picture".to_owned(),
        few => format!("only {few} of the sheet's eight markers are found together in the picture"),
    }
}
