//! The key `bound` of a part: which bound of a quantity its answer is.

use super::{AnswerError, Declare};
use crate::response::AskedBound;
use crate::source::Table;

/// The bound that a part asks for, if it says so; what is wrong is noted.
pub(crate) fn read(part: &Table<'_>, declare: &mut dyn Declare) -> Option<AskedBound> {
    let text = part.text("bound")?;
    match text.value.as_str() {
        "lower" => Some(AskedBound::Lower),
        "upper" => Some(AskedBound::Upper),
        _ => {
            let error = AnswerError::Unread(text.value.clone(), "bound: `lower` or `upper`");
            declare.find(&error, &text);
            None
        }
    }
}
