//! Profiles that touch, in a scene that is built in Rust.

use super::build::{Builder, Object};
use super::value::{At, Direction};
use super::write::Write;

impl Builder {
    /// Lets the profiles of two bodies touch, of links or of `"ground"`.
    ///
    /// ```
    /// use kinegon::scene::{Builder, Guide, LengthUnit, NewLink, Profiles, TimeUnit, Turn};
    ///
    /// let scene = Builder::new(LengthUnit::Mm, TimeUnit::S)
    ///     .ground("A", [0.0, 0.0])
    ///     .link("1", NewLink::points(["A", "K"]).length("AK", 20.0).drive(Turn::omega(15.0).angle(90.0)))
    ///     .link("2", NewLink::points(["F"]))
    ///     .slider("2", "F", Guide::on("ground").through([0.0, 0.0]).along(90.0))
    ///     .contact(["1", "2"], Profiles::on_face("K", 40.0, -90.0).circular())
    ///     .build()?;
    /// let solution = kinegon::solve(&scene).expect("it moves");
    /// let face = solution.pose.point(solution.mechanism.point("F").expect("a point"));
    /// assert!((face.y - 60.0).abs() < 1e-12);
    /// # Ok::<(), kinegon::scene::SceneError>(())
    /// ```
    pub fn contact(mut self, links: [&str; 2], profiles: Profiles) -> Builder {
        let contact = profiles.0.with("links", &links.map(str::to_owned).to_vec());
        self.file.push("contacts", contact.in_order(&["contacts", ""]));
        self
    }
}

/// How two profiles touch, for [`Builder::contact`].
#[derive(Debug, Clone)]
#[must_use]
pub struct Profiles(Object);

impl Profiles {
    /// Two round ones, by a point of each body that is the centre of curvature, and the radii, of which that of a hollow profile is negative.
    pub fn round(centers: [&str; 2], radii: [f64; 2]) -> Profiles {
        let object = Object::default().with("centers", &centers.map(str::to_owned).to_vec());
        Profiles(object.with_list("radii", radii.map(|radius| radius.written()).to_vec()))
    }

    /// A round one of the first body on a flat one of the second, in this direction as of a guide; the first body lies to its right.
    pub fn on_face(center: &str, radius: f64, along: impl Into<Direction>) -> Profiles {
        let object = Object::default().with("centers", &vec![center.to_owned()]);
        Profiles(object.with_list("radii", vec![radius.written()]).with("along", &along.into()))
    }

    /// The flat profile goes through this point of its body, or through these coordinates.
    pub fn through(self, place: impl Into<At>) -> Profiles {
        Profiles(self.0.with("through", &place.into()))
    }

    /// The second body touches with a roller about its centre.
    pub fn roller(self) -> Profiles {
        Profiles(self.0.with("roller", &true))
    }

    /// The round profiles are circles about these centres, so that the scene can be moved.
    pub fn circular(self) -> Profiles {
        Profiles(self.0.with("circular", &true))
    }

    /// The name of the equivalent link; by default E1, E2 …
    pub fn named(self, name: &str) -> Profiles {
        Profiles(self.0.with("name", name))
    }
}
