use crate::geometry::{Turn, degrees_of};
use crate::kernel::{Block, Input, InputKind, Kernel, Single, Unknown};
use crate::mechanism::Mechanism;
use crate::position::Pose;

/// A block in the position of `pose`, with the drives' values; the caller sets their rates.
pub(super) fn start(kernel: &Kernel, mechanism: &Mechanism, pose: &Pose) -> Single {
    let mut block = Block::new(kernel);
    for (index, input) in kernel.inputs.iter().enumerate() {
        kernel.set_input(&mut block, index, &[stands(input, pose)]);
    }
    for unknown in kernel.unknowns.iter().flatten() {
        match *unknown {
            Unknown::Slide(slider) => block.slides[slider] = [pose.slides[slider].unwrap_or(0.0)],
            Unknown::Spin(class) => {
                let mut links = mechanism.links().filter(|(id, _)| kernel.seat(*id).class == class);
                let turn = links.find_map(|(id, _)| {
                    let axis = pose.axes[id.0]?.normalize();
                    Some(kernel.seat(id).turn.inverse() * Turn::from_cos_sin_unchecked(axis.x, axis.y))
                });
                let turn = turn.unwrap_or_else(Turn::identity);
                block.turns[class] = [[turn.re], [turn.im]];
            }
        }
    }
    block
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
pub(super) fn ratios(kernel: &Kernel, moved: usize) -> Vec<f64> {
    let speed = |input: &Input| match input.kind {
        InputKind::Turning { .. } => input.rate.to_degrees(),
        InputKind::Sliding { .. } => input.rate,
    };
    let by = speed(&kernel.inputs[moved]);
    let ratio = |(index, input): (usize, &Input)| match index == moved {
        true => 1.0,
        false if by == 0.0 => 0.0,
        false => speed(input) / by,
    };
    kernel.inputs.iter().enumerate().map(ratio).collect()
}
