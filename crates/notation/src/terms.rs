//! Where a long formula may go on in the next line.

use super::{Class, Math};

impl Math {
    /// The formula cut before each sign between its terms, so that it can go on in another line there;
    /// side by side the pieces are the formula.
    ///
    /// ```
    /// use vibank_notation::Math;
    ///
    /// let sum = Math::row([Math::letter('a'), Math::binary("+"), Math::letter('b')]);
    /// let pieces = sum.terms();
    /// assert_eq!(pieces.len(), 2);
    /// assert_eq!(pieces[1].plain(), "+ b");
    /// ```
    pub fn terms(&self) -> Vec<Math> {
        let Math::Row(row) = self else {
            return vec![self.clone()];
        };
        let mut terms = Vec::new();
        let mut term = Vec::new();
        for piece in row {
            if is_sign(piece) && !term.is_empty() {
                terms.push(Math::Row(std::mem::take(&mut term)));
            }
            term.push(piece.clone());
        }
        terms.push(Math::Row(term));
        terms
    }
}

fn is_sign(piece: &Math) -> bool {
    let Math::Operator { text, class } = piece else {
        return false;
    };
    *class == Class::Binary && matches!(text.as_str(), "+" | "−" | "-" | "±" | "∓")
}
