//! Why a response could not be read.

use crate::answer::{At, Example, Trouble, Unreadable, Why};
use crate::source::capital;
use crate::unit::DecimalMark;

/// What is said where a response could not be read.
pub(crate) fn unreadable(unreadable: &Unreadable) -> String {
    let why = why(&unreadable.why);
    let mut sentence = match &unreadable.at {
        _ if why.is_empty() => String::new(),
        Some(At::Here(place)) => format!("At `{place}`: {why}"),
        Some(At::Behind(place)) => format!("After `{place}`: {why}"),
        None => capital(&why),
    };
    if let Some(symbol) = unreadable.undefined() {
        sentence.push_str(&format!(" Or add what it is: `…, {symbol} = …`."));
    }
    if let Some(example) = unreadable.example {
        if !sentence.is_empty() {
            sentence.push(' ');
        }
        sentence.push_str(self::example(example));
    }
    sentence
}

fn example(example: Example) -> &'static str {
    match example {
        Example::Number => "Type a number and its unit, for example `15.8 rad/s` or `1.6e-2 m`.",
        Example::UnitLast => {
            "Type one number and its unit, the unit last: `15.8 rad/s`, `1.6e-2 m`, `sqrt(2)/2 m`."
        }
        Example::Complex => {
            "Type a complex number and its unit, for example `3 - 4i ohm` or `5 ohm at -53 deg`."
        }
        Example::Interval => "Type for example `0.1 <= x < 0.5`, `x > 2` or `[0.1, 0.5)`.",
        Example::OneValue => "Type it alone, or after its name as in `x = 7.78`.",
    }
}

/// Why a response could not be read: a sentence that goes on after a place.
#[expect(clippy::too_many_lines, reason = "a table")]
fn why(why: &Why) -> String {
    match why {
        Why::Form => String::new(),
        Why::TooLong => "this is too long to be read.".to_owned(),
        Why::LongerThan(bytes) => format!("the answer is longer than {bytes} bytes."),
        Why::NoKey(crate::quantity::Absent::ByHand) => "this part is not marked by the program: a person marks it.".to_owned(),
        Why::NoKey(absent) => format!("this part cannot be marked for these data: {absent}."),
        Why::Dollar => "a dollar sign is not a unit, and this one encloses no formula. Omit it.".to_owned(),
        Why::Formula(trouble) => formula(trouble),
        Why::Quantity(error) => {
            let help = error.help().map(|help| format!(" {}.", capital(&help)));
            format!("{error}.{}", help.unwrap_or_default())
        }
        Why::Dimension(error) => match error {
            Some(error) => format!("{error}."),
            None => "the dimensions do not fit.".to_owned(),
        },

        Why::Letters => "a number is asked for, without letters.".to_owned(),
        Why::UnitNotLast => "the unit comes last, after the complete number.".to_owned(),
        Why::Counted(word) => format!("type the number alone, without `{word}`."),
        Why::CountedUnit => "type the number alone, without what it counts.".to_owned(),
        Why::NumberAlone => "a number alone is asked for: omit what it counts.".to_owned(),
        Why::TwoSigns(text) => format!("`{text}` begins with two signs: give one number."),
        Why::NoValue(text) => format!("`{text}` has no value."),
        Why::ExponentMissing(text) => format!(
            "in `{text}` the exponent is missing after `e`: type `2e-3`, or `exp(1)` for the number e."
        ),
        Why::RangeOrDifference(text) => format!(
            "`{text}` may be a range or a difference: give one number, or spaces around the minus."
        ),
        Why::MixedDegrees => {
            "one of these angles has a degree sign, another has none.".to_owned()
        }
        Why::TwoUnits => "there are two units.".to_owned(),
        Why::CommaOfThree {
            typed,
            decimal,
            thousands,
        } => format!(
            "the comma in `{typed}` may separate decimals or thousands: write `{decimal}` or `{thousands}`."
        ),
        Why::PointOrProduct(number) => format!(
            "the point may be a decimal sign or stand for a product. Write a power of ten as in `{number}e3` or `{number}*10^3`."
        ),
        Why::BracketAfterNumber => "it is not clear whether this is a factor or another value. Type one number; a product needs its sign, `*`.".to_owned(),
        Why::Inequality => "one value is asked for.".to_owned(),
        Why::UnitOfZero => "the other side of the equation has another unit. Omit that of the zero, and check the terms.".to_owned(),
        Why::UnequalSides(one, other) => {
            format!("`{one}` and `{other}` are not equal: give one value.")
        }
        Why::OutsideOfSpan => "the question is about other times than these. Omit them if it holds there, too.".to_owned(),
        Why::Withdrawn => "this says that the answer is withdrawn. Type what you mean, and that alone.".to_owned(),
        Why::UnclearSide => "it is not clear what the value is of. Type it alone, or after the name of what is asked for, as in `x = 7.78`.".to_owned(),
        Why::TooManyTurns { times, turn } => format!(
            "this is more than {times} times {}: give the value within one turn.",
            turn.text(DecimalMark::Point)
        ),
        Why::Gram => "`g` is the gram: write `g0` for the acceleration of free fall.".to_owned(),
        Why::AngleInUnit(asked) => {
            format!("angles do not enter like this; the answer is in {}.", asked.text())
        }
        Why::OtherQuantity => {
            "this names another quantity than the one asked for. Give the answer alone.".to_owned()
        }
        Why::LabelsInOtherOrder => {
            "the lower one of these has the first symbol: give the values without symbols, or exchange them.".to_owned()
        }
        Why::LabelTwice => {
            "two values have this symbol: give the values without symbols, or each its own.".to_owned()
        }
        Why::EmptyPlace => "a value is missing here.".to_owned(),
        Why::MostNumbers(most) => format!("a list has at most {most} numbers."),
        Why::TightComma => "a comma between digits may be a decimal sign: separate the numbers by semicolons, as in `5; 8.7`.".to_owned(),
        Why::AngleWithoutUnit(angle) => {
            format!("the angle `{angle}` has no unit: is it in degrees? Type `{angle}°`.")
        }
        Why::AngleUnit => "an angle is in degrees or radians.".to_owned(),
        Why::SeveralComplex => "one complex number is asked for.".to_owned(),

        Why::NoOption(last) => format!("this is not one of the options: type a letter from a to {last}."),
        Why::OneOption => "choose one option: type one letter.".to_owned(),
        Why::Ranking(count) => format!("give all {count} letters, each once, in order."),

        Why::JoinInequalities => "join the inequalities by `or`, or by `and`.".to_owned(),
        Why::NoneSatisfies(text) => format!("no value satisfies `{text}`. Join ranges by `or`."),
        Why::LongChain => "this chain of inequalities is too long.".to_owned(),
        Why::SameWay => "both signs point the same way.".to_owned(),
        Why::NoInterval => "no inequality sign and no interval.".to_owned(),
        Why::BeforeInterval(symbol) => format!(
            "only `{symbol} in` may stand before an interval of values; several are joined by `or`."
        ),
        Why::IntervalBracket => "a bracket is missing.".to_owned(),
        Why::NoUnit => "this is not a known unit.".to_owned(),
        Why::TwoEnds => {
            "an interval has two ends; with decimal commas, separate them by a semicolon.".to_owned()
        }
        Why::SolveForDistance(symbol) => format!("solve for `{symbol}` or `|{symbol}|` first."),
        Why::SolveFor(symbol) => format!("solve for `{symbol}` first."),
        Why::NotInInequality(symbol) => format!("`{symbol}` does not occur in this inequality."),
        Why::BoundsOrder => "the lower bound is above the upper one.".to_owned(),
        Why::BoundsAsFormulas => "give the bounds as formulas in symbols.".to_owned(),
        Why::BoundsAsNumbers => "give the bounds as numbers.".to_owned(),
        Why::BoundValue => "this has no value.".to_owned(),

        Why::FormulaNotNumber => {
            "a formula in symbols is asked for, not a number: give it without its value.".to_owned()
        }
        Why::Incomparable => {
            "this formula cannot be compared; write it in a simpler form.".to_owned()
        }
        Why::DigitsLost => "all digits are lost when this is computed, so it cannot be compared; write it in a simpler form.".to_owned(),
        Why::TwoReadings(one, other) => format!(
            "this can be read as `{one}` or as `{other}`: type the one you mean."
        ),
        Why::UnitBehindLetters => {
            "letters carry their units, and this one does not fit. Omit it.".to_owned()
        }
        Why::UnitComesOut(unit) => {
            let own = unit.map_or("as a pure number".to_owned(), |unit| format!("in {}", unit.text()));
            format!("letters carry their units, and this comes out {own} by itself. Omit the unit.")
        }

        Why::NoEquation => "an equation is asked for: an equals sign is missing.".to_owned(),
        Why::NotInequality => "an equation is asked for, not an inequality.".to_owned(),
        Why::EquationNumber => {
            "is this the number of the equation? Omit it; a factor is written `2*`.".to_owned()
        }
        Why::InitialState => {
            "give the equation alone; the initial state does not belong to it.".to_owned()
        }
        Why::IncomparableEquation => {
            "this equation cannot be compared; write it in a simpler form.".to_owned()
        }
        Why::Figures { asked, number, has } => {
            format!("{asked} significant figures are asked for, `{number}` has {has}.")
        }
        Why::RoundedNumbers => {
            "its numbers are rounded; give them exactly, as fractions, roots or multiples of π."
                .to_owned()
        }
        Why::ValuesForLetters => {
            "write it with the letters of the question, not with their values.".to_owned()
        }

        Why::EntriesAsNumbers => "give the entries as numbers.".to_owned(),
        Why::IncomparableEntries => {
            "these entries cannot be compared; write them in a simpler form.".to_owned()
        }
        Why::UnitBehindMatrix => {
            "this is left over after the matrix. Letters carry their units: omit it.".to_owned()
        }
        Why::Shape { found, asked } => format!(
            "this has {} of {}; a matrix of {} by {} is asked for, such as `[[a, b], [c, d]]`, with a comma between entries.",
            counted(found.0, "row"),
            found.1,
            asked.0,
            asked.1
        ),
        Why::NumbersNotFormulas => "numbers are asked for here, not formulas.".to_owned(),
        Why::FormulasNotNumbers => "formulas in symbols are asked for here, not numbers.".to_owned(),
        Why::EntryValue => "an entry has no value.".to_owned(),
        Why::UnitOfEntries(unit) => format!("the unit `{}` does not fit all entries.", unit.text()),

        Why::UnitOfComponents => {
            "the components have several units; omit it and give them in SI units.".to_owned()
        }
        Why::UnitOfShape(unit) => format!(
            "this unit does not fit; a shape with unit modal mass is in {}.",
            unit.text()
        ),
        Why::ComponentValue => "a component has no value.".to_owned(),
        Why::Components { found, asked } => format!(
            "this has {}; {asked} are asked for, such as `(1, -0.5)` for two.",
            counted(*found, "component")
        ),
        Why::ShapesOf {
            found,
            rows,
            shapes,
            width,
        } => format!(
            "this has {} in {}; {shapes} shapes of {} are asked for, such as `(1, -0.5), (1, 2)`.",
            counted(*found, "component"),
            counted(*rows, "row"),
            counted(*width, "component")
        ),

        Why::UnequalFunctions(last) => format!(
            "the two sides of the equals sign before `{last}` are not the same function: give one."
        ),
        Why::UnitOrQuantity => "a letter can be a unit or a quantity here: give the numbers in SI units, without a unit.".to_owned(),
        Why::AngleAdded => {
            "an angle is added to the function: put brackets, as in `cos(5 t + 30°)`.".to_owned()
        }
        Why::UnitOfArgument => {
            "what stands in a sine, an exponential or another function is a number or an angle; here a unit is left over."
                .to_owned()
        }
        Why::UnitOfTerms => "give each term its unit, or write one after the whole.".to_owned(),
        Why::UnitOfFunction(unit) => {
            format!("the unit does not fit; the answer is in {}.", unit.text())
        }
        Why::OneFunction(asked) => format!("one function is asked for here: {asked} = …."),
        Why::OtherFunction(asked) => format!(
            "{asked} is asked for. Give it alone, or with its own name before the equals sign."
        ),
        Why::UnclearFunction(asked) => format!(
            "it is not clear what this stands for; write {asked} = … or the function alone."
        ),
        Why::Functions(symbols) => {
            let forms: Vec<String> = symbols.iter().map(|symbol| format!("{symbol} = …")).collect();
            format!("give one function of time each, joined by semicolons: {}.", forms.join("; "))
        }
        Why::TwoFunctions(symbol) => format!("there are two functions for {symbol}."),
        Why::FunctionMissing => "a function is missing.".to_owned(),
        Why::TooManyConstants { most, needed } => {
            format!("use at most {most} constants; {needed} would do.")
        }
        Why::Undifferentiable => {
            "these functions cannot be differentiated; write them in a simpler form.".to_owned()
        }
    }
}

/// Why a formula could not be read.
fn formula(trouble: &Trouble) -> String {
    let listed = |words: &str, letters: &[String]| match letters {
        [] => ".".to_owned(),
        all => format!("; {words} {}.", all.join(", ")),
    };
    match trouble {
        Trouble::Unknown {
            near: Some(near), ..
        } => return format!("it is not clear what this means; did you mean `{near}`?"),
        Trouble::Unknown {
            near: None,
            letters,
        } => return format!("it is not clear what this means{}", listed("the letters are", letters)),
        Trouble::NotAllowed(letters) => {
            return format!("the answer may not contain this{}", listed("give it in", letters));
        }
        Trouble::Arguments {
            name,
            least: 1,
            most: 1,
        } => return format!("`{name}` takes one argument."),
        Trouble::Arguments { name, least, .. } => {
            return format!("`{name}` takes {least} arguments in brackets; write decimals with a point.");
        }
        Trouble::Missing => "a formula is missing here.",
        Trouble::TooLong => "this is too long to be read.",
        Trouble::TooDeep => "this is nested too deeply.",
        Trouble::Unit => {
            "units do not belong into a formula: letters carry their own, and numbers are in SI units."
        }
        Trouble::Sign => "this sign has no meaning here.",
        Trouble::Number => "this number has too many digits.",
        Trouble::Bracket => "this bracket has no partner.",
        Trouble::NumberAfter => {
            "a sign is missing before this number; write `*` for a product or `^` for a power."
        }
        Trouble::List => "one formula is expected here, not a list; write decimals with a point.",
        Trouble::Exponent => {
            "does this belong to the exponent? Write brackets: `e^(-2 t)` or `e^(-2)*t`."
        }
        Trouble::Logarithm => "write `ln` or `log10`.",
        Trouble::TwoValues => "give one value, without `±`.",
        Trouble::Unsolved => {
            "only the symbol that is asked for may stand before an equals sign; solve for it and give the formula alone."
        }
        Trouble::LeftOver => "this is left over; is a sign missing before it?",
        Trouble::NoRelation => "an equals sign or an inequality sign is missing.",
        Trouble::UnitOfEntry => "give one unit for all, after the list in brackets.",
        Trouble::UnitOrLetter => {
            "this ends with a letter or with a unit; put the list in brackets, and that after them."
        }
        Trouble::Order => "give them in the order of the question, as a list without names.",
        Trouble::NamedMatrices => {
            "the names of matrices do not say what is in them: write their entries, as in `det([[a, b], [c, d]])`, or the determinant itself."
        }
        Trouble::Determinant => "bars make a determinant or a norm of it: put a matrix in square brackets.",
        Trouble::Ragged => "the rows have different lengths.",
        Trouble::Value(_) => "this is not a number.",
    }
    .to_owned()
}

/// A count with its noun.
fn counted(count: usize, noun: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {noun}{plural}")
}
