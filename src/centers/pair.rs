use crate::mechanism::{BodyId, GROUND, Mechanism};
use crate::scene::{Head, QuantityName};
use crate::words::Notation;

/// Two different links, one of which may be the frame, as the two whose instant centre is meant. P₁₃ and P₃₁ are one point: pairs have no order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct LinkPair([BodyId; 2]);

impl LinkPair {
    /// The pair of two links; `None` for a link with itself.
    #[must_use]
    pub fn new(a: BodyId, b: BodyId) -> Option<LinkPair> {
        // The frame is the first body, and the last one in names.
        let key = |body: BodyId| (body == GROUND, body);
        match key(a).cmp(&key(b)) {
            std::cmp::Ordering::Less => Some(LinkPair([a, b])),
            std::cmp::Ordering::Greater => Some(LinkPair([b, a])),
            std::cmp::Ordering::Equal => None,
        }
    }

    /// The pair that the name of a centre gives, as `P(1,3)` or `P(2,ground)`; `None` for any other text, for links that the mechanism does not have,
    /// and for a link with itself.
    #[must_use]
    pub fn named(name: &str, mechanism: &Mechanism) -> Option<LinkPair> {
        let written = QuantityName::parse(name).filter(|name| name.head == Head::Center && name.is_plain())?;
        let [a, b] = written.arguments.as_slice() else { return None };
        LinkPair::new(mechanism.link(a)?, mechanism.link(b)?)
    }

    /// The pair of two links by their names as a hand writes them: in either order, the frame also as 0.
    #[must_use]
    pub fn of_names(names: &[String], mechanism: &Mechanism) -> Option<LinkPair> {
        let link = |name: &String| match name.as_str() {
            "0" if mechanism.link("0").is_none() => Some(GROUND),
            name => mechanism.link(name),
        };
        match names {
            [a, b] => LinkPair::new(link(a)?, link(b)?),
            _ => None,
        }
    }

    /// All pairs of the frame and the links with names, those with the frame first.
    #[must_use]
    pub fn all(mechanism: &Mechanism) -> Vec<LinkPair> {
        let links: Vec<BodyId> = std::iter::once(GROUND).chain(mechanism.links().map(|(id, _)| id)).collect();
        let pairs = links.iter().enumerate().flat_map(|(index, &a)| links[index + 1..].iter().map(move |&b| (a, b)));
        pairs.filter_map(|(a, b)| LinkPair::new(a, b)).collect()
    }

    /// Its links in the order of the scene, the frame last.
    #[must_use]
    pub fn links(self) -> [BodyId; 2] {
        self.0
    }

    /// The other link; `None` for a link that is not in the pair.
    #[must_use]
    pub fn other(self, link: BodyId) -> Option<BodyId> {
        match self.0 {
            [a, b] if a == link => Some(b),
            [a, b] if b == link => Some(a),
            _ => None,
        }
    }

    /// The name of its centre in results and scenes: `P(1,3)`, `P(2,ground)`.
    #[must_use]
    pub fn name(self, mechanism: &Mechanism) -> String {
        let [a, b] = self.0.map(|link| mechanism.body(link).name.as_str());
        format!("{}({a},{b})", Head::Center.word())
    }

    /// The index of its centre's symbol, in markup: `13`, `20` with the frame last, by commas where a link has more than one sign.
    #[must_use]
    pub fn index(self, mechanism: &Mechanism, notation: &Notation, shown: &dyn Fn(&str) -> String) -> String {
        let [a, b] = self.0.map(|link| link_in_index(link, mechanism, notation, shown));
        let is_short = |text: &String| text.chars().count() == 1;
        if is_short(&a) && is_short(&b) { a + &b } else { format!("{a},{b}") }
    }

    /// The symbol of its centre, in markup: `P_{13}`; with primes that of a centre of the mechanism without a link.
    #[must_use]
    pub fn symbol(
        self,
        primes: usize,
        mechanism: &Mechanism,
        notation: &Notation,
        shown: &dyn Fn(&str) -> String,
    ) -> String {
        format!("{}{}_{{{}}}", notation.center, "′".repeat(primes), self.index(mechanism, notation, shown))
    }
}

/// A link in the index of a centre's symbol, in markup: as `shown` writes its name; the frame by its label, else by the notation's number for it, else as 0, unless a link is called so.
#[must_use]
pub fn link_in_index(
    link: BodyId,
    mechanism: &Mechanism,
    notation: &Notation,
    shown: &dyn Fn(&str) -> String,
) -> String {
    match (link, notation.frame_sign, notation.frame) {
        (GROUND, Some(sign), _) => sign.text(),
        (GROUND, None, Some(number)) => number.as_str().to_owned(),
        (GROUND, None, None) if mechanism.link("0").is_none() => "0".to_owned(),
        _ => shown(&mechanism.body(link).name),
    }
}
