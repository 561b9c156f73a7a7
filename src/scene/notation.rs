//! How the names of an item stand in its formulas: as symbols, or as numbers substituted for them.

use super::{Scene, fill};
use crate::bank::Units;
use crate::expr::{Name, Notation, Symbol, SymbolKind};
use crate::math::symbol;
use crate::solution::Solution;
use crate::unit::Decimal;

/// Names as their symbols.
pub(crate) struct Symbols<'a, 't>(pub(crate) &'a Solution<'t>);

/// Names as the numbers that they have, in SI units; what has no number keeps its symbol.
pub(crate) struct NumberNotation<'a, 't>(pub(crate) &'a Solution<'t>);

impl Notation for Symbols<'_, '_> {
    fn name(&self, name: &Name) -> Symbol {
        let template = self.0.template();
        let info = template
            .graph
            .find(name)
            .and_then(|node| template.info(node));
        Symbol::letter(
            info.map(|info| &info.symbol)
                .or_else(|| template.symbols.get(name))
                .map_or_else(|| symbol(name.as_str()), |own| own.as_ref().clone()),
        )
    }
}

impl Notation for NumberNotation<'_, '_> {
    fn name(&self, name: &Name) -> Symbol {
        self.number(name)
            .unwrap_or_else(|| Symbols(self.0).name(name))
    }
}

/// Names as the values that they have, in the units in which they are printed.
pub(crate) struct Quantities<'a, 's, 't>(pub(crate) &'a Scene<'s, 't>);

impl Notation for Quantities<'_, '_, '_> {
    fn name(&self, name: &Name) -> Symbol {
        let (scene, template) = (self.0, self.0.solution().template());
        let known = template.graph.find(name);
        let known = known.and_then(|node| Some((node, template.info(node)?)));
        let Some((node, info)) = known.filter(|(_, info)| info.units.is_some()) else {
            return Symbols(scene.solution()).name(name);
        };
        let math = fill::value(scene, node, info);
        match scene.solution().evaluation().real(node) {
            Ok(number) if number < 0.0 => Symbol {
                math,
                kind: SymbolKind::NegativeQuantity,
            },
            _ if matches!(info.units, Some(Units::One(unit)) if unit.is_one()) => Symbol {
                math,
                kind: SymbolKind::Number,
            },
            _ => Symbol {
                math,
                kind: SymbolKind::Quantity,
            },
        }
    }
}

impl NumberNotation<'_, '_> {
    fn number(&self, name: &Name) -> Option<Symbol> {
        Some(symbol_of(self.decimal(name)?, self.0))
    }

    /// The number of a name, as it is printed in SI units.
    pub(crate) fn decimal(&self, name: &Name) -> Option<Decimal> {
        let (solution, template) = (self.0, self.0.template());
        let node = template.graph.find(name)?;
        let info = template.info(node)?;
        Some(
            match info
                .parameter
                .map(|place| solution.instance().values()[place])
            {
                // A datum in SI units stands as it is printed.
                Some(given) if matches!(info.units, Some(Units::One(unit)) if unit == unit.coherent() && given.unit == unit) => {
                    given.value
                }
                _ => Decimal::rounded(
                    solution.evaluation().real(node).ok()?,
                    u32::from(info.digits) + 1,
                )?,
            },
        )
    }
}

/// A number as a symbol: one that is negative is put in parentheses where it has to be.
pub(crate) fn symbol_of(number: Decimal, solution: &Solution<'_>) -> Symbol {
    let kind = if number.is_negative() {
        SymbolKind::Negative
    } else {
        SymbolKind::Number
    };
    Symbol {
        math: number.math(solution.mark()),
        kind,
    }
}
