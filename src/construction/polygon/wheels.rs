//! Wheels: the force between teeth from the moments of one wheel about its centre, then the polygon of its link.

use super::statics::{Force, Statics};
use super::{ForcePart, MomentPoint};
use crate::construction::number::{NumberKind, Product};
use crate::construction::operation::{Along, OperationRole, PlaceId};
use crate::forces::Counted;
use crate::mechanism::{BodyId, Group, JointId, Rolling};
use crate::motion::Places;
use crate::sheet::Sheet;

/// How teeth push, on the scheme.
struct Teeth {
    /// The pitch point.
    at: PlaceId,
    /// Along the tangent there.
    tangent: Along,
    /// In which direction the first body is pushed away.
    apart: Along,
    /// The tangent of the pressure angle; zero where teeth do not push.
    slope: f64,
}

impl Statics<'_, '_> {
    /// Whether teeth are among the joints of a group.
    pub fn has_teeth(&self, group: &Group) -> bool {
        group.joints.iter().any(|&joint| self.mechanism().joint(joint).rolls())
    }

    /// Finds what the joints of one wheel carry that turns on its pin and meshes with a wheel or a rack: moments about the pin tell the
    /// force along the tangent, the pressure angle what pushes the teeth apart, and the pin closes the polygon. `None` of other groups, in which moments
    /// of several links would have to be solved together.
    pub fn wheel(&mut self, group: &Group) -> Option<()> {
        let (&[body], &[a, b]) = (group.bodies.as_slice(), group.joints.as_slice()) else { return None };
        let [mesh, held] = if self.mechanism().joint(a).rolls() { [a, b] } else { [b, a] };
        let pin = self.mechanism().joint(held).pin?;
        let teeth = self.teeth(mesh)?;
        let set = self.set(&[body]);
        let step = self.begin();
        let about = (MomentPoint::Joint(pin), self.writer.plot(pin));
        let of = Statics::part(mesh, body, ForcePart::Tangential);
        let along = self.force_by_moments(step, &[body], &set, about, (of, teeth.at, teeth.tangent))?;
        let mut chain = self.chain(&[body]);
        self.lay_off_loads(&mut chain, &[body]);
        match along {
            None => {
                self.joints.insert(mesh, None);
            }
            Some(along) => {
                let before = chain.end;
                self.lay_off(&mut chain, &along);
                if teeth.slope != 0.0 {
                    let apart = self.apart(mesh, body, &teeth, &along);
                    self.lay_off(&mut chain, &apart);
                }
                self.join(chain.polygon, mesh, body, [before, chain.end]);
            }
        }
        self.close(&chain, held, body);
        Some(())
    }

    /// The force that pushes a body away from the other one, from that along the tangent.
    fn apart(&mut self, mesh: JointId, body: BodyId, teeth: &Teeth, along: &Force) -> Force {
        let sense = self.number(along.size).signum();
        let sum = vec![Product::plain(along.size).times(sense * teeth.slope)];
        let size = self.writer.compute(Sheet::Forces, NumberKind::Force, sum);
        let is_first = self.mechanism().joint(mesh).bodies[0] == body;
        let way = if is_first { teeth.apart } else { teeth.apart.turned(2) };
        let of = Statics::part(mesh, body, ForcePart::Normal);
        Force { of, on: body, at: teeth.at, along: way, size, sign: 1.0, exact: None }
    }

    fn teeth(&mut self, mesh: JointId) -> Option<Teeth> {
        let rolling = self.mechanism().joint(mesh).rolling()?;
        let at = self.pitch_place(mesh)?;
        let (outwards, apart, pressure) = match rolling {
            Rolling::Wheels(pitch) => {
                let [first, second] = pitch.centers;
                let outwards = Along::line(self.writer.join(first, second));
                let has_ring = pitch.teeth.iter().any(|teeth| *teeth < 0);
                (outwards, if has_ring { outwards } else { outwards.turned(2) }, pitch.pressure_deg)
            }
            Rolling::Rack(rack) => {
                let guide = Along::line(self.writer.guide(rack.slider));
                let outwards = guide.turned(if rack.side > 0.0 { 3 } else { 1 });
                (outwards, if rack.wheel == 0 { outwards.turned(2) } else { outwards }, rack.pressure_deg)
            }
        };
        Some(Teeth { at, tangent: outwards.turned(1), apart, slope: pressure.tangent_and_sine()[0] })
    }

    /// The pitch point of a mesh on the scheme.
    pub fn pitch_place(&mut self, mesh: JointId) -> Option<PlaceId> {
        if let Some(place) = self.pitch_places.get(&mesh) {
            return Some(*place);
        }
        let pose = self.writer.pose;
        let rolling = self.mechanism().joint(mesh).rolling()?;
        let at = rolling.point(|point| pose.place(point), |slider| Places::guide(pose, slider), |x| pose.given(x));
        let place = self.writer.plot_place(OperationRole::Pitch(mesh), at);
        self.pitch_places.insert(mesh, place);
        Some(place)
    }
}
