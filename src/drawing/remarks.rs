//! The sentences below the panels: on paths, and on how two routes agree.

use super::context::SheetContext;
use super::lines::Lines;
use super::view::Series;
use crate::construction::kennedy::missing_of_centers;
use crate::construction::{FigureOf, contacts_told};
use crate::cycle::{Centrode, Times, told_engagement};
use crate::forces::Source;
use crate::geometry::Place;
use crate::text::Untrusted;
use crate::words::{Medium, NumberStyle};

/// Number style of values in tables and words.
pub(super) const VALUE: NumberStyle = NumberStyle::significant(5).in_full(-4, 7).on(Medium::Figure);
/// Number style of lengths on paper and angles.
pub(super) const HUNDREDTHS: NumberStyle = NumberStyle::decimals(2).on(Medium::Figure);
/// Number style of the steps between ticks.
const STEP: NumberStyle = NumberStyle::significant(3).trimmed().in_full(-3, 6).on(Medium::Figure);
/// Number style of the diameter of an inflection circle.
const DIAMETER: NumberStyle = NumberStyle::significant(4).trimmed().in_full(-3, 6).on(Medium::Figure);
/// Number style of the difference between construction and loop equations.
const BOUND: NumberStyle = NumberStyle::bound().on(Medium::Figure);

/// The sentences on paths, if there are any, and on how the construction agrees with the loop equations. In the place of a list of
/// results and on a projector only what is not as it should be is said. They are there in all steps or only in `step`;
/// `beside` mm of the width are kept free.
pub(super) fn agreement(context: &SheetContext<'_>, step: Option<u16>, beside: f64, has_list: bool) -> Lines {
    let (sentence, agrees) = routes(context);
    let sentence = [sentence, forces(context).unwrap_or_default()].map(|said| said.trim().to_owned());
    let sentence = sentence.into_iter().filter(|said| !said.is_empty()).collect::<Vec<_>>().join(" ");
    let is_projected = context.surface.series == Series::Any || context.surface.dims.unit > 1.0;
    let is_said = !agrees || (!has_list && !is_projected);
    // On a screen there is no paper to be measured on.
    let printed = (context.surface.series != Series::Any).then(|| context.words.language.printed().to_owned());
    let sentence = is_said.then(|| {
        std::iter::once(sentence).filter(|said| !said.is_empty()).chain(printed).collect::<Vec<_>>().join(" ")
    });
    let paths = sentence_on_paths(context).into_iter();
    let sentences: Vec<String> = paths.chain(on_centers(context)).chain(sentence).collect();
    let together = (!sentences.is_empty()).then(|| sentences.join(" "));
    Lines { step, ..Lines::of(&together, context.surface.dims.width_below() - beside) }
}

/// The sentences on instant centres that were asked for and do not stand on their panel, in markup.
fn on_centers(context: &SheetContext<'_>) -> Vec<String> {
    let Some(centers) = context.construction().centers.as_deref() else { return Vec::new() };
    let far = centers.by_rates.iter().filter(|(_, place)| matches!(place, Some(Place::AtInfinity(_))));
    let far = far.map(|(pair, _)| context.center_symbol(*pair, FigureOf::Mechanism));
    let far = far.map(|symbol| format!("{}.", context.words.language.at_infinity(&symbol)));
    let curved = centers.curvatures.iter().map(|found| {
        let point = context.told(context.mechanism().point_name(found.point), None);
        let unit = context.solution.scene.units.length.as_str();
        match found.radius {
            Some(radius) => {
                let radius = format!("{} {unit}", context.words.write(radius, DIAMETER));
                context.words.language.radius_of_curvature(&point, &radius)
            }
            None => context.words.language.no_radius_of_curvature(&point),
        }
    });
    far.chain(curved).chain(missing_of_centers(centers, context.mechanism(), &context.words)).collect()
}

/// The sentence on paths alone, which holds for all positions.
pub(super) fn paths(context: &SheetContext<'_>) -> Lines {
    Lines::of(&sentence_on_paths(context), context.surface.dims.width_below())
}

/// The sentence on the agreement of the construction with the loop equations, and whether they agree.
fn routes(context: &SheetContext<'_>) -> (String, bool) {
    let (language, construction) = (context.words.language, context.construction());
    // A figure of centres without plans says how these agree.
    let has_plan = context.figure().shown_panels().iter().any(|panel| panel.order().is_some());
    if let (false, Some(centers)) = (has_plan, &construction.centers) {
        let Some(worst) = centers.agreement else { return (String::new(), true) };
        let [difference, allowed] = [worst.difference, worst.allowed].map(|x| context.words.write(x, BOUND));
        return (language.centers_differ(&difference, &allowed), true);
    }
    if !has_plan && construction.forces.is_some() {
        return (String::new(), true);
    }
    let known = construction.agreement.iter().flatten();
    let worst = known.max_by(|a, b| a.difference.total_cmp(&b.difference));
    match worst {
        Some(worst) if construction.agreement.iter().all(Option::is_some) => {
            let [difference, allowed] = [worst.difference, worst.allowed].map(|x| context.words.write(x, BOUND));
            (language.agreement(&difference, &allowed), true)
        }
        _ => {
            let far = construction.special.iter().any(|special| special.place.finite().is_none());
            let why = if far { language.one_route_far() } else { language.one_route() };
            (why.to_owned(), false)
        }
    }
}

/// The sentence on the agreement of a force plan with the equations of equilibrium.
fn forces(context: &SheetContext<'_>) -> Option<String> {
    let worst = context.construction().forces.as_ref()?.agreement?;
    let [difference, allowed] = [worst.difference, worst.allowed].map(|x| context.words.write(x, BOUND));
    Some(context.words.language.forces_differ(&difference, &allowed))
}

/// The sentence on friction among the loads of a plan.
fn friction(context: &SheetContext<'_>) -> Option<String> {
    let mut loads = context.construction().forces.as_ref()?.loads.iter();
    let is_there = loads.any(|load| matches!(load.source, Source::Friction(_)));
    is_there.then(|| context.words.language.friction_told().to_owned())
}

/// The sentences on what the scheme shows of a cycle besides the position, and on inflection circles, in markup.
pub(super) fn sentence_on_paths(context: &SheetContext<'_>) -> Option<String> {
    let shown = |name: &str| context.told(name, None);
    let contacts = contacts_told(context.mechanism(), &context.words, &shown).into_iter();
    let off = context.solution.off_guides().map(|message| sentence(&context.words.language.says(&message)));
    let engaged = told_engagement(context.solution, &context.words, Medium::Figure);
    let turned = context.teller().turned_in_speeds(&shown);
    let told = contacts.chain(off).chain(engaged).chain(friction(context)).chain(turned);
    let all = told.chain(ticks(context)).chain(centrodes(context)).chain(inflection(context));
    let all: Vec<String> = all.collect();
    (!all.is_empty()).then(|| all.join(" "))
}

/// A warning as a sentence of its own.
fn sentence(warning: &str) -> String {
    let mut letters = warning.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).chain(['.']).collect()
}

/// The sentences on centrodes: of which links, and of which there are none.
fn centrodes(context: &SheetContext<'_>) -> impl Iterator<Item = String> {
    let (language, all) = (context.words.language, &context.traces.centrodes);
    let has_curve = |centrode: &&Centrode| !centrode.fixed.is_empty();
    let listed = |of: Vec<&Centrode>| {
        let names: Vec<String> = of.iter().map(|centrode| context.shown(&centrode.name, None)).collect();
        (!names.is_empty()).then(|| names.join(", "))
    };
    let (with, without): (Vec<&Centrode>, Vec<&Centrode>) = all.iter().partition(has_curve);
    let with = listed(with).map(|links| language.centrodes(&links));
    with.into_iter().chain(listed(without).map(|links| language.no_centrodes(&links)))
}

/// The sentences on inflection circles, each with its diameter.
fn inflection(context: &SheetContext<'_>) -> impl Iterator<Item = String> {
    let (solution, language) = (context.solution, context.words.language);
    context.figure().inflection.iter().map(move |name| {
        let link = context.shown(name, None);
        match solution.inflection_circle(name) {
            Some((id, [pole, inflection])) => {
                let unit = solution.scene.units.length.as_str();
                let diameter = context.words.write((inflection - pole).norm(), DIAMETER);
                let [center, pole] = context.ends_of_inflection_circle(id);
                language.inflection_circle(&link, &format!("{diameter} {unit}"), &center, &pole)
            }
            None => language.no_inflection_circle(&link),
        }
    })
}

/// The sentence on the paths and their ticks, in markup.
fn ticks(context: &SheetContext<'_>) -> Option<String> {
    let Times { drive, step, time, .. } = context.traces.times.as_ref()?;
    let shown = |name: &str| context.shown(name, None);
    let points: Vec<String> = context.traces.paths.iter().map(|path| shown(&path.name)).collect();
    let (language, units) = (context.words.language, context.solution.scene.units);
    let number = |value: f64| context.words.write(value, STEP);
    let step = match drive.is_angle {
        true => format!("{}°", number(*step)),
        false => format!("{} {}", number(*step), units.length.as_str()),
    };
    let drive = context.figure().labels.get(&drive.name).map_or_else(|| drive.name.clone(), Untrusted::for_setting);
    let points = points.join(", ");
    let mut sentence = match time {
        Some(time) => {
            let time = format!("{} {}", number(*time), units.time.as_str());
            language.paths_in_time(&points, &step, &drive, &time)
        }
        None => language.paths(&points, &step, &drive),
    };
    if context.traces.paths.iter().any(|path| !path.beyond.is_empty()) {
        sentence = format!("{sentence} {}", language.paths_beyond());
    }
    Some(sentence)
}
