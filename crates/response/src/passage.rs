//! A response, or a part of one, as the kinds of answers see it: not by its signs, but by what can be read in it.

use std::fmt;

use super::before_unit::{BeforeUnit, before_units};
use super::defined::Defining;
use super::list::{Listed, Wanted};
use super::measured::{self, Measured};
use super::naming;
use super::pieces::{self, FunctionPiece};
use super::reworded::{self, Reworded};
use super::signs::{is_digit, is_of_name};
use super::stated::Stated;
use super::words::{CONCLUDING, REMARKS};
use super::{
    Chain, Lexicon, Manner, Phrase, Typed, TypedError, Wording, again, answering, arguments,
    both_signs, components, counts, distance, entry_units, equated, equations, free_letters,
    layout, list, matrix_form, ranks, related, relation, sides,
};
use vibank_formula::expr::{Expr, Kind, Name};
use vibank_formula::unit::Unit;
use vibank_source::{Span, lower};

/// Signs of a folded response that stand together: all of it, or a part.
///
/// What a kind of answers wants to know of it is one of its methods; its text is only quoted.
///
/// ```
/// use vibank_formula::expr::{Expr, Name};
/// use vibank_notation::symbol;
/// use vibank_response::{Folded, Lexicon, Manner};
///
/// let mut lexicon = Lexicon::new();
/// lexicon.allow(&Name::new("k"), symbol("k"), false);
/// let folded = Folded::of("k_eq = 2k").expect("no dollar sign stands alone");
/// let sides = folded.passage().sides(&lexicon).expect("a name and a formula");
/// let formula = sides[0].formula(&lexicon, Manner::default()).expect("it is a formula");
/// assert_eq!(formula.value, Expr::read("2*k")?);
/// # Ok::<(), vibank_formula::expr::ReadError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Passage<'t>(&'t str);

impl<'t> Passage<'t> {
    /// A folded text, without the spaces around it.
    pub fn of(text: &'t str) -> Self {
        Self(text.trim())
    }

    pub(crate) fn text(self) -> &'t str {
        self.0
    }

    /// The part of it where something stands that was read of it.
    #[must_use]
    pub fn part(self, span: Span) -> Self {
        Self::of(self.0.get(span.range()).unwrap_or_default())
    }

    /// Whether nothing was typed.
    pub fn is_empty(self) -> bool {
        self.0.is_empty()
    }

    /// Whether it has fewer bytes than so many.
    pub fn is_shorter_than(self, length: usize) -> bool {
        self.0.len() < length
    }

    /// Whether it is this word.
    pub fn is(self, word: &str) -> bool {
        self.0 == word
    }

    /// As much of it as a message can quote.
    pub fn short(self) -> String {
        // With its quotation a message still fits on a line or two.
        const MAX_COUNT: usize = 40;
        let start: String = self.0.chars().take(MAX_COUNT).collect();
        if start.len() < self.0.len() {
            format!("{start}…")
        } else {
            start
        }
    }

    /// The formula that it is, after a symbol and an equals sign that may stand before it.
    ///
    /// # Errors
    ///
    /// What cannot be read.
    pub fn formula(self, lexicon: &Lexicon, manner: Manner) -> Result<Typed<Expr>, TypedError> {
        super::formula(self.0, lexicon, manner)
    }

    /// The equation or comparison that it is.
    ///
    /// # Errors
    ///
    /// What cannot be read, or that nothing is compared.
    pub fn chain(self, lexicon: &Lexicon, manner: Manner) -> Result<Typed<Chain>, TypedError> {
        super::chain(self.0, 0, self.0.len(), lexicon, manner)
    }

    /// The comparison that the condition of a piece is; the unit after a number of it, one of SI, adds nothing.
    ///
    /// # Errors
    ///
    /// What cannot be read.
    pub fn comparison(self, lexicon: &Lexicon, manner: Manner) -> Result<Expr, TypedError> {
        let bare = pieces::without_if(self);
        let read = |passage: Self| {
            let chain = passage.chain(lexicon, manner)?.value;
            Ok(Expr::derived(Kind::Compare(chain.sides, chain.relations)))
        };
        read(bare).or_else(|error| {
            let mut cuts = bare.before_units().filter(|cut| cut.unit.to_si(1.0) == 1.0);
            cuts.find_map(|cut| read(cut.formula).ok()).ok_or(error)
        })
    }

    /// The list of a form that is asked: see [`Wanted`].
    ///
    /// # Errors
    ///
    /// What cannot be read.
    pub fn list(
        self,
        lexicon: &Lexicon,
        units: &[Unit],
        wanted: Wanted,
        fits: impl Fn(&Listed) -> bool,
    ) -> Result<Listed, TypedError> {
        list::list_of_form(self.0, lexicon, units, wanted, fits)
    }

    /// A list of so many values in the order of what each is said to be, `lower: 5 m, upper: 6 m`.
    pub fn in_said_order(self, count: usize) -> Option<Reworded> {
        ranks::in_order(self.0, count).map(Reworded::of)
    }

    /// Whether it is no more than words that can stand beside any value of its kind, `stable`.
    pub fn is_remark(self) -> bool {
        REMARKS.contains(&lower(self.0).as_str())
    }

    /// The components of a sum of vectors after its last equals sign; nothing where no vectors of this length stand.
    ///
    /// # Errors
    ///
    /// What stands in the way, such as a term without a vector.
    pub fn components(
        self,
        count: usize,
        lexicon: &Lexicon,
        manner: Manner,
    ) -> Result<Option<Vec<Expr>>, TypedError> {
        components::components(self.0, count, lexicon, manner)
    }

    /// The ways to cut it into a formula and a unit after it, the shortest unit first.
    pub fn before_units(self) -> impl Iterator<Item = BeforeUnit<'t>> {
        before_units(self.0)
    }

    /// What it says that its symbol is: each side of its equals signs but the symbol, the last one last.
    ///
    /// # Errors
    ///
    /// Where more than a symbol stands on the left: `ω0² = k/m` is true, but no formula for ω0.
    pub fn sides(self, lexicon: &Lexicon) -> Result<Vec<Self>, TypedError> {
        let sides = sides::sides(self.0, lexicon)?.into_iter();
        Ok(sides.map(|side| self.part(side)).collect())
    }

    /// Its statements, of which the one counts that `answers`, by what stands before its equals sign.
    ///
    /// # Errors
    ///
    /// Where it is not clear which of them counts.
    pub fn stated(self, answers: impl Fn(Self) -> bool) -> Result<Stated<'t>, TypedError> {
        Stated::of(self.0, answers)
    }

    /// What stands between its equals signs, the symbol before the first one among them.
    pub fn statement(self) -> Vec<Self> {
        let sides = sides::statement(self.0).into_iter();
        sides.map(Self::of).collect()
    }

    /// The equations among its statements, in which others say what letters are, or the custom of the field does:
    /// `m a + k x = 0 with a = x''`. None where nothing is said beside it.
    pub fn defined_chains(
        self,
        lexicon: &Lexicon,
        manner: Manner,
        defining: Defining,
    ) -> Option<Result<Vec<Typed<Chain>>, TypedError>> {
        super::defined::defined_chains(self.0, lexicon, manner, defining)
    }

    /// Its equations, cut at semicolons, line ends, and commas or `and` between equations.
    pub fn equations(self) -> Vec<Self> {
        let places = equations::equations(self.0).into_iter();
        places.map(|place| self.part(place)).collect()
    }

    /// Its equations that hold under conditions, each with its own, `… = -F for x' > 0; … = F for x' < 0`; none where one has
    /// no condition.
    pub fn cases(self) -> Option<Vec<Reworded>> {
        pieces::cases(self.0)
    }

    /// Whether a word leaves a choice between what it joins, `z = 0 or x = l`.
    pub fn has_alternatives(self) -> bool {
        answering::has_alternatives(self.0)
    }

    /// The equations, one a row, that an equation of matrices and vectors is.
    pub fn equations_of_matrices(self) -> Option<Reworded> {
        if !self.0.contains(['[', '(', '\\']) || !self.0.contains('=') {
            return None;
        }
        let plain = layout::without_latex(self.0);
        matrix_form::equations_of(&plain).map(Reworded::of)
    }

    /// The number that an equation bears, `(2) m x'' = …`, `2. m x'' = …` or `m x'' = … (2)`.
    pub fn number_of_equation(self) -> Option<Self> {
        equations::number_of_equation(self.0).map(Self::of)
    }

    /// Whether an equation is the state at the start, `x(0) = 0`.
    pub fn is_initial_state(self) -> bool {
        arguments::is_initial_state(self.0)
    }

    /// The pieces of a function, each on a line or after a semicolon, `…, t < 1; …, t >= 1` or `… if t < 1 otherwise …`;
    /// one piece with its times, if there is no more.
    pub fn function_pieces(self) -> Vec<FunctionPiece<'t>> {
        pieces::function_pieces(self.0)
    }

    /// The statements that semicolons and line ends part; empty ones are left out.
    pub fn lines(self) -> Vec<Self> {
        let all = Span::new(0, self.0.len());
        let lines = list::cut(self.0, all, &[';', '\n']).into_iter();
        let lines = lines.map(|line| self.part(line));
        lines.filter(|line| !line.is_empty()).collect()
    }

    /// The functions of several coordinates, parted by semicolons or line ends, else by commas, else by `and`.
    pub fn functions(self) -> Vec<Self> {
        equated::functions(self)
    }

    /// What stands before its first equals sign and after it.
    pub fn equated(self) -> Option<(Self, Self)> {
        equated::equated(self)
    }

    /// What comes after words that describe what is asked, `the natural frequency ω`, `the amplitude`; nothing where
    /// there are none, or where they say that it is another value, `half the period`.
    pub fn described(self) -> Option<Self> {
        sides::described(self.0).map(Self::of)
    }

    /// Whether words describe a rate of what is asked.
    pub fn is_of_rate(self) -> bool {
        equated::is_of_rate(self.0)
    }

    /// Without the unit in brackets after a name, `x(t) [m]`.
    #[must_use]
    pub fn without_bracketed_unit(self) -> Self {
        Self::of(equated::without_bracketed_unit(self.0))
    }

    /// Whether it is a letter, perhaps of one of these arguments, which anybody may choose for what is asked: no
    /// derivative, nor one of those for velocity and acceleration, nor its value elsewhere, `x(0)`, `x(2t)`.
    pub fn is_free_letter(self, arguments: &[String]) -> bool {
        equated::is_free_letter(self.0, arguments)
    }

    /// A function of another name for its variable, `x(τ) = … τ …`, with its own name for it.
    pub fn of_own_variable(self, variable: &Name) -> Option<Reworded> {
        reworded::of_own_variable(self.0, variable.as_str())
    }

    /// The function of numbers with units in it that it is, after each of its terms, after the whole, or in its arguments
    /// alone; only names of the lexicon stand in it.
    ///
    /// # Errors
    ///
    /// What cannot be read, that no unit stands in it, or that its terms have no common unit.
    pub fn measured(
        self,
        lexicon: &Lexicon,
        has_imaginary_unit: bool,
    ) -> Result<Typed<Measured>, TypedError> {
        measured::measured(self.0, lexicon, has_imaginary_unit)
    }

    /// Whether the imaginary unit may stand in it.
    pub fn may_be_complex(self) -> bool {
        self.0.contains(['i', 'j', 'I'])
    }

    /// The two terms of the distance that it is, `|x - 3 mm|`, and whether the second one is subtracted.
    pub fn distance(self) -> Option<([Self; 2], bool)> {
        distance::distance(self.0)
    }

    /// A count in words, or with what is counted by one of the known words, `two degrees of freedom`, in digits.
    pub fn in_digits(self, known: &Wording) -> Option<Reworded> {
        counts::in_digits(self.0, known).map(Reworded::of)
    }

    /// A value without the words before and after it that the question has: `47.7 N/m each`, `1.48 pseudo-periods`.
    pub fn without_words_of(self, asked: &Wording) -> Option<Self> {
        asked.trimmed_off(self.0).map(Self::of)
    }

    /// A number without what says that it has no unit, `0.2 -`, `2.55x`, `2.55-fold`.
    pub fn without_sign_of_ratio(self) -> Option<Self> {
        let mut ends = ["-fold", "fold", "x", "*", "-"].into_iter();
        let number = ends.find_map(|end| self.0.strip_suffix(end))?.trim_end();
        number
            .ends_with(|last: char| last.is_ascii_digit())
            .then_some(Self::of(number))
    }

    /// A value whose unit is in the plural in the singular, `5 kgs`.
    pub fn in_singular(self) -> Option<Self> {
        self.0.strip_suffix('s').map(Self::of)
    }

    /// The unit that it is, as one of them.
    pub fn one_of_unit(self) -> Reworded {
        Reworded::of(format!("1 {}", self.0))
    }

    /// The root of the formula that it is.
    pub fn root(self) -> Reworded {
        Reworded::of(format!("sqrt({})", self.0))
    }

    /// The word for what is counted, after a number: `2 periods`.
    pub fn counted(self) -> Option<Self> {
        counts::counted(self.0).map(Self::of)
    }

    /// Whether a name is that of a frequency.
    pub fn is_frequency(self) -> bool {
        naming::is_frequency(self.0)
    }

    /// Whether a name stands for something that is made of a complex number, `|Z|`, `Re(Z)`.
    pub fn is_made_of_complex(self) -> bool {
        naming::is_made_of_complex(self.0)
    }

    /// What comes after the word for a part of a complex number, `Z` of `arg Z`.
    pub fn behind_part_of_complex(self) -> Option<Self> {
        naming::behind_part_of_complex(self.0).map(Self::of)
    }

    /// Whether it is three digits, as those after a space in `5 000`.
    pub fn is_group_of_digits(self) -> bool {
        self.0.len() == 3 && self.0.bytes().all(|byte| byte.is_ascii_digit())
    }

    /// The symbols beside the equals signs of its statements: before the first one, or after the last where a value
    /// stands first.
    pub fn labels(self) -> Vec<Self> {
        naming::labels(self.0)
    }

    /// A symbol without what may stand around it: bars, its argument, its unit.
    #[must_use]
    pub fn without_frame(self) -> Self {
        Self::of(naming::without_frame(self.0))
    }

    /// What comes after the sign of a difference, `Δω`.
    pub fn behind_difference(self) -> Option<Self> {
        naming::behind_difference(self.0).map(Self::of)
    }

    /// Whether its letter, without its index, is this one.
    pub fn has_letter(self, letter: &str) -> bool {
        naming::parted(self.0).0 == letter
    }

    /// The factors that spaces and stars part.
    pub fn factors(self) -> Vec<Self> {
        let words = self.0.split([' ', '*']).map(Self::of);
        words.filter(|word| !word.is_empty()).collect()
    }

    /// The letters of a formula, each with its index: runs of what names are written with.
    pub fn letters(self) -> Vec<Self> {
        let runs = self.0.split(|char| !is_of_name(char) && char != '\\');
        let runs = runs.map(|run| run.trim_start_matches(is_digit));
        runs.filter(|run| !run.is_empty()).map(Self::of).collect()
    }

    /// What may be read in its place where it cannot be read: the answer without what is said of it after it,
    /// `…, if ω² > 2λ²`, `… by Newton's law`, or before it, `the sum: …`, and with the numbers that are said in words,
    /// `half of m R^2`. The likelier ones come first.
    pub fn read_again(self) -> impl Iterator<Item = Reworded> {
        again::read_again(self.0)
    }

    /// A value without the small uncertainty after it, `12.94 ± 0.02 N`.
    pub fn without_spread(self) -> Option<Reworded> {
        both_signs::without_spread(self.0).map(Reworded::of)
    }

    /// What is concluded last in it, `mg = μmg, so 1`.
    pub fn concluded(self) -> Option<Self> {
        let words = [' ', '\n'].into_iter();
        let words = words.flat_map(|end| CONCLUDING.iter().map(move |own| format!("{end}{own} ")));
        let ends = words.filter_map(|word| Some(self.0.rfind(&word)? + word.len()));
        Some(Self::of(&self.0[ends.max()?..]))
    }

    /// Whether it is the name of a logarithm, whose argument many write without brackets.
    pub fn is_logarithm(self) -> bool {
        matches!(self.0, "log" | "ln" | "lg")
    }

    /// Whether it is no more than a symbol: letters, digits, and what subscripts are written with.
    pub fn is_symbol(self) -> bool {
        naming::is_symbol(self.0)
    }

    /// A shape that is typed as a relation of its components, `x2/x1 = -0.5`, as a list of this width; the coordinates
    /// have these symbols.
    pub fn related_components(self, width: usize, symbols: &[String]) -> Option<Reworded> {
        let names = relation::Names::of(symbols.iter().map(String::as_str));
        relation::components_of(self.0, width, &names).map(Reworded::of)
    }

    /// A shape that is typed as several relations, `x2/x1 = 1.5, x3/x1 = 2`, or as one that is solved for no component,
    /// `m1 x1 + m2 x2 = 0`, as a list of this width.
    pub fn solved_components(self, width: usize, symbols: &[String]) -> Option<Reworded> {
        let names = relation::Names::of(symbols.iter().map(String::as_str));
        related::components_of(self.0, width, &names).map(Reworded::of)
    }

    /// A list of multiples of one letter, `(α, -α)`, as one of numbers.
    pub fn without_common_letter(self) -> Option<Reworded> {
        relation::without_common_letter(self.0).map(Reworded::of)
    }

    /// A list whose entries have these units, each after its number, `(1 m, -7.5 rad)`, without them; they may all be
    /// scaled alike.
    pub fn without_units_of_entries(self, units: &[Unit], may_be_scaled: bool) -> Option<Reworded> {
        entry_units::without(self.0, units, may_be_scaled).map(Reworded::of)
    }

    /// A ratio of components, `1 : -0.5`, as a list.
    pub fn ratio_as_list(self) -> Reworded {
        Reworded::of(relation::ratio_as_list(self.0))
    }

    /// Its words, as options are made of.
    pub fn words(self) -> Phrase {
        Phrase::of(self.0)
    }

    /// Whether it is a formula of letters, whatever they stand for, `2πf`.
    pub fn is_of_free_letters(self) -> bool {
        self.free_letters()
            .is_some_and(|own| self.formula(&own, Manner::REAL).is_ok())
    }

    /// The letters of a formula as names; nothing where its letters are words, or where it has no sign of a formula.
    pub fn free_letters(self) -> Option<Lexicon> {
        free_letters::lexicon(self.0)
    }
}

impl fmt::Display for Passage<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

impl From<Passage<'_>> for String {
    fn from(passage: Passage<'_>) -> Self {
        passage.0.to_owned()
    }
}
