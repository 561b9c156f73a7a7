//! Symbols with what stands in brackets after them: `x(t)`, `V(π/2)`, `f [Hz]`.

/// A symbol and its brackets; it may be a product as well.
struct Called<'t> {
    name: &'t str,
    /// With the brackets.
    argument: &'t str,
}

impl<'t> Called<'t> {
    fn of(text: &'t str) -> Option<Self> {
        let open = text.find(['(', '[']).filter(|open| *open > 0)?;
        let (name, argument) = text.split_at(open);
        argument
            .ends_with([')', ']'])
            .then_some(Self { name, argument })
    }

    fn is_product(&self) -> bool {
        self.argument.contains(['+', '*']) || self.name.contains('\\')
    }
}

/// A text without what comes after a symbol, `(t)`, `(0)`, `[rad/s]`.
pub(crate) fn without_arguments(text: &str) -> &str {
    let called = Called::of(text).filter(|called| !called.is_product());
    called.map_or(text, |called| called.name.trim_end())
}

/// Whether the argument of a label is a number, `V(0)`, `V(π/2)`.
pub(crate) fn is_at_value(label: &str) -> bool {
    let Some(called) = Called::of(label).filter(|called| !called.is_product()) else {
        return false;
    };
    let argument = called.argument.trim_matches(['(', ')', '[', ']']);
    let digits = argument.replace("\\pi", "").replace("pi", "");
    let is_of_number = |char: char| "0123456789.,/-+π° ∞".contains(char);
    !argument.is_empty() && digits.chars().all(is_of_number)
}

/// Whether an equation is the state at the start, `x(0) = 0`.
pub(crate) fn is_initial_state(equation: &str) -> bool {
    let left = equation.split_once('=').map_or("", |(left, _)| left);
    let Some(Called { name, argument }) = Called::of(left.trim_end()) else {
        return false;
    };
    let is_of_name =
        |char: char| char.is_alphanumeric() || "_'\"\\{} \u{307}\u{308}".contains(char);
    argument == "(0)"
        && name.starts_with(|first: char| first.is_alphabetic() || first == '\\')
        && name.chars().all(is_of_name)
}
