//! The figure that a scene asks for.

use crate::sheet::{Scales, Sheet};
use indexmap::{IndexMap, IndexSet};
use serde::{Deserialize, Deserializer};
use serde_json::{Map, Value as Json};
use std::ops::RangeInclusive;

use super::centers::CentersShown;
use super::choices::{
    CenterName, ConstructionShown, CoriolisName, DecimalMark, FrameName, LanguageName, NotationName, ScalesFor,
    SlidingName, StyleName, TurnedName, ValuesShown,
};
use super::error::{Wrong, list, number, shortened};
use super::given::GivenBy;
use super::joint::{Contact, Slider};
use super::names::Names;
use super::page::{Page, PageSize, Sizes};
use super::says;
use super::text::LARGEST;
use super::write::{Write, Written, text_of, write_forms, write_keys};
use crate::message::Message;
use crate::text::Untrusted;

/// What the figure shows, and how large. The scale `mu` of a panel is in units per millimetre of paper; `None` stands
/// for the next round scale at which the panel fits.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "figure"))]
#[cfg_attr(feature = "schemas", schemars(transform = super::schema_made::without_defaults))]
#[cfg_attr(feature = "schemas", schemars(description = "What the figure shows, and how large."))]
#[serde(default, deny_unknown_fields, expecting = r#"a figure as { "panels": ["scheme", "velocity"] }"#)]
pub struct Figure {
    /// The panels, in order; left out: the scheme and both plans.
    #[cfg_attr(feature = "schemas", schemars(length(min = 1), extend("uniqueItems" = true)))]
    pub panels: Vec<Sheet>,
    /// The scales of the panels: units of what a panel shows per millimetre of paper. In the file each has the key of
    /// its panel, as `mu_v`.
    #[serde(rename = "mu_*")]
    #[cfg_attr(feature = "schemas", schemars(flatten, schema_with = "scales_schema"))]
    pub mu: Scales,
    /// For which plans scales are chosen that are not given; left out: "position".
    #[cfg_attr(feature = "schemas", schemars(with = "Option<ScalesFor>"))]
    pub scales: ScalesFor,
    /// The panel that takes most of the sheet; a plan has the scheme as a small companion. Left out: the panels share the sheet.
    pub focus: Option<Sheet>,
    /// The sheet: "a4", "a3", "letter" or, for the projector, "16x9", with "-portrait" where it does not lie; left out: "a4".
    #[cfg_attr(feature = "schemas", schemars(with = "Option<String>", extend("enum" = Page::NAMES.as_flattened())))]
    pub page: Page,
    /// Whether it is a work sheet: with a table of all measured lengths and a ruler to test the printer; left out: false.
    pub worksheet: bool,
    /// Whether Willis' table of the trains of wheels stands beside the panels; not on a work sheet. Left out: false.
    pub willis: bool,
    /// How lines and letters look; left out: "paper".
    #[cfg_attr(feature = "schemas", schemars(with = "Option<StyleName>"))]
    pub style: StyleName,
    /// How poles, images and parts of accelerations are written; left out: "paper". Names of quantities stay the same.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<NotationName>"))]
    pub notation: NotationName,
    /// How motions along guides are written: "slider" as v_r(3/2), "points" as v_B3B2; left out: "slider".
    #[cfg_attr(feature = "schemas", schemars(with = "Option<SlidingName>"))]
    pub sliding: SlidingName,
    /// The index of Coriolis accelerations; left out: that of the notation.
    pub coriolis: Option<CoriolisName>,
    /// How instant centres are written: P_13, I_13 or CIR_13; left out: "P".
    #[cfg_attr(feature = "schemas", schemars(with = "Option<CenterName>"))]
    pub center_letter: CenterName,
    /// The number that the frame is called by, unless `labels` has a text for `ground`; left out: a word.
    pub frame: Option<FrameName>,
    /// The sense in which figures and steps show the velocity plan turned by 90°; sheets to be drawn on, keys and checks have it as
    /// it is. Left out: not turned.
    pub turned: Option<TurnedName>,
    /// Language of headings and captions; left out: "en".
    #[cfg_attr(feature = "schemas", schemars(with = "Option<LanguageName>"))]
    pub language: LanguageName,
    /// Decimal mark of the numbers on figures and in the text of steps; left out: "point".
    #[cfg_attr(feature = "schemas", schemars(with = "Option<DecimalMark>"))]
    pub decimal: DecimalMark,
    /// Text to show in place of a name: { "B'": "B₁" }.
    pub labels: IndexMap<String, Untrusted>,
    /// Whether special points are shown; left out: true.
    pub special_points: bool,
    /// Whether construction lines are shown; "paper": shown, and the plans end where the source paper's end; left out: true.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<ConstructionShown>"))]
    pub construction: ConstructionShown,
    /// Whether values stand at vectors and links, in which unit of length; left out: as the style says, "lecture" alone does.
    pub values: Option<ValuesShown>,
    /// The step of the construction up to which the figure is drawn, from 1; left out: finished.
    #[serde(deserialize_with = "count")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<u16>", range(min = 1)))]
    pub step: Option<usize>,
    /// Points of links whose paths over the whole cycle of the drive are drawn in the scheme.
    #[cfg_attr(feature = "schemas", schemars(extend("uniqueItems" = true)))]
    pub trace: Vec<String>,
    /// Whether these paths go on, dashed, beyond limits of the drive, in the other assembly modes that the mechanism
    /// reaches there if another link moves it; left out: false.
    pub beyond_limits: bool,
    /// Links whose centrodes over that cycle are drawn in the scheme: the curves of the instant centre of the link and the frame, in the frame and in the link.
    #[cfg_attr(feature = "schemas", schemars(extend("uniqueItems" = true)))]
    pub centrodes: Vec<String>,
    /// Links whose inflection circles are drawn in the scheme, through instant centre and inflection pole.
    #[cfg_attr(feature = "schemas", schemars(extend("uniqueItems" = true)))]
    pub inflection: Vec<String>,
    /// Number of equally spaced positions over that cycle in which the links are drawn pale; left out: none.
    #[serde(deserialize_with = "count")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<u16>", range(min = 2, max = 72)))]
    pub ghosts: Option<usize>,
    /// The instant centres on the panel "centers", besides those that lead to them: "all", or a list of names, as ["P(2,ground)"]. Left out: all of a
    /// mechanism with at most four links, of a larger one those of all links with the frame.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<CentersShown>"))]
    pub centers: CentersShown,
    /// Points of links whose velocities that panel shows, found by centres from the one drive.
    #[cfg_attr(feature = "schemas", schemars(extend("uniqueItems" = true)))]
    pub velocities: Vec<String>,
    /// Points of links for whose paths that panel shows the centres of curvature, by Bobillier's construction.
    #[cfg_attr(feature = "schemas", schemars(extend("uniqueItems" = true)))]
    pub curvature: Vec<String>,
    /// Whether sheets to be drawn on, work sheets and those of exercises, have markers along their edges by which a
    /// photograph of them is read; left out: true.
    pub markers: bool,
    /// Sizes of letters and signs in place of those of `style`: of a style file, which is no part of the scene.
    #[serde(skip)]
    pub sizes: Option<Sizes>,
    /// Whether a figure that does not say so has values, in place of what `style` says: of a style file likewise.
    #[serde(skip)]
    pub usual_values: Option<bool>,
}

write_keys!(Figure {
    panels, mu, scales, focus, page, worksheet, willis, style, notation, sliding, coriolis, center_letter, frame, turned, language,
    decimal, labels, special_points, construction, values, step, trace, beyond_limits, centrodes, inflection, ghosts, centers, velocities, curvature, markers; sizes, usual_values
} unless Figure::default());

#[cfg(feature = "schemas")]
fn scales_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    Scales::schema(generator, |sheet| {
        let about = format!("Scale of the {}: {} per millimetre of paper.", sheet.name(), sheet.facts().scaled_units);
        serde_json::json!({ "description": about, "exclusiveMinimum": 0 })
    })
}

impl Write for Scales {
    fn written(&self) -> Written {
        Written::Object(self.entries(Scales::FIELD))
    }

    fn entries(&self, _: &str) -> Vec<(String, Written)> {
        self.iter().map(|(sheet, scale)| (sheet.facts().scale_key.to_owned(), scale.written())).collect()
    }
}

/// Steps and positions are read as `u16`: there are never more, and messages can name the range.
fn count<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<usize>, D::Error> {
    Option::<u16>::deserialize(deserializer).map(|count| count.map(usize::from))
}

impl Default for Figure {
    /// The scheme and both plans with everything on them, on A4 landscape, at scales that fit.
    fn default() -> Self {
        Figure {
            panels: Sheet::USUAL.to_vec(),
            mu: Scales::default(),
            scales: ScalesFor::default(),
            focus: None,
            page: Page::default(),
            worksheet: false,
            willis: false,
            style: StyleName::default(),
            notation: NotationName::default(),
            sliding: SlidingName::default(),
            coriolis: None,
            center_letter: CenterName::default(),
            frame: None,
            turned: None,
            language: LanguageName::default(),
            decimal: DecimalMark::default(),
            labels: IndexMap::new(),
            special_points: true,
            construction: ConstructionShown::default(),
            values: None,
            step: None,
            trace: Vec::new(),
            beyond_limits: false,
            centrodes: Vec::new(),
            inflection: Vec::new(),
            ghosts: None,
            centers: CentersShown::Usual,
            velocities: Vec::new(),
            curvature: Vec::new(),
            markers: true,
            sizes: None,
            usual_values: None,
        }
    }
}

impl Figure {
    /// Whether sheets to be drawn on have markers: not where the scene says so, nor in a projector's proportions.
    #[must_use]
    pub fn has_markers(&self) -> bool {
        self.markers && self.page.size != PageSize::Wide
    }

    /// The panels that are drawn, in order: with a focus the scheme and the plan in focus.
    #[must_use]
    pub fn shown_panels(&self) -> Vec<Sheet> {
        match self.focus {
            None => self.panels.clone(),
            Some(Sheet::Scheme) => vec![Sheet::Scheme],
            Some(plan) => vec![Sheet::Scheme, plan],
        }
    }

    /// The scale, if it is valid: in units per millimetre of paper, positive, and at most 1e100 as all numbers of
    /// scenes.
    ///
    /// # Errors
    /// The message without its subject.
    pub fn checked_scale(scale: f64) -> Result<f64, Message> {
        if scale > LARGEST {
            return Err(says::scale_too_large(number(scale), format!("{LARGEST:e}")));
        }
        if scale > 0.0 { Ok(scale) } else { Err(says::scale_not_positive(number(scale))) }
    }

    /// Refuses scales, panels and steps that cannot be drawn.
    pub(super) fn check(&self) -> Result<(), Wrong> {
        for (sheet, scale) in self.mu.given() {
            let key = sheet.facts().scale_key;
            if let Err(why) = Figure::checked_scale(scale) {
                return Err(Wrong::value(&[key], says::scale_is(key, why)).hint(says::next_scale()));
            }
        }
        if self.panels.is_empty() {
            let words = Sheet::ALL.map(|sheet| format!("\"{}\"", sheet.as_str()));
            return Err(Wrong::value(&["panels"], says::no_panels()).hint(says::name_panels(words.join(", "))));
        }
        let is_doubled = |&index: &usize| self.panels[..index].contains(&self.panels[index]);
        if let Some(index) = (1..self.panels.len()).find(is_doubled) {
            return Err(Wrong::value(&["panels", &index.to_string()], says::panel_twice()));
        }
        if self.step == Some(0) {
            return Err(Wrong::value(&["step"], says::step_from_one()).hint(says::steps_listed()));
        }
        Ok(())
    }
}

write_forms! { Sheet { word => word.as_str() } }

/// The keys of a figure that a file has to say, with their values.
pub(crate) fn figure_keys(figure: &Figure) -> Map<String, Json> {
    let value = serde_json::from_str(&text_of(figure));
    if let Ok(Json::Object(keys)) = value { keys } else { Map::new() }
}

/// How many ghosts a figure may have.
const GHOSTS: RangeInclusive<usize> = 2..=72;

/// Whether a scene can be followed to other positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Movable {
    /// It can.
    Everywhere,
    /// It is drawn, and stands as it is.
    Drawn,
    /// Profiles that touch are known at their contact alone.
    AtContact,
}

impl Movable {
    /// Whether a scene that is given so, with these contacts, can be followed.
    pub fn of(given_by: GivenBy, contacts: &[Contact]) -> Movable {
        match given_by {
            GivenBy::Drawing => Movable::Drawn,
            GivenBy::Lengths if contacts.iter().all(|contact| contact.is_circular) => Movable::Everywhere,
            GivenBy::Lengths => Movable::AtContact,
        }
    }
}

/// Refuses paths of what is no point of a moving link, and paths and ghosts where nothing can be moved.
pub(super) fn check_traced(
    movable: Movable,
    names: &Names<'_>,
    sliders: &[Slider],
    figure: &Figure,
) -> Result<(), Wrong> {
    for (index, point) in figure.trace.iter().enumerate() {
        let path = ["trace", &index.to_string()];
        check_point(&path, names, point)?;
        if figure.trace[..index].contains(point) {
            return Err(Wrong::value(&path, says::point_twice(point)));
        }
    }
    for (key, links) in [("centrodes", &figure.centrodes), ("inflection", &figure.inflection)] {
        for (index, link) in links.iter().enumerate() {
            let path = [key, &index.to_string()];
            names.link(&path, link)?;
            if links[..index].contains(link) {
                return Err(Wrong::value(&path, says::link_twice(link)));
            }
        }
    }
    if let Some(count) = figure.ghosts.filter(|count| !GHOSTS.contains(count)) {
        let (least, most) = (GHOSTS.start(), GHOSTS.end());
        let message = says::ghosts_between(*least, *most, count);
        return Err(Wrong::value(&["ghosts"], message));
    }
    let (key, drawn, undriven) = match (figure.trace.first(), figure.centrodes.first(), figure.ghosts) {
        (Some(point), ..) => ("trace", says::drawn_has_no_path(point), says::no_drive_no_path(point)),
        (None, Some(link), _) => ("centrodes", says::drawn_has_no_centrodes(link), says::no_drive_no_centrodes(link)),
        (None, None, Some(_)) => ("ghosts", says::drawn_has_no_ghosts(), says::no_drive_no_ghosts()),
        (None, None, None) => return Ok(()),
    };
    match movable {
        Movable::Drawn => return Err(Wrong::value(&[key], drawn).hint(says::lengths_and_drive())),
        Movable::AtContact => {
            return Err(Wrong::value(&[key], says::at_contact_alone()).hint(says::say_circular()));
        }
        Movable::Everywhere => {}
    }
    let is_driven = names.links.values().any(|link| link.drive.is_some()) || sliders.iter().any(|s| s.drive.is_some());
    if !is_driven {
        return Err(Wrong::value(&[key], undriven).hint(says::give_drive()));
    }
    Ok(())
}

/// Refuses what is no point of a moving link: other names, points of the ground, special points, points under others.
fn check_point(path: &[&str], names: &Names<'_>, point: &str) -> Result<(), Wrong> {
    let moving = || {
        let of_links = names.links.values().flat_map(|link| &link.points).map(String::as_str);
        let moving: IndexSet<&str> = of_links.filter(|name| !names.on_ground(name)).collect();
        says::moving_points(list(moving))
    };
    if names.on_ground(point) {
        return Err(Wrong::value(path, says::ground_has_no_path(point)).hint(moving()));
    }
    if names.is_point(point) {
        return Ok(());
    }
    if names.check_reserved(point).is_err() {
        return Err(Wrong::value(path, says::name_of_construction(shortened(point))).hint(moving()));
    }
    names.point(path, point)
}
