use crate::answers::{Drive, Running, View};
use crate::refused::Refused;
use kinegon::cycle::{self, OtherModes, Pull};
use kinegon::drawing::{HeldLayout, Positions, Steps};
use kinegon::mechanism::Mechanism;
use kinegon::position::Pose;
use kinegon::quantity::{Quantity, QuantityRequest};
use kinegon::scene::{LanguageName, SizeLimit};
use kinegon::words::{Language, Wording};
use kinegon::{Order, Sheet};
use kinegon::{Scene, Solution, order_of_figure, posed};
use std::borrow::Cow;

/// The last scene, solved as far as was asked for.
#[derive(Default)]
pub struct Desk {
    kept: Option<Kept>,
    /// The language of what is told beside the picture; none for the figure's.
    language: Option<LanguageName>,
}

/// A scene in its position.
pub struct Kept {
    text: String,
    pub scene: Scene,
    pub mechanism: Mechanism,
    pub pose: Pose,
    /// Solved for velocities, and for accelerations.
    solved: [Option<Solution>; 2],
    drives: Option<Vec<Drive>>,
    stage: Option<Staged>,
    positions: Option<Positions>,
    held: Option<Held>,
}

/// The stage of a view.
pub struct Staged {
    view: View,
    pub own: Solution,
    pub stage: HeldLayout,
    pub modes: Option<OtherModes>,
    /// The layout of the last gesture, from which this one is reached.
    pub before: Option<HeldLayout>,
}

/// The layout that was held in the last gesture.
pub struct Held {
    pub view: View,
    pub layout: HeldLayout,
    /// Scenes in positions that a drive took on it: it stays theirs when the hand lets go, also where undo leads back to them.
    pub texts: Vec<String>,
}

/// Most positions that are remembered.
const MOST_HELD: usize = 100;

impl Desk {
    /// Chooses the language of what is told beside the picture.
    pub fn speak(&mut self, language: &str) {
        self.language = LanguageName::ALL.into_iter().find(|known| known.as_str() == language);
    }

    /// The language that is chosen; none for the figure's.
    pub fn spoken(&self) -> Option<LanguageName> {
        self.language
    }

    /// The language in which refusals and warnings are told: English where none is chosen.
    pub fn language(&self) -> &'static Language {
        self.language.map_or_else(|| Wording::default().language, Language::of)
    }

    /// As [`Self::solution`], with the words of the page.
    pub fn told(&mut self, text: &str) -> Result<Cow<'_, Solution>, Refused> {
        let language = self.language;
        Ok(in_words(self.solution(text)?, language))
    }

    /// The scene of this text in its position, and the language of what is told of it.
    pub fn kept_with_language(&mut self, text: &str) -> Result<(&mut Kept, Option<LanguageName>), Refused> {
        let language = self.language;
        Ok((self.kept(text)?, language))
    }

    /// The scene of this text in its position.
    pub fn kept(&mut self, text: &str) -> Result<&mut Kept, Refused> {
        if self.kept.as_ref().is_none_or(|kept| kept.text != text) {
            let next = Kept::of(text).map_err(|error| Refused::of(text, error))?;
            let held = self.kept.take().and_then(|kept| kept.held);
            self.kept = Some(Kept { held, ..next });
        }
        self.kept.as_mut().ok_or_else(|| Refused::whole("there is no scene"))
    }

    /// Keeps the layout of a gesture that is over; `positions` are the scenes before and after it, where a drive moved.
    pub fn hold(&mut self, view: View, layout: HeldLayout, positions: Option<[String; 2]>) {
        let Some(kept) = &mut self.kept else { return };
        let before = kept.held.take().filter(|held| view.is_laid_out_as(&held.view)).map(|held| held.texts);
        let texts = positions.map(|[from, to]| {
            // Where it was at rest it is so again, when what was done is taken back.
            let mut texts = before.filter(|texts| texts.contains(&from)).unwrap_or_default();
            texts.push(to);
            texts.drain(..texts.len().saturating_sub(MOST_HELD));
            texts
        });
        kept.held = Some(Held { view, layout, texts: texts.unwrap_or_default() });
    }

    /// The scene of this text solved for what is drawn by hand.
    pub fn solution(&mut self, text: &str) -> Result<&Solution, Refused> {
        let kept = self.kept(text)?;
        kept.check(SizeLimit::HAND)?;
        kept.solution(Order::Acceleration)
    }
}

impl Kept {
    fn of(text: &str) -> Result<Kept, kinegon::Error> {
        let scene = Scene::read(text)?;
        let (mechanism, pose) = posed(&scene, SizeLimit::NUMBERS, None)?;
        Ok(Kept {
            text: text.to_owned(),
            scene,
            mechanism,
            pose,
            solved: [None, None],
            drives: None,
            stage: None,
            positions: None,
            held: None,
        })
    }

    /// Refuses what the scene is too large for.
    pub fn check(&self, limit: SizeLimit) -> Result<(), Refused> {
        limit.check(&self.scene).map_err(|error| self.refused(error))
    }

    /// An error of this scene.
    pub fn refused(&self, error: impl Into<kinegon::Error>) -> Refused {
        Refused::of(&self.text, error)
    }

    /// The scene solved for this order of motion.
    pub fn solution(&mut self, order: Order) -> Result<&Solution, Refused> {
        let solution = match self.solved[order].take() {
            Some(solution) => solution,
            None => Solution::new(self.scene.clone(), self.mechanism.clone(), self.pose.clone(), order)
                .map_err(|error| self.refused(error))?,
        };
        Ok(self.solved[order].insert(solution))
    }

    /// The scene solved for its figure.
    pub fn figure(&mut self) -> Result<&Solution, Refused> {
        self.check(SizeLimit::FIGURE)?;
        self.solution(order_of_figure(&self.scene))
    }

    /// The drives and where they stand; how far they reach only of a scene that can be moved by hand.
    pub fn drives(&mut self) -> Result<Vec<Drive>, Refused> {
        if let Some(drives) = &self.drives {
            return Ok(drives.clone());
        }
        let has_ranges = self.check(SizeLimit::STEPS).is_ok();
        let solution = self.solution(order_of_figure(&self.scene))?;
        let names = solution.mechanism.drive_names().into_iter();
        let drives: Vec<Drive> = names.filter_map(|name| drive(solution, &name, has_ranges)).collect();
        Ok(self.drives.insert(drives).clone())
    }

    /// How it runs; none where no drive has a speed.
    pub fn running(&mut self) -> Result<Option<Running>, Refused> {
        let own = self.solution(order_of_figure(&self.scene))?;
        let running = cycle::Drive::leading(&own.mechanism).and_then(|leading| {
            let Some(drive) = leading else { return Ok(None) };
            let mut pull = Pull::together(own, Some(&drive.name))?;
            let [low, high] = pull.ends().map(|end| end.map(|end| end.at));
            let cycle::Running { turns, is_backwards, .. } = cycle::Running::new(own, Some(&drive.name), 1)?;
            Ok(Some(Running { drive: drive.name, is_backwards, low, high, turns }))
        });
        running.map_err(|error| self.refused(error))
    }

    /// The stage of a view.
    pub fn stage(&mut self, view: &View) -> Result<&Staged, Refused> {
        self.check(SizeLimit::STEPS)?;
        let is_same = |staged: &Staged| view.is_laid_out_as(&staged.view);
        let staged = match self.stage.take().filter(is_same) {
            Some(staged) => staged,
            None => {
                let mut own = self.figure()?.clone();
                if let Some(panels) = &view.panels {
                    let is_asked = |panel: &Sheet| panels.iter().any(|name| name == panel.as_str());
                    own.scene.figure.panels = Sheet::ALL.into_iter().filter(is_asked).collect();
                    own.scene.figure.focus = None;
                    // They are found by construction: without plans they are asked for, as on an exercise's sheet.
                    own.scene.figure.special_points &=
                        own.scene.figure.panels.iter().any(|panel| *panel != Sheet::Scheme);
                } else if view.pane.is_some() && view.focus.is_some() {
                    own.scene.figure.focus = view.focus;
                }
                let further = view.trace.iter().filter(|point| !own.scene.figure.trace.contains(point));
                let further =
                    further.filter(|point| own.scene.check_traced(std::slice::from_ref(*point), None).is_ok());
                let further: Vec<String> = further.cloned().collect();
                own.scene.figure.trace.extend(further);
                let modes = if view.modes { OtherModes::of(&own).ok() } else { None };
                let steps = view.step.map(|_| if view.coarse { Steps::Coarse } else { Steps::Fine });
                let held = self.held.as_ref().filter(|held| view.is_laid_out_as(&held.view));
                let stage = match (held.filter(|held| held.texts.contains(&self.text)), view.pane) {
                    (Some(held), Some(_)) => held.layout.clone(),
                    (_, Some(pane)) => {
                        let positions = self.positions.get_or_insert_with(|| Positions::of(&own));
                        let cycle = HeldLayout::of_positions(&own, positions, steps, modes.as_ref(), Some(pane.into()));
                        cycle.at_rest(&own)
                    }
                    (_, None) => HeldLayout::of_figure(&own, steps, modes.as_ref()),
                };
                let before = held.map(|held| held.layout.clone());
                Staged { view: view.clone(), own, stage, modes, before }
            }
        };
        Ok(self.stage.insert(staged))
    }

    /// The stage of a view, to be kept elsewhere.
    pub fn take_stage(&mut self, view: &View) -> Result<Staged, Refused> {
        self.stage(view)?;
        self.stage.take().ok_or_else(|| Refused::whole("there is no picture"))
    }
}

/// A solution with a figure in this language, if one is given.
pub fn in_words(solution: &Solution, language: Option<LanguageName>) -> Cow<'_, Solution> {
    let Some(language) = language.filter(|language| *language != solution.scene.figure.language) else {
        return Cow::Borrowed(solution);
    };
    let mut told = solution.clone();
    told.scene.figure.language = language;
    Cow::Owned(told)
}

/// A drive of a solved scene, where it stands.
fn drive(solution: &Solution, name: &str, has_range: bool) -> Option<Drive> {
    let words = solution.wording();
    let drive = cycle::Drive::new(&solution.mechanism, Some(name)).ok()?;
    let asked = QuantityRequest::new(&drive.quantity, &solution.mechanism).ok()?;
    let Ok(Quantity::Number(value)) = asked.value(&solution.snapshot(), None, None) else { return None };
    let mut moved = Drive {
        name: name.to_owned(),
        is_angle: drive.is_angle,
        value,
        shown: drive.shown(value, &words),
        low: None,
        high: None,
    };
    if has_range && let Ok(mut pull) = Pull::new(solution, Some(name)) {
        moved.value = pull.value();
        moved.shown = drive.shown(moved.value, &words);
        [moved.low, moved.high] = pull.ends().map(|end| end.map(|end| end.at));
    }
    Some(moved)
}
