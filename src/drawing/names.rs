use crate::construction::{Construction, Special, display, image_name, point_on};
use crate::mechanism::Mechanism;
use indexmap::IndexMap;

/// Markup of names: as [`display`] gives it, but with commas between a special point's links where these have names
/// longer than a letter: `S24` as `S_{24}`, `Srodarm` of the legs rod and arm as `S_{rod,arm}`, `n_b_rodC` as
/// `n_{b_{rod}C}`.
pub(super) struct Names(IndexMap<String, String>);

impl Names {
    pub(super) fn new(mechanism: &Mechanism, construction: &Construction) -> Names {
        let mut shown = IndexMap::new();
        for special in construction.special.iter().flatten() {
            let links = links(mechanism, special);
            let long = links.iter().any(|link| link.chars().count() > 1);
            let low = links.join(if long { "," } else { "" });
            if special.is_assur {
                shown.insert(special.name.clone(), format!("S_{{{low}}}"));
                shown.insert(image_name(&special.name), format!("s_{{{low}}}"));
            }
            let normals = special.normal_names(mechanism);
            for (side, (cut, name)) in special.cuts.iter().zip(normals).enumerate() {
                let Some(start) = cut.start() else { continue };
                let start = point_on(mechanism, cut.leg.base, start);
                let image = display(&image_name(&start));
                if let Some(slide) = cut.slide(mechanism) {
                    let entered = &mechanism.body(slide.to).name;
                    shown.insert(special.coriolis_name(mechanism, side), format!("k_{{{image}{entered}}}"));
                }
                let end = match (special.is_assur, long) {
                    (true, true) => format!(",{low}"),
                    (true, false) => low.clone(),
                    (false, _) => display(&special.name),
                };
                let letter = name.split('_').next().unwrap_or("n");
                let markup = format!("{letter}_{{{image}{end}}}");
                shown.insert(name, markup);
            }
        }
        Names(shown)
    }

    /// The markup of a name.
    pub(super) fn markup(&self, name: &str) -> String {
        self.0.get(name).cloned().unwrap_or_else(|| display(name))
    }
}

/// The links in a special point's name: those of its legs, or its own link.
fn links<'a>(mechanism: &'a Mechanism, special: &'a Special) -> Vec<&'a str> {
    let name = special.name.strip_prefix('S').unwrap_or(&special.name);
    let legs = special.cuts.each_ref().map(|cut| cut.carrier);
    let legs = legs.map(|link| mechanism.body(link).name.as_str());
    if legs.concat() == name { legs.to_vec() } else { vec![name] }
}
