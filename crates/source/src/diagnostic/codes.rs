//! The list of codes and their explanations.

use std::fmt;

/// The name under which a kind of finding is explained, such as `bank::unknown-key`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Code(&'static str);

/// A code with its page.
#[derive(Clone, Copy, Debug)]
pub struct CodePage {
    /// The code that findings bear.
    pub code: Code,
    /// What it is about, in one line.
    pub title: &'static str,
    /// What it means and how to mend it, in Markdown.
    pub text: &'static str,
}

/// Declares each code once: its constant, its name, its title and its page.
macro_rules! codes {
    ($($constant:ident $name:literal $title:literal $text:literal)*) => {
        impl Code {
            $(#[doc = $title] pub const $constant: Self = Self($name);)*
        }

        /// All codes with their pages, in the order of the book.
        pub const PAGES: &[CodePage] = &[$(CodePage { code: Code::$constant, title: $title, text: $text }),*];
    };
}

codes! {
    TOML_SYNTAX "bank::syntax" "The file is not valid TOML."
        "The reader of TOML stopped at the marked place.\nTypical causes: a quote that is not closed, a backslash in double quotes (write `\\\\` or use single quotes), a table header that is written twice."
    MISSING_KEY "bank::missing-key" "A key that has to be there is not, or there is no word in its text."
        "The named table needs this key.\nThe reference of the item file lists the keys of each table and which of them are required."
    UNKNOWN_KEY "bank::unknown-key" "A key that nothing reads."
        "Keys are checked so that a misspelt one is not silently without effect.\nThe help names the nearest key that the table may have."
    WRONG_KIND "bank::wrong-kind" "A value of another kind than its key asks for."
        "For instance a number where a text is due, or a text where an array of tables is due."
    TEXT_MARKUP "text::markup" "A text has something in it that no text may have."
        "Texts are Markdown with math between dollar signs and placeholders, and nothing else: no HTML, no images, links to pages alone, no control characters, bounded in length and nesting."
    TEXT_PLACEHOLDER "text::placeholder" "A placeholder that cannot be read."
        "A placeholder is `<< name >>` or `<< name.form >>`, where the form is one of `given`, `symbol`, `name`, `number`, `unit`, `formula`, `substituted`, `equation`, `worked`.\nA figure, a plot and a derivation stand in paragraphs of their own.\nThe sign `<<` itself is written `\\<<`, in a formula `\\ll`."
    TEXT_MATH "text::math" "A formula that cannot be read."
        "Formulas are LaTeX as `amsmath` has it, as far as it concerns formulas: letters, signs, fractions, roots, scripts, accents, delimiters, matrices, cases, aligned lines, words.\nCommands that define, colour or draw are not read."
    TEXT_DOLLAR "text::dollar" "A dollar sign that is printed as it stands."
        "A formula stands between dollar signs without blanks inside, `$x$`, or between double ones without an empty line, `$$x$$`.\nIn the cell of a table a bar ends the cell even in a formula: write `\\lvert x\\rvert`.\nInside `\\text{…}` there is no math.\nThe sign itself is written `\\$`."
    FORMULA_SYNTAX "formula::syntax" "A formula that cannot be read."
        "Products are written with `*`, powers with `^`, comparisons with `==`, decimals with a point.\nA number may bear a unit in brackets right after it, `0.1[m]`.\nA case, `if … then … else …`, needs parentheses inside another formula."
    FORMULA_UNKNOWN_NAME "formula::unknown-name" "A name that stands for nothing here."
        "A formula may use parameters, quantities, `t`, the coordinates of the model and what the model offers as `model.…`.\nThe help gives the nearest known name."
    FORMULA_DIMENSION "formula::dimension" "Dimensions that do not fit."
        "Both sides of a sum, a comparison, a case and an equation have one dimension.\nThe arguments of `exp`, `ln` and the trigonometric functions are pure numbers; radians are pure.\nThe exponent of a quantity with a dimension is a constant.\nZero has every dimension; any other number may bear a unit, `0.1[m]`."
    FORMULA_FORM "formula::form" "A number, condition, vector or matrix where another is due."
        "Conditions stand after `if` and between `and`, `or`, `not`; everything else is a number, a vector or a matrix.\nSums need equal shapes, products of matrices conformable ones; indices count from 1.\nComplex numbers cannot be compared or rounded."
    FORMULA_PROGRAM "formula::program" "A formula that cannot be computed."
        "A derivative is asked for that cannot be formed: rounding functions have none."
    BANK_FORMAT "bank::format" "The bank was written for another version of the format."
        "`format` in `bank.toml` says for which version of the bank format its files were written.\nThe changelog tells what changed between the versions and how to migrate."
    FOLDER "bank::folder" "The folder of a bank lacks something."
        "A bank is a folder with `bank.toml`, and in each chapter's folder `_chapter.toml` and the items, named in small letters, digits and hyphens."
    QUANTITY "bank::quantity" "A number, unit or range that cannot be read."
        "A quantity is a decimal and a unit, `12.5 cm`; a range is `0.5 .. 5 kg`.\nA slash divides by the one factor after it; two slashes, or a product after a slash, are refused because people read them differently."
    PARAMETER "bank::parameter" "A parameter that cannot be drawn, or a value that it cannot have."
        "A parameter with a `range` has a `step` in the same unit; the values lo, lo + step, … up to hi are drawn.\nThe sign of the range is the domain of the parameter: a value outside it is refused."
    NAME "bank::name" "A word that cannot be a name."
        "A name begins with a letter and has letters, digits and underscores.\n`t`, `i`, `pi`, `e`, `inf`, `model`, `models` and the functions belong to the formula language."
    NAME_TAKEN "bank::name-taken" "Two things of an item have one name."
        "Parameters, symbols, quantities and parts share one list of names, so that a formula is never ambiguous.\nA part may bear the name of a quantity only if that quantity is its key."
    DIMENSION "bank::dimension" "Dimensions that do not agree."
        "Every formula is checked when the item is loaded: both sides of a sum or comparison agree, arguments of functions are pure numbers, and the formula of a quantity has the dimension of its declared unit.\nThe radian has dimension 1, so `x = r*theta` is in order."
    CYCLE "bank::cycle" "A quantity that depends on itself."
        "Quantities may use each other, but not in a circle, and not in chains of more than 200."
    SIZE "bank::size" "Something that is larger than its bound."
        "Bounds keep an unchecked file from taking all time and memory; what a teacher writes stays far below them.\nA file of a bank has at most 262,144 bytes, a table or array 500 entries, an item 100 parts, a title 300 letters.\nReading an item takes at most 100 million steps of work, working it out for one set of data 20 million, drawing one plot as many; a step is about one operation on two numbers."
    FORMULA_SIZE "bank::formula-size" "A formula that grows too large."
        "A formula has at most 10,000 parts and a depth of 200, also when the functions of time that it uses are substituted."
    CONDITION "bank::condition" "A number where a condition is due."
        "Constraints, `when` and options that are right by formula need a comparison, such as `zeta < 1`."
    UNKNOWN_PLACEHOLDER "bank::unknown-placeholder" "A text shows something that the item does not have."
        "A placeholder names a parameter, a quantity with a unit, something of a model, a plot or the figure.\nA datum has no formula; an abbreviation (a quantity without unit) has no value to print."
    TOPIC "bank::topic" "A topic that is not in the vocabulary of the bank."
        "The words that items may have as topics stand in `[topics]` of `bank.toml`, each with what it means."
    ALLOW "bank::allow" "Something that cannot be lifted."
        "`allow` lifts guards and lints by name: `repeated-frequencies`, `near-critical`, `near-resonance`, `large-angle`, `few-instances`, `single-route`."
    ANSWER_KIND "bank::answer-kind" "A kind of answer that does not exist."
        "The reference of the item file lists the kinds of answers with their keys."
    PART "bank::part" "A part without identity, or with the identity, weight or space of none."
        "A part is known by its `id`, or by its key if that is a name; identities are unique in an item. `points` is a positive number, `space` a height that fits on a page."
    MISTAKE "bank::mistake" "A named mistake that says nothing, or too much."
        "A mistake has either `answer`, the value that the slip gives, or `with`, the quantities that the slip replaces; its `credit` lies from 0 to 1."
    CHECK "bank::check" "A known result of something that the item does not have."
        "`given` names parameters, `expect` names quantities and parts."
    CHECK_EXPECTED "check::expected" "A known result that the item does not give."
        "`vibank check` solves the item for the data of each `[[check]]`.\nA number has to agree to half a unit of its last written digit, so write all digits that the source has; another response has to be right.\nA function has one value for each time in `at`."
    CHECK_DRAWS "check::draws" "Constraints that no draw meets."
        "Data are drawn until all constraints hold, up to 1000 times.\nHere they never did, so that no sheet could have this item; the message names the constraints that were broken, the most frequent first."
    CHECK_ROUTES "check::routes" "Two routes to a quantity that do not agree."
        "A quantity with `verify` is computed by both routes for many draws.\nThey have to agree but for rounding; functions are compared at many times, shapes up to their sign."
    CHECK_MISTAKE_RIGHT "check::mistake-right" "A named mistake that is marked right."
        "`vibank check` types every named mistake as a student would, for each draw, through the reader and the marker.\nHere one came out right.\nWhere the part states a tolerance, it is too wide: state a narrower one, or none.\nElse mend the mistake, or keep the data at which it equals the key away by a constraint."
    CHECK_MISTAKE_UNMET "check::mistake-unmet" "A named mistake whose feedback nobody meets."
        "Typed as a student would, the mistake never led to its own feedback: another mistake or a built-in remark comes first, its `when` never holds, or it cannot be typed.\nPut it before the one that hides it, mend its formula, or drop it."
    CHECK_MISTAKES_ALIKE "check::mistakes-alike" "Two named mistakes that give the same answer."
        "In more than half of the draws the second one is answered with the feedback of the first.\nA student gets a diagnosis that may be wrong: join the two feedbacks into one, or choose data that keep them apart."
    CHECK_METHOD_RIGHT "check::method-right" "A wrong method that is marked right."
        "Besides the named mistakes `vibank check` types what standard wrong methods give: a term or factor dropped, a datum left out, a unit or degrees mistaken, a mass for a weight, a diameter for a radius.\nThey are transformations of the item's own formulas; `--report` says how many applied to each part.\nData at which one lies within a derived tolerance are not handed out; a tolerance that the part states may not contain one."
    CHECK_FEW_METHODS "check::few-methods" "A part that few wrong methods lead to."
        "A part that asks for a number, a function or an equation has at least three standard wrong methods or named mistakes that give another answer than the key.\nA part that asks for less may be too small to be one; name the mistakes that are made in it."
    CHECK_HONEST_WORK "check::honest-work" "Honest work that is marked wrong."
        "For each draw every quantity on the way is rounded to the figures that are asked for, and so is the answer.\nIt has to be right in 999 of 1000 draws: widen the tolerance, drop it so that it is derived, or ask for more figures with `ask_digits`."
    CHECK_REFUSED "check::refused" "Data that are drawn again too often."
        "A constraint that leaves under 1 % of the draws, or constraints and wrong methods that refuse more than half of them, make variants alike and sheets slow.\nThe message names what costs most: choose ranges in which it seldom matters."
    CHECK_DISCLOSED "check::disclosed" "A part whose answer is printed in the statement or a later question."
        "The student reads there what an earlier part asks for.\nAsk in letters, or give the number under another name."
    CHECK_VARIANTS_DIFFER "check::variants-differ" "Variants that have other parts or points."
        "A `when` of a part drops it for some data, so that students of one class have exams of different length.\nNarrow the ranges, or ask what exists for all data."
    CHECK_MANY_QUESTIONS "check::many-questions" "An item with more than eight questions."
        "Many questions of a point each weigh a trifle as much as an equation of motion, and nobody has time for them.\nGroup small ones as `[[part.blank]]` tables of one part, which count as one question, or make two items."
    CHECK_SMALL_COMPONENT "check::small-component" "A mode shape with a component that is hardly there."
        "A component below 5 % of the largest one is lost in rounding, and nobody sees it in a drawing.\nKeep such data away by a constraint."
    CHECK_ANSWERS_COINCIDE "check::answers-coincide" "Two parts with the same answer in most variants."
        "In at least half of the draws the two keys agree in the figures that are asked for, so that a wrong idea of one gives the other.\nChoose ranges in which they differ, such as more damping for damped and undamped frequencies."
    CHECK_SAME_CHOICE "check::same-choice" "A choice that has the same answer in every variant."
        "What is right follows from the data by its formula, but no draw makes another option right: one student can tell it to all.\nWiden the ranges so that each outcome occurs."
    CHECK_OPTION_FORM "check::option-form" "Options that give the right one away by their form."
        "The right option is the only one with a formula, or more than twice as long as any other.\nWrite all options in one form."
    CHECK_UNUSED_DATUM "check::unused-datum" "A datum that no part uses."
        "It is printed among the data, but no key depends on it.\nDrop it, or let a part ask for what it decides."
    CHECK_NO_SECOND_ROUTE "check::no-second-route" "A number that is asked without a second route."
        "A quantity with `verify` is computed by an independent formula over all draws and compared.\nGive one, such as what the model offers."
    CHECK_NO_HINT "check::no-hint" "A part without a hint."
        "A self-check page and `vibank practice` show hints one after the other: first the principle, then the first step."
    CHECK_NO_SOLUTION "check::no-solution" "A part without a worked solution."
        "The solutions of a sheet show for this part the key alone."
    CHECK_STILL_FIGURE "check::still-figure" "A figure that stands still although its item has a model."
        "A self-check page lets a system move once a solution is seen, and draws its modes on the figure, by `[figure.motion]`.\nWhat cannot be seen to move, as the charge of a circuit, is excepted by `[[allow]]` with its reason."
    CHECK_NEEDLESS_EXCEPTION "check::needless-exception" "An exception from a rule that the item keeps."
        "`[[allow]]` excepts the item from a rule of `check` that finds nothing in it.\nDrop it: it would hide the next finding. Rules that go by draws are not asked: what few draws do not show, more of them may."
    KEY "bank::key" "A key of a form that its kind does not take."
        "A `numeric` part takes a real number or a list of them, an `integer` part a pure number."
    TOLERANCE "bank::tolerance" "A tolerance that cannot be read."
        "A tolerance is `2 %`, `0.05 rad`, `3 sf`, `1 % of omega2`, or several of these joined by commas, of which the widest counts."
    OPTIONS "bank::options" "Options of a choice that cannot be chosen from."
        "A choice has from 2 to 26 options with identities of their own, and at least one that can be right."
    PLOT "bank::plot" "A plot that cannot be drawn."
        "A plot of `curves` or of a `phase-plane` has a variable `x` with a range of two formulas, and from 1 to 12 curves, whose formulas are real numbers and functions of the variable alone.\nAll curves have the dimension of the unit of `y`; a mark has the dimensions of both axes.\nA `band` has two edges, `[-delta, delta]`.\nA plot of `mode-shapes` draws those of a model."
    FIGURE_ELEMENT "figure::element" "An element of a figure that does not exist."
        "An element is an inline table whose first key is its kind and holds its place, `{ spring = [\"A\", \"B\"], label = \"k\" }`.\nThe page of figure elements shows all kinds with their keys."
    FIGURE_PLACE "figure::place" "A place in a figure that does not exist."
        "A point is a name from `points`, a pair `[x, y]` in units of 10 mm or a formula for one, or a side of a body that is placed at a named point, `B.left`.\nA cord goes round a pulley at a named point as `\"P cw\"` or `\"P ccw\"`.\nPlaces and sizes are pure numbers: divide a length by another, and keep it within bounds by `clamp`."
    FIGURE_WORD "figure::word" "A word that a key of a figure does not take."
        "`labels` is `symbol`, `value` or `both`; `at` of a label is `above`, `below`, `left` or `right`; `style` is `solid`, `dashed`, `dotted` or `faint`; the sides of a body are `left`, `right`, `top` and `bottom`."
    FIGURE_FREE "figure::free" "A free-body diagram that does not show the forces of the model."
        "`[figure.free.<body>]` takes out a body of `[model.bodies]`: the elements with its id, or those in `keep`.\nEach of its forces has an arrow: a link with the id of the force, or named in `links`; a force or moment of the figure with this id; or a row of `arrows` (`normal`, `friction`, `reaction`, `weight`).\nAn arrow does the work that the force does in the model, and what is not a force of the model does no work."
    FIGURE_MOTION "figure::motion" "A motion of a figure in which nothing moves."
        "`[figure.motion]` moves named points of the figure by the coordinates of `[model]` or by its kinematic names: a shift to the right and up is a length, `B = [\"x\", 0]`, a turn is an angle, anticlockwise, `O = { turn = \"theta\" }`.\nDisplacements are counted from rest, and their scale is chosen so that they are seen."
    MODEL_COORDINATE "model::coordinate" "A model moves something that it does not declare."
        "What bears a prime is a coordinate or a name in `kinematics`.\n`forces`, `friction`, `initial` and `equilibrium` are keyed by coordinates.\nA name stands for one thing, and kinematic names do not need each other in a circle."
    MODEL_DIMENSION "model::dimension" "A term of an energy or force has the wrong dimension."
        "`kinetic` and `potential` are energies, `dissipation` is a power, a generalized force is an energy per coordinate: N along a length, N m along an angle.\nEach term is checked by itself."
    MODEL_KINETIC "model::kinetic" "A kinetic energy that gives no equation of motion."
        "The kinetic energy is of the second degree in the velocities, and the velocity of every coordinate occurs squared.\nWhat is prescribed may add terms of lower degree.\nAccelerations stand in no energy."
    MODEL_EQUILIBRIUM "model::equilibrium" "A model that rests nowhere, or not where it is said to."
        "A model is linearized about an equilibrium.\nA potential energy without lower bound is most often a slipped sign; a constant force needs something that balances it."
    MODEL_FORMULA "model::formula" "A formula of a model that cannot be differentiated."
        "Energies are differentiated by coordinates and velocities.\nRounding functions have no derivative, and formulas may not grow beyond all bounds."
    MODEL_QUANTITY "model::quantity" "A path that leads to no quantity of a model."
        "A model offers its quantities as `model.…` or `models.<name>.…`; with several coordinates those of one coordinate take its name last, `model.motion.x1`.\nThe reference of the item file lists them."
    BLUEPRINT "blueprint::value" "A blueprint says something that cannot be done."
        "A blueprint names a title, a seed (or a secret file), the number of variants or a class list, and at least one question with an item or a filter.\nThe reference of the blueprint lists all keys with their values and defaults."
    MARKS "marks::value" "Rules for marks or a decision about a run that cannot be carried out."
        "`[marks]` says what becomes of the points of a sheet, in a blueprint or in `decisions.toml`; `[[decision]]` says there what was decided about a part after the sheets were handed out.\nThe page on marking lists their keys."
}

impl Code {
    /// Its name, as in `vibank explain NAME`.
    pub fn name(self) -> &'static str {
        self.0
    }

    /// What `vibank explain` and the book say about it.
    pub fn page(self) -> &'static CodePage {
        PAGES
            .iter()
            .find(|page| page.code == self)
            .expect("the list declares code and page together")
    }

    /// The code of this name.
    pub fn of_name(name: &str) -> Option<Self> {
        PAGES
            .iter()
            .map(|page| page.code)
            .find(|code| code.0 == name)
    }
}

impl fmt::Display for Code {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.0)
    }
}
