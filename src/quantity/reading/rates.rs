//! How a hand reads rates of links and sliders.

use super::{Reader, Unread};
use crate::construction::{Equation, NumberId, NumberKind, Product, ProductKind, Rate};
use crate::mechanism::BodyId;
use crate::quantity::name::QuantityRequest;
use crate::sheet::Order;

impl Reader<'_> {
    /// A rate that is solved for; given rates are not read.
    pub(super) fn rate(&self, rate: Rate) -> Result<NumberId, Unread> {
        let is_given = match rate {
            Rate::Angular(_, link) => self.is_given(link),
            Rate::Slide(_, id) => self.writer.mechanism.slider(id).drive.is_some(),
        };
        if !is_given && !self.draws(rate.order()) {
            return self.rate_by_centers(rate);
        }
        let number = if is_given { None } else { self.rate_or_given(rate)? };
        number.ok_or(Unread::Given)
    }

    /// A rate of a link, or the one that the scene gives; `None` if it is zero.
    fn angular_or_given(&self, order: Order, link: BodyId) -> Result<Option<NumberId>, Unread> {
        let rate = Rate::Angular(order, link);
        if self.is_given(link) { self.rate_or_given(rate) } else { self.rate(rate).map(Some) }
    }

    /// The difference of two rates, of which the scene gives one at most.
    pub(super) fn relative_rate(
        &mut self,
        asked: &QuantityRequest,
        order: Order,
        links: [BodyId; 2],
    ) -> Result<NumberId, Unread> {
        self.needs_found(links)?;
        let mut sum = Vec::new();
        for (link, sign) in links.into_iter().zip([1.0, -1.0]) {
            let number = self.angular_or_given(order, link)?;
            sum.extend(number.map(|number| Product::new(ProductKind::Plain, sign, &[number])));
        }
        Ok(self.computed(asked, sum))
    }

    /// The quotient of two angular velocities, of which the scene gives one at most.
    pub(super) fn speed_ratio(&mut self, asked: &QuantityRequest, links: [BodyId; 2]) -> Result<NumberId, Unread> {
        self.needs_found(links)?;
        let [own, other] = links.map(|link| self.angular_or_given(Order::Velocity, link));
        let (Some(own), Some(other)) = (own?, other?) else { return Err(Unread::Given) };
        let row = Equation { left: vec![(0, Product::plain(other))], right: vec![Product::plain(own)] };
        let sheet = asked.sheet_by_hand(&self.writer.construction);
        let kind = NumberKind::Reading(asked.name().to_owned());
        let found = self.writer.solve(sheet, vec![kind], vec![row]).ok_or(Unread::NotDrawn)?;
        found.first().copied().ok_or(Unread::NotDrawn)
    }

    /// Refuses links of which the scene gives both rates.
    fn needs_found(&self, links: [BodyId; 2]) -> Result<(), Unread> {
        if links.into_iter().all(|link| self.is_given(link)) { Err(Unread::Given) } else { Ok(()) }
    }

    /// A number that a calculator finds from others.
    pub(super) fn computed(&mut self, asked: &QuantityRequest, sum: Vec<Product>) -> NumberId {
        let sheet = asked.sheet_by_hand(&self.writer.construction);
        self.writer.compute(sheet, NumberKind::Reading(asked.name().to_owned()), sum)
    }

    /// Whether the rotation of a link is given, its own or that of a body with which sliders make it turn alike.
    fn is_given(&self, link: BodyId) -> bool {
        let mechanism = self.writer.mechanism;
        let rates = &self.writer.construction.angular_rates;
        let mut known = mechanism.body_ids().filter(|&b| mechanism.is_known(b));
        mechanism.is_known(link) || rates[link.0].is_some() && known.any(|b| rates[b.0] == rates[link.0])
    }

    /// A rate that is solved for or given; `None` if it is given as zero.
    pub(super) fn rate_or_given(&self, rate: Rate) -> Result<Option<NumberId>, Unread> {
        self.writer.construction.rate(rate).ok_or(Unread::NoConstruction)
    }
}
