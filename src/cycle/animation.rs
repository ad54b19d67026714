use super::{CycleError, Drive, Path};
use crate::construction::Solution;

/// Distance that an animation keeps from each end of the drive's range, in parts of the range: at a limit position
/// rates are infinite.
const OFF_THE_END: f64 = 0.004;

/// A mechanism solved at equal steps of a drive, for showing one position after another.
#[derive(Clone, Debug)]
pub struct Animation {
    /// The drive; `None` for a drawn configuration or a mechanism without a drive, which have one position.
    pub drive: Option<Drive>,
    /// The drive's values in degrees or lengths, rising; a single zero without a drive.
    pub values: Vec<f64>,
    /// The mechanism solved at each value.
    pub positions: Vec<Solution>,
    /// Index of the scene's own position.
    pub own: usize,
    /// Whether the first position follows the last: the drive turns all the way round.
    pub is_round: bool,
}

impl Animation {
    /// About `count` positions over the whole range that the drive of this name (without one, the first) can reach on
    /// the branch of the solution's own position, and that position itself. Positions without a definite motion are
    /// left out.
    ///
    /// # Errors
    /// There is no drive of that name, or the branch cannot be followed.
    pub fn new(own: &Solution, drive: Option<&str>, count: usize) -> Result<Self, CycleError> {
        let (mechanism, pose) = (&own.mechanism, &own.pose);
        let still = Self { drive: None, values: vec![0.0], positions: vec![own.clone()], own: 0, is_round: false };
        let drive = match Drive::new(mechanism, drive) {
            Ok(drive) => drive,
            Err(CycleError::Drawn | CycleError::NoDrive) => return Ok(still),
            Err(error) => return Err(error),
        };
        let mut path = Path::new(mechanism, pose, drive.clone())?;
        let start = path.start();
        let [low, high] = path.whole_range()?;
        let is_round = path.is_round();
        let mut values: Vec<f64> = if is_round {
            let step = path.unit() / count.max(1) as f64;
            (1..count).map(|k| start + step * k as f64).collect()
        } else {
            let (low, high) = (low.max(path.low()), high.min(path.high()));
            let off = OFF_THE_END * (high - low);
            let step = (high - low - 2.0 * off) / count.max(2).saturating_sub(1) as f64;
            (0..count).map(|k| low + off + step * k as f64).collect()
        };
        // The scene's own position replaces a value next to it, so that steps stay nearly equal.
        let next = values.iter().position(|v| *v >= start).unwrap_or(values.len());
        if values.get(next).is_some_and(|v| (v - start).abs() < 1e-9 * path.unit()) {
            values.remove(next);
        }
        values.insert(next, start);
        let mut animation = Self { drive: Some(drive), values: Vec::new(), positions: Vec::new(), is_round, ..still };
        let mut walker = path.walker();
        for value in values {
            let solution = if value == start {
                animation.own = animation.values.len();
                Some(own.clone())
            } else {
                walker.position(value).and_then(|position| own.moved(position.pose()).ok())
            };
            if let Some(solution) = solution {
                animation.values.push(value);
                animation.positions.push(solution);
            }
        }
        Ok(animation)
    }
}
