use crate::construction::{Solution, Tolerance};
use crate::quantity::{self, Asked, Pencil};
use clap::Args;

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

    /// The bands of the quantities `asked`, drawn at the scales of the scene's figure.
    pub(super) fn pencil(&self, solution: &Solution, asked: Vec<Asked>) -> Pencil {
        quantity::pencil(solution, &solution.scales(), self.tolerance(), asked)
    }
}
