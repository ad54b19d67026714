//! Cranks, given vectors, dyads and images of further points, as textbooks draw them.

use super::act::{Act, Doing, Formula};
use super::plane::{QUARTER, direction, size, unit};
use super::sheet::{Sheet, image_of};

const POLES: [&str; 3] = ["", "p", "π"];

impl Sheet<'_> {
    /// Lays off velocity or acceleration of the pin of a crank from the pole.
    pub fn crank(&mut self, plan: usize, link: &str, [pivot, pin]: [&str; 2]) {
        let image = image_of(pin);
        let (omega, alpha) = (format!("omega({link})"), format!("alpha({link})"));
        let what = format!("{} {image}", POLES[plan]);
        // As they are taken for both plans, and then for this one.
        let common = self.length_for(0, link, [pivot, pin], "crank");
        let length = self.number(Act::new(Doing::Length, plan, link, pivot, pin).of(&what), common);
        let turning = self.rate_for(0, &omega, "crank");
        let turning = self.number(Act::new(Doing::Rate, plan, &omega, "", "").of(&what), turning);
        if plan == 1 {
            let across = self.across(pivot, pin);
            return self.lay(1, ["p", &image], (Formula::Turning, link), turning * length, across);
        }
        let inwards = self.scheme.along(pin, pivot);
        let tangential = self.rate_for(2, &alpha, &what) * length;
        let tangential = self.number(Act::new(Doing::Size, 2, link, "π", &image).by(Formula::Tangential), tangential);
        let normal = turning * turning * length;
        if tangential == 0.0 {
            return self.lay(2, ["π", &image], (Formula::Normal, link), normal, inwards);
        }
        let end = format!("n_{}", image);
        self.lay(2, ["π", &end], (Formula::Normal, link), normal, inwards);
        let across = self.across(pivot, pin);
        let laid = self.hand.laid_off(tangential.abs() / self.scale(2)).copysign(tangential);
        let towards = self.number(Act::new(Doing::Heading, 2, link, &end, &image).by(Formula::Tangential), across);
        let towards = self.hand.drawn(towards);
        self.trace(2, [&end, &image], (self.at(2, &end), towards), true);
        let place = self.at(2, &end) + unit(towards) * laid;
        self.mark(2, &image, place);
    }

    /// Lays off a given velocity or acceleration from the pole.
    pub fn known(&mut self, plan: usize, point: &str) {
        let given = self.scheme.known[point].clone();
        let vector = if plan == 1 { given.velocity } else { given.acceleration };
        self.lay(plan, [POLES[plan], &image_of(point)], (Formula::Given, ""), size(vector), direction(vector));
    }

    /// The point of a link of given motion under another point.
    pub fn under(&mut self, plan: usize, link: &str, [from, point]: [&str; 2]) {
        let image = format!("{}_{link}", image_of(point));
        let arm = self.scheme.at(point) - self.scheme.at(from);
        let given = self.scheme.known[from].clone();
        let (omega, alpha) = (self.rate(&format!("omega({link})")), self.rate(&format!("alpha({link})")));
        let across = arm * unit(QUARTER);
        let vector = match plan {
            1 => given.velocity + across * omega,
            _ => given.acceleration + across * alpha - arm * (omega * omega),
        };
        self.lay(plan, [POLES[plan], &image], (Formula::Given, link), size(vector), direction(vector));
    }

    /// Lays off ω² L of a link about p, from a place of the plan; the name of its end.
    pub fn normal(&mut self, from: &str, end: &str, link: &str, [p, c]: [&str; 2]) {
        let what = format!("{from} {end}");
        let omega = self.rate_for(2, &format!("omega({link})"), &what);
        let length = self.length_for(2, link, [p, c], &what);
        let inwards = self.scheme.along(c, p);
        self.lay(2, [from, end], (Formula::Normal, link), omega * omega * length, inwards);
    }

    /// Where the ray of a link's relative motion begins: at p's image, or at the end of its normal part.
    fn ray_start(&mut self, plan: usize, link: &str, [p, c]: [&str; 2], from: &str) -> String {
        if plan == 1 {
            return from.to_owned();
        }
        let end = format!("n_{}{c}", image_of(p));
        self.normal(from, &end, link, [p, c]);
        end
    }

    /// Finds ω or α of a link from a segment across it.
    pub fn turn(&mut self, plan: usize, link: &str, [from, to]: [&str; 2], [p, c]: [&str; 2]) {
        let name = format!("{}({link})", ["", "omega", "alpha"][plan]);
        let across = self.across(p, c);
        let signed = self.signed(plan, [from, to], across, &name);
        let length = self.length_for(plan, link, [p, c], &name);
        self.find(&name, signed / length);
    }

    /// The joint c of two links that are pinned at p and q (RRR).
    pub fn pins(&mut self, plan: usize, [p, q, c]: [&str; 3], links: [&str; 2]) {
        let image = image_of(c);
        let starts = [(p, links[0]), (q, links[1])].map(|(joint, link)| {
            let start = self.ray_start(plan, link, [joint, c], &image_of(joint));
            let across = self.across(joint, c);
            (self.ray(plan, link, [&start, &image], across), start)
        });
        self.cross(plan, &image, starts[0].0, starts[1].0);
        for ((joint, link), (_, start)) in [(p, links[0]), (q, links[1])].into_iter().zip(&starts) {
            self.turn(plan, link, [start, &image], [joint, c]);
        }
    }

    /// The joint c of a link pinned at p and a slider on the ground (RRP).
    pub fn guided(&mut self, plan: usize, [p, c]: [&str; 2], [link, slider]: [&str; 2]) {
        let (image, ground) = (image_of(c), format!("{}_ground", image_of(c)));
        let guide = self.scheme.guide(&format!("{slider}/ground")).direction;
        let start = self.ray_start(plan, link, [p, c], &image_of(p));
        let across = self.across(p, c);
        let first = self.ray(plan, link, [&start, &image], across);
        let second = self.ray(plan, &format!("{slider}/ground"), [&ground, &image], guide);
        self.cross(plan, &image, first, second);
        self.turn(plan, link, [&start, &image], [p, c]);
        self.slide(plan, &format!("{slider}/ground"), [&ground, &image], guide);
    }

    /// Finds how fast, or how much faster, something slides along a direction.
    fn slide(&mut self, plan: usize, slider: &str, [from, to]: [&str; 2], guide: f64) {
        let name = format!("{}({slider})", ["", "v_r", "a_r"][plan]);
        let signed = self.signed(plan, [from, to], guide, &name);
        self.find(&name, signed);
    }

    /// Lays off 2 ω v_r of a slider, on its guide's link, from or (backwards) towards an image.
    pub fn coriolis(&mut self, [from, to]: [&str; 2], slider: &str, link: &str, is_backwards: bool) {
        let what = format!("{from} {to}");
        let guide = self.scheme.guide(slider).direction;
        let omega = self.rate_for(2, &format!("omega({link})"), &what);
        let speed = self.rate_for(2, &format!("v_r({slider})"), &what);
        let size = if is_backwards { -2.0 * omega * speed } else { 2.0 * omega * speed };
        self.lay(2, [from, to], (Formula::Coriolis, slider), size, guide + QUARTER);
    }

    /// The point b_3 of a slotted lever under the pin b that slides in it (RPR).
    pub fn slot(&mut self, plan: usize, [pivot, pin]: [&str; 2], [block, lever]: [&str; 2]) {
        let slider = format!("{block}/{lever}");
        let (own, under) = (image_of(pin), format!("{pin}_{lever}"));
        let image = image_of(&under);
        let mut turn_start = image_of(pivot);
        let mut slide_start = own.clone();
        if plan == 2 {
            turn_start = format!("n_{}{under}", image_of(pivot));
            self.normal(&image_of(pivot), &turn_start, lever, [pivot, &under]);
            slide_start = format!("k_{own}{lever}");
            self.coriolis([&own, &slide_start], &slider, lever, true);
        }
        let guide = self.scheme.guide(&slider).direction;
        let across = self.across(pivot, &under);
        let first = self.ray(plan, lever, [&turn_start, &image], across);
        let second = self.ray(plan, &slider, [&slide_start, &image], guide);
        self.cross(plan, &image, first, second);
        self.turn(plan, lever, [&turn_start, &image], [pivot, &under]);
        let name = |link: &str| format!("{}({link})", ["", "omega", "alpha"][plan]);
        let same = self.rate(&name(lever));
        self.rates.insert(name(block), same);
        // From the lever's point to the pin: against the way of the ray.
        let quantity = format!("{}({slider})", ["", "v_r", "a_r"][plan]);
        let signed = self.signed(plan, [&slide_start, &image], guide + 2.0 * QUARTER, &quantity);
        self.find(&quantity, signed);
    }

    /// The pin c of two blocks: one slides on a link of given motion, the other on the ground (PRP).
    pub fn blocks(&mut self, plan: usize, point: &str, [first, carrier, second]: [&str; 3]) {
        let image = image_of(point);
        let (moving, fixed) = (format!("{first}/{carrier}"), format!("{second}/ground"));
        let mut start = format!("{image}_{carrier}");
        if plan == 2 {
            let end = format!("k_{image}_{carrier}{first}");
            self.coriolis([&start, &end], &moving, carrier, false);
            start = end;
        }
        let rest = format!("{image}_ground");
        let guides = [&moving, &fixed].map(|slider| self.scheme.guide(slider).direction);
        let rays =
            [self.ray(plan, &moving, [&start, &image], guides[0]), self.ray(plan, &fixed, [&rest, &image], guides[1])];
        self.cross(plan, &image, rays[0], rays[1]);
        self.slide(plan, &moving, [&start, &image], guides[0]);
        self.slide(plan, &fixed, [&rest, &image], guides[1]);
    }

    /// A block on a given pin, in the slot of a link that slides on the ground (RPP).
    pub fn yoke(&mut self, plan: usize, pin: &str, [block, yoke]: [&str; 2]) {
        let (own, image) = (image_of(pin), format!("{}_{yoke}", image_of(pin)));
        let (slot, fixed) = (format!("{block}/{yoke}"), format!("{yoke}/ground"));
        let guides = [&fixed, &slot].map(|slider| self.scheme.guide(slider).direction);
        let rest = format!("{own}_ground");
        let rays =
            [self.ray(plan, &fixed, [&rest, &image], guides[0]), self.ray(plan, &slot, [&own, &image], guides[1])];
        self.cross(plan, &image, rays[0], rays[1]);
        self.slide(plan, &fixed, [&rest, &image], guides[0]);
        self.slide(plan, &slot, [&own, &image], guides[1] + 2.0 * QUARTER);
    }

    /// The image of a point e of the link through p and c: turned with the link and true to its shape.
    ///
    /// Where the form asks for the parts of its acceleration, it is found from them.
    pub fn image(&mut self, plan: usize, [p, c, e]: [&str; 3], link: &str) {
        if plan == 2 && self.start_of(e).is_some_and(|start| [p, c].contains(&start.as_str())) {
            return self.by_rates(plan, [p, e], link);
        }
        let arms = [e, c].map(|point| self.scheme.at(point) - self.scheme.at(p));
        let ratio = self.place(Act::new(Doing::Ratio, plan, link, p, e), arms[0] / arms[1]);
        let ratio = unit(self.hand.drawn(direction(ratio))) * size(ratio) * self.hand.stretch();
        let (start, end) = (self.at(plan, &image_of(p)), self.at(plan, &image_of(c)));
        let place = self.hand.placed(start + (end - start) * ratio);
        for (joint, from) in [(p, start), (c, end)] {
            self.trace(plan, [&image_of(joint), &image_of(e)], (from, direction(place - from)), false);
        }
        self.mark(plan, &image_of(e), place);
    }

    /// The point from which the form goes to another one by its normal part.
    fn start_of(&self, point: &str) -> Option<String> {
        let mut points = self.scheme.places.keys();
        let found = points.find(|start| {
            let end = format!(",n_{}{point})", image_of(start));
            self.scheme.form.iter().any(|name| name.ends_with(&end))
        });
        found.cloned()
    }

    /// The image of c from that of another point of its link, whose rates are known.
    pub fn by_rates(&mut self, plan: usize, [p, c]: [&str; 2], link: &str) {
        let start = self.start_of(c).filter(|_| plan == 2).unwrap_or_else(|| p.to_owned());
        let p = start.as_str();
        let (mut from, image) = (image_of(p), image_of(c));
        if plan == 2 {
            let end = format!("n_{from}{c}");
            self.normal(&from, &end, link, [p, c]);
            from = end;
        }
        let what = format!("{from} {image}");
        let (name, formula) = [("", Formula::Given), ("omega", Formula::Turning), ("alpha", Formula::Tangential)][plan];
        let rate = self.rate_for(plan, &format!("{name}({link})"), &what);
        let length = self.length_for(plan, link, [p, c], &what);
        let across = self.across(p, c);
        self.lay(plan, [&from, &image], (formula, link), rate * length, across);
    }
}
