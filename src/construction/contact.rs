//! The sentences on profiles that touch: what moves as they do.

use crate::mechanism::{Mechanism, Touch};
use crate::words::Wording;

/// A sentence on each contact, in markup; `shown` gives the text for a name.
#[must_use]
pub fn contacts_told(mechanism: &Mechanism, words: &Wording, shown: &dyn Fn(&str) -> String) -> Vec<String> {
    let language = words.language;
    let told = mechanism.contacts.iter().map(|contact| {
        let [first, second] = contact.bodies.map(|body| match mechanism.body(body).name.as_str() {
            "ground" => words.ground().to_owned(),
            name => shown(name),
        });
        let point = |id| shown(mechanism.point_name(id));
        let said = match contact.touch {
            Touch::Arcs { link, centers, .. } => {
                let [from, to] = centers.map(point);
                language.contact_link(&shown(&mechanism.body(link).name), &first, &second, &from, &to)
            }
            Touch::Face { center, .. } => language.contact_face(&first, &second, &point(center)),
        };
        match contact.is_circular {
            true => said,
            false => format!("{said} {}", language.contact_here()),
        }
    });
    told.collect()
}
