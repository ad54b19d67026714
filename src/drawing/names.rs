use crate::mechanism::Mechanism;
use crate::plan::{Construction, display, image_name, normal_name, point_on};
use indexmap::IndexMap;

/// How names are shown: as [`display`] writes them, but a special point's with commas where its links have longer names than a
/// letter: `S24` as `S_{24}`, `Srodarm` of the legs rod and arm as `S_{rod,arm}`.
pub(super) struct Names(IndexMap<String, String>);

impl Names {
    pub(super) fn new(mechanism: &Mechanism, construction: &Construction) -> Names {
        let mut shown = IndexMap::new();
        for special in construction.special.iter().flatten() {
            let Some(rest) = special.name.strip_prefix('S').filter(|_| special.is_assur) else {
                continue;
            };
            let legs = special.cuts.map(|cut| cut.carrier);
            let legs = legs.map(|link| mechanism.body(link).name.as_str());
            // A point is called by its legs, or by its own link.
            let links = if legs.concat() == rest {
                legs.to_vec()
            } else {
                vec![rest]
            };
            if links.iter().all(|link| link.chars().count() == 1) {
                continue;
            }
            let low = links.join(",");
            shown.insert(special.name.clone(), format!("S_{{{low}}}"));
            shown.insert(image_name(&special.name), format!("s_{{{low}}}"));
            for cut in &special.cuts {
                let Some(start) = cut.start() else { continue };
                let start = point_on(mechanism, cut.leg.base, start);
                let name = normal_name(&start, &special.name);
                let image = display(&image_name(&start));
                shown.insert(name, format!("n_{{{image},{low}}}"));
            }
        }
        Names(shown)
    }

    /// The markup of a name.
    pub(super) fn markup(&self, name: &str) -> String {
        self.0.get(name).cloned().unwrap_or_else(|| display(name))
    }
}
