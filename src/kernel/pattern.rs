use super::action::{Arm, Chain, Closing, Member, NO_ARM, Order, Own, Pattern, PatternLoop, ReducedColumns, Unknown};

impl Pattern {
    /// `None` for other kinds.
    pub fn new(closing: &Closing) -> Option<Pattern> {
        let arm = |m: &Member| Arm { class: m.class, column: m.column };
        match (closing.reduced?, &closing.chains[..]) {
            (ReducedColumns::One(_), [chain]) => {
                let Unknown::Spin(_) = closing.unknowns[0] else { return None };
                let first = chain.members.iter().find(|m| m.spin == Some(0))?;
                let other = chain.members.iter().find(|m| m.spin != Some(0));
                let own = match (&chain.rails[..], other) {
                    ([], Some(other)) if other.spin == Some(1) => Own::Nothing,
                    ([rail], other) if rail.slide == Some(1) => {
                        let on_second = rail.arm != first.column;
                        if other.is_some_and(|m| m.spin.is_some() || m.column != rail.arm) {
                            return None;
                        }
                        Own::Slide { slider: rail.slider, column: rail.column, on_second }
                    }
                    _ => return None,
                };
                let known = [Some(first.column), other.map(|m| m.column), None];
                let order = Order::new(chain, known)?;
                let one =
                    PatternLoop { ends: chain.ends, first: arm(first), second: other.map_or(NO_ARM, arm), own, order };
                Some(Pattern::One(one))
            }
            (ReducedColumns::Two { varies: [false, false], .. }, [a, b]) => {
                let [Unknown::Spin(_), Unknown::Spin(_), ..] = closing.unknowns[..] else { return None };
                let of_loop = |chain: &Chain, own: usize| {
                    let of = |unknown: usize| chain.members.iter().find(|m| m.spin == Some(unknown));
                    let (first, second) = (of(0)?, of(1)?);
                    let own = match (&chain.rails[..], of(own)) {
                        ([], Some(own)) => Own::Spin(arm(own)),
                        ([rail], None) if rail.slide == Some(own) => {
                            let on_second = rail.arm == second.column;
                            if !on_second && rail.arm != first.column {
                                return None;
                            }
                            Own::Slide { slider: rail.slider, column: rail.column, on_second }
                        }
                        _ => return None,
                    };
                    let third = if let Own::Spin(own) = own { Some(own.column) } else { None };
                    let order = Order::new(chain, [Some(first.column), Some(second.column), third])?;
                    Some(PatternLoop { ends: chain.ends, first: arm(first), second: arm(second), own, order })
                };
                let both = [of_loop(a, 2)?, of_loop(b, 3)?];
                let slides = both.iter().filter(|one| matches!(one.own, Own::Slide { .. })).count();
                (slides < 2).then_some(Pattern::Two(both))
            }
            _ => None,
        }
    }
}

impl Order {
    /// The order in which these columns stand; `None` if there are others.
    fn new(chain: &Chain, columns: [Option<usize>; 3]) -> Option<Order> {
        let place = |m: &Member| columns.iter().position(|c| *c == Some(m.column));
        let places: Vec<usize> = chain.members.iter().map(place).collect::<Option<_>>()?;
        Some(match places[..] {
            [0] => Order::A,
            [0, 1] => Order::Ab,
            [1, 0] => Order::Ba,
            [0, 1, 2] => Order::Abc,
            [0, 2, 1] => Order::Acb,
            [1, 0, 2] => Order::Bac,
            [1, 2, 0] => Order::Bca,
            [2, 0, 1] => Order::Cab,
            [2, 1, 0] => Order::Cba,
            _ => return None,
        })
    }
}
