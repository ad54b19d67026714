use crate::geometry::{OneByOne, Turn, degrees_of};
use crate::kernel::{Block, Input, InputKind, Kernel, Single, Unknown};
use crate::mechanism::Mechanism;
use crate::position::Pose;

/// The block that stands where `pose` does, with the drives' own values; unit rates are for the caller to set.
pub(super) fn start(kernel: &Kernel, mechanism: &Mechanism, pose: &Pose) -> Single {
    let mut block = Block::new(kernel);
    for (index, input) in kernel.inputs.iter().enumerate() {
        kernel.set_input(OneByOne, &mut block, index, &[stands(input, pose)]);
    }
    for unknown in kernel.unknowns.iter().flatten() {
        match *unknown {
            Unknown::Slide(slider) => block.slides[slider] = [pose.slides[slider].unwrap_or(0.0)],
            Unknown::Spin(class) => {
                let mut links = mechanism.links();
                let axis = links.find_map(|(id, _)| {
                    let seat = kernel.seat(id);
                    let axis = pose.axes[id.0].filter(|_| seat.class == class)?.normalize();
                    Some(seat.turn.inverse() * Turn::from_cos_sin_unchecked(axis.x, axis.y))
                });
                let turn = axis.unwrap_or_else(Turn::identity);
                block.turns[class] = [[turn.re], [turn.im]];
            }
        }
    }
    block
}

/// Where a drive stands: what the scene says, or what the pose has found.
pub(super) fn stands(input: &Input, pose: &Pose) -> f64 {
    let found = match input.kind {
        InputKind::Turning { .. } => pose.axes[input.body.0].map(degrees_of),
        InputKind::Sliding { slider } => pose.slides[slider],
    };
    input.value.or(found).unwrap_or(0.0)
}
