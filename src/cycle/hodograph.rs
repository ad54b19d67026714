use super::reading::Tip;
use super::sampled::MARKS;
use super::{Curve, Curves, CycleError, Path, Sampled};
use crate::geometry::Vector;
use crate::quantity::QuantityRequest;

/// Hodographs: the curves of the tips of vectors over a range of a path, all vectors laid off from one pole.
pub type Hodographs<'a> = Sampled<'a, Hodograph>;

/// The curve of one vector's tip.
#[derive(Clone, Debug)]
pub struct Hodograph {
    /// The vector.
    pub asked: QuantityRequest,
    /// Values of the drive and tips, measured from the pole, in pieces without a gap, so dense that straight lines
    /// between them look like the curve. The curve of a whole turn is closed.
    pub pieces: Vec<Vec<(f64, Vector)>>,
    /// Lowest and highest coordinates to be shown, the pole included: the whole curve, or, where it grows without
    /// bound, as far as the rest of it stays readable.
    pub window: [Vector; 2],
    /// Tips at round values of the drive: for an angle every 30°, counted from 0° to 360° where the range is a whole
    /// turn.
    pub marks: Vec<(f64, Vector)>,
    /// The tip at the scene's own position, if that is in the range.
    pub own: Option<Vector>,
}

impl<'a> Hodographs<'a> {
    /// The hodographs of vectors by their names, as `v(D)` or `a(D/G)`, over the part of `range` that `path` has
    /// reached.
    ///
    /// # Errors
    /// A name is no vector of this mechanism, or the vector has no value in the range; or nothing of the range has been
    /// reached.
    pub fn new(path: &'a Path<'a>, range: [f64; 2], names: &[String]) -> Result<Self, CycleError> {
        let mut all = Sampled { path, range, curves: Vec::new(), events: Vec::new() };
        for (index, name) in names.iter().enumerate() {
            if names[..index].contains(name) {
                continue;
            }
            let asked = QuantityRequest::new(name, &path.mechanism)?;
            if !asked.is_vector() {
                return Err(CycleError::NoVector(name.clone()));
            }
            let parts = [".x", ".y"].map(|part| format!("{name}{part}"));
            let components = Curves::new(path, range, Some(&parts))?;
            let curve = |part: &String| {
                let has = |curve: &&Curve| curve.asked.iter().any(|asked| asked.name() == part);
                let found = components.curves.iter().find(has);
                found.expect("both parts have a curve")
            };
            let tip = Tip::new(path, parts.each_ref().map(String::as_str))?;
            all.curves.push(hodograph(asked, &components, parts.each_ref().map(curve), tip));
            (all.range, all.events) = (components.range, components.events);
        }
        Ok(all)
    }
}

/// The hodograph of the vector with the components `x` and `y`, two of `curves`.
fn hodograph(asked: QuantityRequest, curves: &Curves, [x, y]: [&Curve; 2], mut tip: Tip) -> Hodograph {
    let mut tip = |at: f64| tip.at(at);
    // Tips at the samples of both components, where the pieces of both overlap.
    let mut pieces = Vec::new();
    for a in &x.pieces {
        for b in &y.pieces {
            let ends = |piece: &[[f64; 2]]| [piece[0][0], piece[piece.len() - 1][0]];
            let [[a0, a1], [b0, b1]] = [ends(a), ends(b)];
            let common = a0.max(b0)..=a1.min(b1);
            let samples = a.iter().chain(b).map(|sample| sample[0]);
            let mut values: Vec<f64> = samples.filter(|at| common.contains(at)).collect();
            values.sort_by(f64::total_cmp);
            values.dedup();
            let piece: Vec<(f64, Vector)> = values.into_iter().filter_map(|at| Some((at, tip(at)?))).collect();
            if piece.len() > 1 {
                pieces.push(piece);
            }
        }
    }
    let step = if curves.path.drive.is_angle() { MARKS } else { curves.round_step() };
    let marks = curves.round_values(step).into_iter();
    Hodograph {
        asked,
        pieces,
        window: [
            Vector::new(x.window[0].min(0.0), y.window[0].min(0.0)),
            Vector::new(x.window[1].max(0.0), y.window[1].max(0.0)),
        ],
        marks: marks.filter_map(|at| Some((curves.called(at), tip(at)?))).collect(),
        own: curves.own().and_then(tip),
    }
}
