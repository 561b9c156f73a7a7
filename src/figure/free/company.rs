//! What is drawn with the elements that a diagram keeps.

use crate::figure::element::Role;
use crate::figure::schematic::{ElementPlace, Item};

/// Adds what belongs to kept elements: bodies at the same centre, and coordinates and turns that start from them.
pub(crate) fn with_company(items: &[Item], kept: &mut Vec<usize>) -> Vec<u32> {
    let mut slots = Vec::new();
    let mut ends = Vec::new();
    for place in &*kept {
        let item = &items[*place];
        let own = item.ends.iter().filter_map(slot);
        if matches!(item.kind.role(), Role::Body(_)) {
            slots.extend(own.clone());
        }
        ends.extend(own);
    }
    for (place, item) in items.iter().enumerate() {
        let [end] = item.ends.as_slice() else {
            continue;
        };
        let Some(at) = slot(end) else { continue };
        let is_company = match item.kind.role() {
            Role::Body(_) => slots.contains(&at),
            Role::Measure => ends.contains(&at),
            _ => false,
        };
        if is_company && !kept.contains(&place) {
            kept.push(place);
        }
    }
    slots
}

/// The point of the figure at which something ends, or whose side it meets.
fn slot(place: &ElementPlace) -> Option<u32> {
    match place {
        ElementPlace::Named(slot) | ElementPlace::Side(slot, _) => Some(*slot),
        ElementPlace::Free(_) | ElementPlace::Pass(..) => None,
    }
}
