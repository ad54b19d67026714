//! Groups of class III and IV by their special points, and the boom with a driven cylinder.

use super::act::{Act, Doing, Formula};
use super::plane::{Place, QUARTER, along, crossing, solved, unit};
use super::scheme::Scheme;
use super::sheet::{Sheet, image_of};

/// A way from a known pivot to a special point: a link that turns about the pivot, or one that carries a guide.
#[derive(Clone, Debug)]
pub enum Leg {
    /// Pivot, joint with the special point's link, the leg's own link.
    Pinned(String, String, String),
    /// Pivot on the guide, the slider's name, the link that carries its guide.
    Guided(String, String, String),
}

/// A special point: its name, its link, and the two legs on whose lines it lies.
#[derive(Clone, Debug)]
pub struct Special {
    pub name: String,
    pub link: String,
    pub legs: [Leg; 2],
}

/// One equation for the rates: which unknowns with which factors, and the signed segment.
type Equation = (Vec<(String, f64)>, f64);

impl Leg {
    fn pivot(&self) -> &str {
        match self {
            Leg::Pinned(pivot, ..) | Leg::Guided(pivot, ..) => pivot,
        }
    }
}

impl Special {
    /// Where it lies on the scheme.
    pub fn place(&self, scheme: &Scheme) -> Place {
        let [first, second] = [0, 1].map(|k| match &self.legs[k] {
            Leg::Pinned(pivot, joint, _) => (scheme.at(pivot), scheme.along(pivot, joint)),
            Leg::Guided(pivot, slider, _) => (scheme.at(pivot), scheme.guide(slider).direction + QUARTER),
        });
        crossing(first, second)
    }
}

impl Sheet<'_> {
    /// Marks the image of a special point, and gives the two equations of its segments.
    pub fn special(&mut self, plan: usize, special: &Special) -> [Equation; 2] {
        let image = image_of(&special.name);
        let starts = [0, 1].map(|k| {
            let leg = &special.legs[k];
            let start = match plan {
                1 => image_of(leg.pivot()),
                _ => self.parts_along(leg, special),
            };
            let towards = match leg {
                Leg::Pinned(pivot, joint, _) => self.across(pivot, joint),
                Leg::Guided(_, slider, _) => self.scheme.guide(slider).direction,
            };
            let link = match leg {
                Leg::Pinned(.., link) => link,
                Leg::Guided(_, slider, _) => slider,
            };
            (self.ray(plan, link, [&start, &image], towards), start, towards)
        });
        self.cross(plan, &image, starts[0].0, starts[1].0);
        [0, 1].map(|k| self.equation(plan, special, k, [&starts[k].1, &image], starts[k].2))
    }

    /// Lays off what is known of the way along a leg's line: normal parts, and Coriolis where it slides. The end's name.
    fn parts_along(&mut self, leg: &Leg, special: &Special) -> String {
        let from = image_of(leg.pivot());
        let end = format!("n_{from}{}", special.name.trim_start_matches('S'));
        let what = format!("{from} {end}");
        let central = format!("omega({})", special.link);
        match leg {
            Leg::Pinned(pivot, joint, link) => {
                let sense = self.sense_along(pivot, joint, &special.name);
                let own = self.rate_for(2, &format!("omega({link})"), &what);
                let length = self.length_for(2, link, [pivot, joint], &what);
                let other = self.rate_for(2, &central, &what);
                let rest = self.length_for(2, &special.link, [joint, &special.name], &what);
                let first = Act::new(Doing::Size, 2, link, pivot, joint).by(Formula::Normal).of(&what);
                let second =
                    Act::new(Doing::Size, 2, &special.link, joint, &special.name).by(Formula::Normal).of(&what);
                let parts = [self.number(first, own * own * length), self.number(second, other * other * rest)];
                let inwards = self.scheme.along(joint, pivot);
                self.lay(2, [&from, &end], (Formula::Normal, link), parts[0] + sense * parts[1], inwards);
            }
            Leg::Guided(pivot, slider, link) => {
                let turned = format!("k_{from}{}", special.link);
                self.coriolis([&from, &turned], slider, link, false);
                let what = format!("{turned} {end}");
                let omega = self.rate_for(2, &format!("omega({link})"), &what);
                let length = self.length_for(2, link, [pivot, &special.name], &what);
                let inwards = self.scheme.along(&special.name, pivot);
                self.lay(2, [&turned, &end], (Formula::Normal, link), omega * omega * length, inwards);
            }
        }
        end
    }

    /// Whether the way goes on from the joint to the special point as from the pivot to the joint (+1), or back (−1).
    fn sense_along(&self, pivot: &str, joint: &str, special: &str) -> f64 {
        along(self.scheme.at(special) - self.scheme.at(joint), self.scheme.along(pivot, joint)).signum()
    }

    fn equation(&mut self, plan: usize, special: &Special, k: usize, ends: [&str; 2], towards: f64) -> Equation {
        let (turn, slide) = [("", ""), ("omega", "v_r"), ("alpha", "a_r")][plan];
        let what = format!("equation {} {k}", special.name);
        let signed = self.signed(plan, ends, towards, &what);
        let name = |link: &str| format!("{turn}({link})");
        let factors = match &special.legs[k] {
            Leg::Pinned(pivot, joint, link) => {
                let sense = self.sense_along(pivot, joint, &special.name);
                let own = self.length_for(plan, link, [pivot, joint], &what);
                let rest = self.length_for(plan, &special.link, [joint, &special.name], &what);
                let sense =
                    self.number(Act::new(Doing::Sense, plan, &special.link, joint, &special.name).of(&what), sense);
                vec![(name(link), own), (name(&special.link), sense * rest)]
            }
            Leg::Guided(pivot, slider, link) => {
                let length = self.length_for(plan, link, [pivot, &special.name], &what);
                // A turn moves the special point along the guide, this way or that.
                let sense = along(unit(self.across(pivot, &special.name)), towards).signum();
                vec![(name(link), sense * length), (format!("{slide}({slider})"), 1.0)]
            }
        };
        (factors, signed)
    }

    /// Solves the equations of all segments for the rates; `same` are two links that turn together, if any.
    pub fn solve(&mut self, equations: &[Equation], plan: usize, same: &[&str]) {
        let head = ["", "omega", "alpha"][plan];
        let name = |link: &str| format!("{head}({link})");
        let alias = |rate: &str| match same {
            [link, other] if name(link) == rate => name(other),
            _ => rate.to_owned(),
        };
        let mut names: Vec<String> = Vec::new();
        for (rate, _) in equations.iter().flat_map(|(factors, _)| factors) {
            if !names.contains(&alias(rate)) {
                names.push(alias(rate));
            }
        }
        let rows = equations.iter().map(|(factors, right)| {
            let mut row = vec![0.0; names.len() + 1];
            for (rate, factor) in factors {
                let column = names.iter().position(|known| *known == alias(rate));
                row[column.unwrap_or_default()] += factor;
            }
            row[names.len()] = *right;
            row
        });
        let found = solved(rows.collect());
        for (rate, value) in names.iter().zip(found) {
            self.find(rate, value);
        }
        if let [link, other] = same {
            let value = self.rate(&name(other));
            self.rates.insert(name(link), value);
        }
    }

    /// A cylinder between the pins a and c, driven at d, which lifts the link that is pinned to the ground at o.
    pub fn cylinder(&mut self, plan: usize, [a, c, o]: [&str; 3], [barrel, rod, boom]: [&str; 3]) {
        let slider = format!("{rod}/{barrel}");
        let guide = self.scheme.guide(&slider).clone();
        let (image, pushed) = (image_of(c), format!("r_{}{rod}", image_of(a)));
        let drive = guide.drive.unwrap_or_default();
        self.rates.insert(format!("v_r({slider})"), drive[0]);
        self.rates.insert(format!("a_r({slider})"), drive[1]);
        self.lay(plan, [&image_of(a), &pushed], (Formula::Sliding, &slider), drive[plan - 1], guide.direction);
        let mut starts = [pushed.clone(), image_of(o)];
        if plan == 2 {
            let turned = format!("k_{}{rod}", image_of(a));
            self.coriolis([&pushed, &turned], &slider, barrel, false);
            starts = [format!("n_{}{c}", image_of(a)), format!("n_{}{c}", image_of(o))];
            self.normal(&turned, &starts[0], rod, [a, c]);
            self.normal(&image_of(o), &starts[1], boom, [o, c]);
        }
        let across = [a, o].map(|pivot| self.across(pivot, c));
        let first = self.ray(plan, rod, [&starts[0], &image], across[0]);
        let second = self.ray(plan, boom, [&starts[1], &image], across[1]);
        self.cross(plan, &image, first, second);
        self.turn(plan, rod, [&starts[0], &image], [a, c]);
        self.turn(plan, boom, [&starts[1], &image], [o, c]);
        let name = |link: &str| format!("{}({link})", ["", "omega", "alpha"][plan]);
        let same = self.rate(&name(rod));
        self.rates.insert(name(barrel), same);
    }

    /// From a guide's point on, what slides on it: a_r along the guide, then 2 ω v_r across it.
    pub fn slid(&mut self, plan: usize, point: &str, [slides, carries]: [&str; 2]) {
        let slider = format!("{slides}/{carries}");
        let guide = self.scheme.guide(&slider).direction;
        let (from, to) = (format!("{}_{carries}", image_of(point)), image_of(point));
        if plan == 1 {
            // The image is there already where the joint hangs on another link.
            if !self.has(1, &to) {
                let speed = self.rate(&format!("v_r({slider})"));
                self.lay(1, [&from, &to], (Formula::Sliding, &slider), speed, guide);
            }
            return;
        }
        let end = format!("r_{from}{slides}");
        let rate = self.rate_for(2, &format!("a_r({slider})"), &format!("{from} {end}"));
        self.lay(2, [&from, &end], (Formula::Sliding, &slider), rate, guide);
        self.coriolis([&end, &to], &slider, carries, false);
    }
}
