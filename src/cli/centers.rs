//! Options for instant centres: those wanted, velocities by them, centrodes, inflection circles.

use super::cycle::{refuse_nothing, split_names};
use super::message::Failure;
use crate::scene::{CentersShown, Figure, Scene};
use crate::sheet::Sheet;
use clap::Args;

/// Instant centres and what they draw, in place of what the scene's figure asks for.
#[derive(Debug, Default, Args)]
pub(super) struct CenterOptions {
    /// Draw the figure of instant centres, in place of the plans where the scene does not ask for it: `all`, or these, as
    /// "P(1,3), P(2,ground)"; without a word, or with `usual`, those that the scene asks for, else the usual ones.
    #[arg(long, value_name = "CENTRES", num_args = 0..=1, require_equals = true, default_missing_value = USUAL)]
    centers: Option<String>,
    /// Find the velocities of these points, as "C, D", by instant centres, on that figure.
    #[arg(long, value_name = "POINTS")]
    velocities: Vec<String>,
    /// Construct the centres of curvature of the paths of these points, as "C, D", on that figure.
    #[arg(long, value_name = "POINTS")]
    curvature: Vec<String>,
}

/// Curves of instant centres on the scheme, in place of those that the scene's figure asks for.
#[derive(Debug, Default, Args)]
pub(super) struct PoleOptions {
    /// Draw the centrodes of these links, as "2, 4", over the whole cycle of the drive.
    #[arg(long, value_name = "LINKS")]
    centrodes: Vec<String>,
    /// Draw the inflection circles of these links.
    #[arg(long, value_name = "LINKS")]
    inflection: Vec<String>,
}

/// What stands for the option without a word.
const USUAL: &str = "usual";

/// The word for all centres.
const ALL: &str = "all";

impl CenterOptions {
    /// Overrides a scene's figure by the options that are given.
    pub(super) fn put_into(&self, figure: &mut Figure) {
        match self.centers.as_deref() {
            None | Some(USUAL) => {}
            Some(ALL) => figure.centers = CentersShown::All,
            Some(names) => figure.centers = CentersShown::Named(split_names(&[names.to_owned()])),
        }
        put_names(&self.velocities, &mut figure.velocities);
        put_names(&self.curvature, &mut figure.curvature);
        let is_asked = self.centers.is_some() || !self.velocities.is_empty() || !self.curvature.is_empty();
        if is_asked && !figure.panels.contains(&Sheet::Centers) {
            figure.panels = vec![Sheet::Scheme, Sheet::Centers];
        }
    }

    /// Refuses what names nothing.
    pub(super) fn check(&self, figure: &Figure) -> Result<(), Failure> {
        if let (Some(given), CentersShown::Named(names)) = (&self.centers, &figure.centers) {
            refuse_nothing("--centers", std::slice::from_ref(given), names)?;
        }
        refuse_nothing("--curvature", &self.curvature, &figure.curvature)?;
        refuse_nothing("--velocities", &self.velocities, &figure.velocities)
    }
}

impl PoleOptions {
    /// Overrides a scene's figure by the options that are given.
    pub(super) fn put_into(&self, figure: &mut Figure) {
        put_names(&self.centrodes, &mut figure.centrodes);
        put_names(&self.inflection, &mut figure.inflection);
    }

    /// Refuses what names nothing.
    pub(super) fn check(&self, figure: &Figure) -> Result<(), Failure> {
        refuse_nothing("--centrodes", &self.centrodes, &figure.centrodes)?;
        refuse_nothing("--inflection", &self.inflection, &figure.inflection)
    }
}

fn put_names(given: &[String], into: &mut Vec<String>) {
    if !given.is_empty() {
        *into = split_names(given);
    }
}

/// Refuses an option of a figure that the scene cannot follow; each is called as the figure's key.
pub(super) fn check_figure(scene: &Scene) -> Result<(), Failure> {
    scene.check_shown().map_err(|error| {
        let option = format!("--{}", error.path.split('.').next().unwrap_or_default());
        Failure::of_option(&option, error)
    })
}
