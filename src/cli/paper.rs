use super::wording::one_of;
use crate::scene::{Figure, Page, ScalesFor};
use clap::{Args, ValueEnum};

/// The sheet of paper, in place of the one that the scene's figure asks for.
#[derive(Debug, Default, Args)]
pub(super) struct Paper {
    /// The sheet: 16x9 (320 mm × 180 mm) for the projector; `-portrait` or `-landscape` says which way it lies.
    #[arg(long, value_name = "NAME", value_parser = one_of(Page::NAMES, |name| name))]
    page: Option<&'static str>,
    /// Which way the sheet lies.
    #[arg(long, value_enum)]
    orientation: Option<Orientation>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Orientation {
    Landscape,
    Portrait,
}

impl Paper {
    /// Whether one of its options is given.
    pub(super) fn is_given(&self) -> bool {
        self.page.is_some() || self.orientation.is_some()
    }

    /// Overrides a scene's figure by the options that are given.
    pub(super) fn put_into(&self, figure: &mut Figure) {
        let page = &mut figure.page;
        if let Some((name, given)) = self.page.and_then(|name| Some((name, Page::from_name(name)?))) {
            page.size = given.size;
            page.landscape = if name.contains('-') { given.landscape } else { page.landscape };
        }
        let landscape = self.orientation.map(|way| way == Orientation::Landscape);
        page.landscape = landscape.unwrap_or(page.landscape);
    }
}

/// The figure's scales, in place of those that the scene gives or that fit.
#[derive(Debug, Default, Args)]
pub(super) struct GivenScales {
    /// Scale of the scheme: units of length per mm of paper.
    #[arg(long, value_name = "NUMBER", value_parser = scale, allow_negative_numbers = true)]
    mu_l: Option<f64>,
    /// Scale of the velocity plan: units of velocity per mm of paper.
    #[arg(long, value_name = "NUMBER", value_parser = scale, allow_negative_numbers = true)]
    mu_v: Option<f64>,
    /// Scale of the acceleration plan: units of acceleration per mm of paper.
    #[arg(long, value_name = "NUMBER", value_parser = scale, allow_negative_numbers = true)]
    mu_a: Option<f64>,
    /// For which plans the other scales are chosen: the scene's own position, with one set for figure, steps, work
    /// sheet and page; each sheet for itself; or the largest plans of the whole cycle.
    #[arg(long, value_name = "FOR", value_parser = one_of(ScalesFor::ALL, ScalesFor::as_str))]
    scales: Option<ScalesFor>,
}

fn scale(text: &str) -> Result<f64, String> {
    let scale = text.parse().map_err(|_| "not a number".to_owned())?;
    Figure::checked_scale(scale)
}

impl GivenScales {
    /// Whether one of its options is given.
    pub(super) fn is_given(&self) -> bool {
        self.scales.is_some() || [self.mu_l, self.mu_v, self.mu_a].iter().any(Option::is_some)
    }

    /// Overrides a scene's figure by the options that are given.
    pub(super) fn put_into(&self, figure: &mut Figure) {
        figure.mu_l = self.mu_l.or(figure.mu_l);
        figure.mu_v = self.mu_v.or(figure.mu_v);
        figure.mu_a = self.mu_a.or(figure.mu_a);
        figure.scales = self.scales.unwrap_or(figure.scales);
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
