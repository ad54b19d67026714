//! What loads the links of a scene that is built in Rust.

use super::build::{Builder, NewLink, Object};
use super::loads::{Analysis, LinkPlace};
use super::units::{ForceUnit, MassUnit};
use super::write::{Write, Written};

impl Builder {
    /// Adds the units of mass and force, which masses, forces and springs need.
    ///
    /// ```
    /// use kinegon::scene::{Builder, ForceUnit, LengthUnit, MassUnit, NewLink, NewLoad, NewSpring, TimeUnit, Turn};
    ///
    /// let builder = Builder::new(LengthUnit::Mm, TimeUnit::S)
    ///     .mass_and_force(MassUnit::Kg, ForceUnit::N)
    ///     .ground("A", [0.0, 0.0])
    ///     .ground("D", [160.0, 0.0])
    ///     .link("1", NewLink::points(["A", "B"]).length("AB", 60.0).drive(Turn::omega(10.0).angle(40.0)))
    ///     .link("2", NewLink::points(["B", "C"]).length("BC", 140.0).mass(1.6, 3100.0, [65.0, 8.0]))
    ///     .link("3", NewLink::points(["D", "C"]).length("DC", 110.0).mass(1.1, 1900.0, 50.0))
    ///     .near_angle("3", 95.0)
    ///     .gravity([0.0, -9810.0])
    ///     .load("3", NewLoad::force("C", [-150.0, -60.0]).named("P"))
    ///     .load("2", NewLoad::couple(-4000.0).over("angle(1)", [[0.0, 0.0], [90.0, 1.0], [180.0, 0.0]]))
    ///     .spring(NewSpring::between(("3", "C"), ("ground", [200.0, 180.0])).rate(0.4).length(60.0))
    ///     .friction_at_pin("B", 0.12, 10.0);
    /// let solution = kinegon::solve(&builder.build()?)?;
    /// let torque = solution.quantity("T(1)")?.as_number();
    /// assert!(torque.abs() > 1000.0, "{torque}");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn mass_and_force(mut self, mass: MassUnit, force: ForceUnit) -> Builder {
        self.file.add("units", "mass", &mass);
        self.file.add("units", "force", &force);
        self
    }

    /// Sets the acceleration of free fall, in length per time².
    pub fn gravity(mut self, gravity: [f64; 2]) -> Builder {
        *self.file.slot("gravity") = gravity.written();
        self
    }

    /// Sets whether inertia counts; it does by default.
    pub fn analysis(mut self, analysis: Analysis) -> Builder {
        *self.file.slot("analysis") = analysis.written();
        self
    }

    /// Adds a force or a couple on a link.
    pub fn load(mut self, link: &str, load: NewLoad) -> Builder {
        self.file.push("forces", load.0.with("on", link).in_order(&["forces", ""]));
        self
    }

    /// Adds a spring.
    pub fn spring(mut self, spring: NewSpring) -> Builder {
        self.file.push("springs", spring.0.in_order(&["springs", ""]));
        self
    }
}

impl Builder {
    /// Adds Coulomb friction of this coefficient at a pin, whose journal has this radius.
    pub fn friction_at_pin(mut self, pin: &str, coefficient: f64, radius: f64) -> Builder {
        let friction = Object::default().with("pin", pin).with("coefficient", &coefficient).with("radius", &radius);
        self.file.push("friction", friction.in_order(&["friction", ""]));
        self
    }

    /// The same at a pin that joins three or more links and is fixed in one of them, or in `"ground"`: the others turn on it.
    pub fn friction_at_pin_fixed_in(mut self, link: &str, pin: &str, coefficient: f64, radius: f64) -> Builder {
        let friction = Object::default().with("pin", pin).with("coefficient", &coefficient).with("radius", &radius);
        self.file.push("friction", friction.with("fixed_in", link).in_order(&["friction", ""]));
        self
    }

    /// Adds Coulomb friction of this coefficient in the guide of a slider, called as in results: `"3/ground"`.
    pub fn friction_in_guide(mut self, guide: &str, coefficient: f64) -> Builder {
        let friction = Object::default().with("guide", guide).with("coefficient", &coefficient);
        self.file.push("friction", friction.in_order(&["friction", ""]));
        self
    }
}

impl NewLink {
    /// Gives it a mass, a moment of inertia about the centre of mass, in mass · length², and that centre: one of its points, as
    /// `"B"`, a place `[x, y]` in its own frame, or a distance from its first point along its axis.
    pub fn mass(self, mass: f64, inertia: f64, center: impl Into<LinkPlace>) -> NewLink {
        NewLink(self.0.with("mass", &mass).with("inertia", &inertia).with("center", &center.into()))
    }

    /// The same with its weight, in the unit of force, in place of the mass.
    pub fn weight(self, weight: f64, inertia: f64, center: impl Into<LinkPlace>) -> NewLink {
        NewLink(self.0.with("weight", &weight).with("inertia", &inertia).with("center", &center.into()))
    }
}

/// A force or a couple for [`Builder::load`].
#[derive(Debug, Clone)]
#[must_use]
pub struct NewLoad(Object);

impl NewLoad {
    /// A force with these components in the fixed frame, at a point of its link, as `"C"`, at a place `[x, y]` in the link's own frame, or
    /// at a distance from its first point along its axis.
    pub fn force(at: impl Into<LinkPlace>, force: [f64; 2]) -> NewLoad {
        NewLoad(Object::default().with("at", &at.into()).with("force", &force))
    }

    /// A couple, counter-clockwise positive.
    pub fn couple(couple: f64) -> NewLoad {
        NewLoad(Object::default().with("couple", &couple))
    }

    /// With this name; by default F1, F2 … for forces, M1 for a couple on link 1, M2 for one on link 2 …
    pub fn named(self, name: &str) -> NewLoad {
        NewLoad(self.0.with("name", name))
    }

    /// A force that turns with its link: its components are then along the link's axis and normal to it.
    pub fn turning(self) -> NewLoad {
        NewLoad(self.0.with("turns", &true))
    }

    /// It acts so many times over an angle, as `angle(1)` in degrees, or over a slider's `position(3/ground)`: pairs of a place and the factor
    /// there, in ascending order.
    pub fn over(self, of: &str, table: impl IntoIterator<Item = [f64; 2]>) -> NewLoad {
        let lines = table.into_iter().map(|line| line.written()).collect();
        let over = Object::default().with("of", of).with_list("table", lines);
        NewLoad(self.0.with("over", &over))
    }
}

/// A spring for [`Builder::spring`]: it pulls its ends together with `rate` times what it is longer than `length`.
#[derive(Debug, Clone)]
#[must_use]
pub struct NewSpring(Object);

impl NewSpring {
    /// Between two places, each of a link or of `"ground"`.
    pub fn between<'a>(from: (&'a str, impl Into<LinkPlace>), to: (&'a str, impl Into<LinkPlace>)) -> NewSpring {
        let end = |link: &str, at: LinkPlace| Written::List(vec![link.written(), at.written()]);
        let ends = vec![end(from.0, from.1.into()), end(to.0, to.1.into())];
        NewSpring(Object::default().with_list("between", ends).with("rate", &0.0).with("length", &0.0))
    }

    /// With this force per length of extension; zero by default.
    pub fn rate(mut self, rate: f64) -> NewSpring {
        *self.0.slot("rate") = rate.written();
        self
    }

    /// With this length without a force; zero by default.
    pub fn length(mut self, length: f64) -> NewSpring {
        *self.0.slot("length") = length.written();
        self
    }

    /// With this name; by default K1, K2 …
    pub fn named(self, name: &str) -> NewSpring {
        NewSpring(self.0.with("name", name))
    }
}

impl From<&str> for LinkPlace {
    fn from(point: &str) -> LinkPlace {
        LinkPlace::Point(point.to_owned())
    }
}

impl From<[f64; 2]> for LinkPlace {
    fn from(place: [f64; 2]) -> LinkPlace {
        LinkPlace::Place(place)
    }
}

impl From<f64> for LinkPlace {
    fn from(distance: f64) -> LinkPlace {
        LinkPlace::Distance(distance)
    }
}
