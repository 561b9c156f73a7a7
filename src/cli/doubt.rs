//! The option `--doubt`.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use vibank::answer::Doubt;

/// Reads a policy by its name.
pub(crate) fn doubt() -> impl TypedValueParser<Value = Doubt> {
    let names = Doubt::ALL.map(Doubt::name);
    PossibleValuesParser::new(names).map(|name| Doubt::of_name(&name).unwrap_or_default())
}
