use super::CycleError;
use crate::geometry::{degrees_of, span};
use crate::kernel::{Input, InputKind, Kernel};
use crate::mechanism::{Mechanism, Role, SliderId};
use crate::position::Pose;
use crate::words::{Medium, NumberStyle, Wording, certain_angle};

/// A drive that is moved through a range; its value is the link's angle in degrees, or the slider's position along the
/// guide.
#[derive(Clone, Debug)]
pub struct Drive {
    /// Its name: that of the driven link, or of the slider on a moving link, as in `3/2`.
    pub name: String,
    /// The name of its value as a quantity, as in `angle(1)` or `position(4/ground)`.
    pub quantity: String,
    /// Whether its value is an angle in degrees; else it is a length.
    pub is_angle: bool,
    pub(super) input: usize,
    /// The size of the largest link, in units of length.
    size: f64,
}

impl Drive {
    /// The drive of that name, one of [`Mechanism::drive_names`]; without a name the first of them.
    ///
    /// # Errors
    /// There is no such drive, or no drive at all.
    pub fn new(mechanism: &Mechanism, name: Option<&str>) -> Result<Self, CycleError> {
        let kernel = moving(mechanism)?;
        let names = mechanism.drive_names();
        let input = match name {
            None if names.is_empty() => return Err(CycleError::NoDrive),
            None => 0,
            Some(name) => names.iter().position(|n| n == name).ok_or_else(|| {
                let known = names.join(", ");
                CycleError::NoSuchDrive { name: crate::text::shown(name), known }
            })?,
        };
        let name = names[input].clone();
        let quantity = match kernel.inputs[input].kind {
            InputKind::Turning { .. } => format!("angle({name})"),
            InputKind::Sliding { slider } => {
                format!("position({})", mechanism.slider_name(SliderId(slider)))
            }
        };
        let is_angle = matches!(kernel.inputs[input].kind, InputKind::Turning { .. });
        let size = mechanism.bodies.iter().map(|body| span(body.local.iter().copied())).fold(0.0, f64::max);
        Ok(Drive { name, quantity, is_angle, input, size })
    }

    /// The drive that leads when all run as the scene says: the first that has a speed there; none where all stand still.
    ///
    /// # Errors
    /// The configuration is drawn.
    pub fn leading(mechanism: &Mechanism) -> Result<Option<Self>, CycleError> {
        let kernel = moving(mechanism)?;
        let names = mechanism.drive_names().into_iter().zip(&kernel.inputs);
        let mut running = names.filter(|(_, input)| input.rate != 0.0);
        running.next().map(|(name, _)| Self::new(mechanism, Some(&name))).transpose()
    }

    /// The drive at this value, in words, as in `angle(1) = 30°`.
    #[must_use]
    pub fn at(&self, value: f64, words: &Wording) -> String {
        self.at_within(value, 0.0, words)
    }

    /// The same of a value that may be off, with certain digits only.
    pub(super) fn at_within(&self, value: f64, within: f64, words: &Wording) -> String {
        format!("{} = {}", self.quantity, words.number(self.amount_within(value, within)))
    }

    /// A value with its unit, as in `30°`.
    #[must_use]
    pub fn amount(&self, value: f64) -> String {
        self.amount_within(value, 0.0)
    }

    /// The same of a value that may be off, with certain digits only.
    pub(crate) fn amount_within(&self, value: f64, within: f64) -> String {
        if self.is_angle {
            return certain_angle(value, within);
        }
        let certain = if within > 0.0 { libm::floor(libm::log10(value.abs() / (2.0 * within))) + 1.0 } else { 12.0 };
        // Where no digit is certain there is one that is as large as the error.
        format!("{}", shortened(snapped(value, self.size), certain.clamp(1.0, 12.0) as usize))
    }

    /// A value as it is shown while the drive moves: an angle with one decimal of a degree, a length with four significant
    /// digits.
    #[must_use]
    pub fn shown(&self, value: f64, words: &Wording) -> String {
        let decimals = |count: usize| words.write(value, NumberStyle::decimals(count).on(Medium::Figure));
        if self.is_angle {
            return format!("{}°", decimals(1));
        }
        let digits = 3.0 - libm::floor(libm::log10(value.abs().max(1e-3)));
        decimals(digits.max(0.0) as usize)
    }
}

/// A value that is known to a millionth of a millionth of `whole`: zero where it is less.
pub(super) fn snapped(value: f64, whole: f64) -> f64 {
    if value.abs() < 1e-12 * whole { 0.0 } else { value }
}

/// The nearest number with so many decimal digits.
pub(super) fn shortened(value: f64, digits: usize) -> f64 {
    let text = format!("{value:.*e}", digits - 1);
    text.parse().unwrap_or(value) + 0.0
}

/// `mechanism` with all drives at rest but the one of this name.
#[must_use]
pub fn alone(mechanism: &Mechanism, drive: &str) -> Mechanism {
    let mut alone = mechanism.clone();
    for body in alone.bodies.iter_mut().filter(|b| b.name != drive) {
        if let Role::Driver { omega, alpha, .. } = &mut body.role {
            (*omega, *alpha) = (0.0, 0.0);
        }
    }
    for (id, slider) in alone.sliders.iter_mut().enumerate() {
        if let Some(push) = &mut slider.drive
            && mechanism.push_name(SliderId(id)) != drive
        {
            (push.speed, push.acceleration) = (0.0, 0.0);
        }
    }
    alone
}

/// The names of the drives that take a mechanism through different positions while all run as the scene says: of those that
/// turn equally fast the first.
pub(crate) fn differing_drives(mechanism: &Mechanism) -> Vec<String> {
    let names = mechanism.drive_names();
    let Some(kernel) = Kernel::new(mechanism) else { return names };
    let mut speeds: Vec<f64> = Vec::new();
    let differs = |input: &Input| {
        // One that stands still moves the mechanism alone, and a slider's way is no turn.
        let is_known = matches!(input.kind, InputKind::Turning { .. }) && speeds.contains(&input.rate.abs());
        if matches!(input.kind, InputKind::Turning { .. }) && input.rate != 0.0 {
            speeds.push(input.rate.abs());
        }
        !is_known
    };
    let differ: Vec<bool> = kernel.inputs.iter().map(differs).collect();
    names.into_iter().zip(differ).filter_map(|(name, differs)| differs.then_some(name)).collect()
}

/// A drive's value: the one that the scene gives, or else that of the pose.
pub(super) fn stands(input: &Input, pose: &Pose) -> f64 {
    let found = match input.kind {
        InputKind::Turning { .. } => pose.axes[input.body.0].map(degrees_of),
        InputKind::Sliding { slider } => pose.slides[slider],
    };
    input.value.or(found).unwrap_or(0.0)
}

/// The rate of each drive per unit rate of the moved one, in degrees and lengths; zeros where that stands still.
pub(super) fn ratios(inputs: &[Input], moved: usize) -> Vec<f64> {
    let speed = |input: &Input| match input.kind {
        InputKind::Turning { .. } => input.rate.to_degrees(),
        InputKind::Sliding { .. } => input.rate,
    };
    let by = speed(&inputs[moved]);
    let ratio = |(index, input): (usize, &Input)| match index == moved {
        true => 1.0,
        false if by == 0.0 => 0.0,
        false => speed(input) / by,
    };
    inputs.iter().enumerate().map(ratio).collect()
}

/// A change or a rate of a drive's value in the kernel's unit: of an angle in radians.
#[inline]
pub(super) fn in_radians(kind: InputKind, change: f64) -> f64 {
    match kind {
        InputKind::Turning { .. } => change.to_radians(),
        InputKind::Sliding { .. } => change,
    }
}

/// The actions by which a mechanism is moved.
///
/// # Errors
/// It is known in its own position alone.
pub(super) fn moving(mechanism: &Mechanism) -> Result<Kernel, CycleError> {
    if mechanism.is_momentary() {
        return Err(CycleError::AtContact);
    }
    Kernel::new(mechanism).ok_or(CycleError::Drawn)
}
