//! The figure while its drive runs: one picture after another, at equal times.

use super::held_layout::HeldLayout;
use super::says;
use super::sheet::Drawing;
use super::steady::Steady;
use super::style::Style;
use crate::Problem;
use crate::construction::Solution;
use crate::cycle::{CycleError, Running};
use crate::message::Message;

/// How long a film lasts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    /// Seconds for a turn of the drive, or for going to and fro once.
    pub seconds: f64,
    /// Pictures a second.
    pub per_second: u16,
}

impl Default for Timing {
    /// A turn in five seconds.
    fn default() -> Self {
        Timing { seconds: 5.0, per_second: 20 }
    }
}

impl Timing {
    /// The longest turn, in seconds.
    pub const LONGEST: f64 = 120.0;
    /// Most pictures a second: what shows GIF shows no more.
    pub const MOST_PER_SECOND: u16 = 50;

    /// Pictures in a turn.
    ///
    /// # Errors
    /// The time or the rate is out of bounds, or there would be no motion.
    fn pictures(self) -> Result<usize, CycleError> {
        let Timing { seconds, per_second } = self;
        let refuse = |message: Message, hint: Message| Err(CycleError::Range(Problem::new(message).hint(hint)));
        if !(seconds > 0.0 && seconds <= Timing::LONGEST) {
            return refuse(says::no_film_of(seconds), says::at_most_seconds(Timing::LONGEST));
        }
        if !(1..=Timing::MOST_PER_SECOND).contains(&per_second) {
            let hint = says::pictures_a_second(usize::from(Timing::MOST_PER_SECOND));
            return refuse(says::no_film_at(usize::from(per_second)), hint);
        }
        match (seconds * f64::from(per_second)).round() as usize {
            count @ 2.. => Ok(count),
            _ => refuse(says::no_motion(seconds, usize::from(per_second)), says::longer_or_more()),
        }
    }
}

/// Seconds for which a name stays in its place, or else is left out.
const STAYS: f64 = 0.4;
/// Most pictures of a film.
const MOST: usize = 2000;

/// The figure of a solved scene while a drive runs over and over: one cycle, after the last picture of which the first
/// comes without a jump.
///
/// Scales, panels and poles are those of the whole cycle, and names stay where they were as long as they are
/// clear there; one that cannot stay for 0.4 seconds is left out for that time. The plans are those for the drive's speed in the scene, also where it goes back. Values are written where the
/// figure asks for them, but not for a style's sake: they change faster than they are read.
///
/// ```
/// use kinegon::drawing::{Film, Timing};
///
/// let scene = kinegon::Scene::read(include_str!("../../templates/four-bar.json"))?;
/// let solution = kinegon::solve(&scene)?;
/// let film = Film::new(&solution, None, Timing { seconds: 2.0, per_second: 10 })?;
/// assert_eq!(film.drawings().count(), 20);
/// # Ok::<(), kinegon::Error>(())
/// ```
#[derive(Clone)]
pub struct Film {
    own: Solution,
    running: Running,
    per_second: u16,
    /// With the names where they are after a cycle.
    layout: HeldLayout,
    steady: Steady,
    style: Option<Style>,
}

impl Film {
    /// The film of a solution's finished figure with the drive of this name, without one with the first.
    ///
    /// # Errors
    /// There is no drive that moves, its branch cannot be followed, or the film would have no motion or too many
    /// pictures.
    pub fn new(own: &Solution, drive: Option<&str>, timing: Timing) -> Result<Self, CycleError> {
        let running = Film::positions(own, drive, timing)?;
        let count = running.poses.len();
        let mut own = own.clone();
        own.scene.figure.usual_values = Some(false);
        let layout = HeldLayout::of_film(&own, drive);
        let mut film =
            Film { own, running, per_second: timing.per_second, layout, steady: Steady::default(), style: None };
        let mut layout = film.layout.clone();
        (0..count).for_each(|number| drop(film.drawing(&mut layout, number)));
        film.layout = layout;
        film.steady = Steady::of(film.drawings(), (STAYS * f64::from(timing.per_second)).ceil() as usize);
        Ok(film)
    }

    /// The positions of a film's pictures, before any is drawn: drawing each takes milliseconds, or many of them where names
    /// are many.
    ///
    /// # Errors
    /// As [`Film::new`].
    pub fn positions(own: &Solution, drive: Option<&str>, timing: Timing) -> Result<Running, CycleError> {
        let running = Running::new(own, drive, timing.pictures()?)?;
        let count = running.poses.len();
        if count > MOST {
            let message = match running.turns.filter(|turns| *turns > 1) {
                Some(turns) => says::film_of_turns_too_long(count, turns, MOST),
                None => says::film_too_long(count, MOST),
            };
            return Err(CycleError::Range(Problem::new(message).hint(says::less_or_fewer())));
        }
        if count < 2 {
            return Err(CycleError::Range(says::drive_stands(&running.drive.name).into()));
        }
        Ok(running)
    }

    /// The film in another style; sizes of letters and signs stay.
    #[must_use]
    pub fn in_style(self, style: Style) -> Self {
        Film { style: Some(style), ..self }
    }

    /// Pictures a second.
    #[must_use]
    pub fn per_second(&self) -> u16 {
        self.per_second
    }

    /// The positions of its pictures.
    #[must_use]
    pub fn running(&self) -> &Running {
        &self.running
    }

    /// The layout that all pictures share, with the names where they are before the first.
    #[must_use]
    pub fn layout(&self) -> &HeldLayout {
        &self.layout
    }

    /// The pictures, one after another. A position without a definite motion is shown as the one before.
    pub fn drawings(&self) -> impl Iterator<Item = Drawing> + '_ {
        self.every(1)
    }

    /// Every so many pictures. Names are not where they are among all.
    pub(crate) fn every(&self, step: usize) -> impl Iterator<Item = Drawing> + '_ {
        let mut layout = self.layout.clone();
        let mut before = None;
        (0..self.running.poses.len()).step_by(step).filter_map(move |number| {
            before = self.drawing(&mut layout, number).or(before.take());
            before.clone()
        })
    }

    /// The picture of a number, from 0, on a layout that has drawn the one before; none in a position without a definite
    /// motion.
    fn drawing(&self, layout: &mut HeldLayout, number: usize) -> Option<Drawing> {
        let pose = self.running.poses.get(number)?;
        let moved = self.own.moved(pose.clone()).ok()?;
        let mut drawing = layout.drag(&moved, None, None);
        self.steady.leave_out(number, &mut drawing);
        if let Some(style) = &self.style {
            drawing.style = style.clone();
        }
        Some(drawing)
    }
}
