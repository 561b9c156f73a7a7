//! Every remark has a sentence in every language.

use super::*;
use crate::answer::{
    At, Close, Coefficient, Decades, Example, Fault, Linearity, Misfit, Negated, Note, Scaling,
    Shape, Slip, Term, TermKind, Terms, Trouble, TwoPi, Unreadable, Why,
};
use crate::document::Block;
use crate::expr::{CheckError, Name};
use crate::math::symbol;
use crate::mechanics::Reason;
use crate::quantity::Absent;
use crate::source::Span;
use crate::unit::{Dimension, ErrorKind, Quantity, Unit};

fn unit(text: &str) -> Unit {
    Unit::parse(text).expect("a unit")
}

fn quantity(text: &str) -> Quantity {
    Quantity::parse(text).expect("a quantity")
}

fn slips() -> Vec<Slip> {
    let shapes = vec![
        Shape::OfMode { found: 2, asked: 1 },
        Shape::Reversed,
        Shape::Wrong(1),
    ];
    let mut slips = vec![
        Slip::AngleUnit(unit("deg")),
        Slip::PhaseInDegrees,
        Slip::Scale(Scaling::First),
        Slip::Scale(Scaling::Mass),
        Slip::Angle,
        Slip::OutsideInterval(Box::new([quantity("-180 deg"), quantity("180 deg")])),
        Slip::NotInteger,
        Slip::UnequalSides,
        Slip::NoValueForData,
        Slip::NoValueOnSpan,
        Slip::NoValueAtTimes,
        Slip::Zero,
        Slip::Factor,
        Slip::RunsAway,
        Slip::CommonFactor,
        Slip::OtherOrder,
        Slip::Reversed,
        Slip::Entries(vec![(1, 2)]),
        Slip::Entries(vec![(1, 2), (2, 1)]),
        Slip::CountOfIntervals,
        Slip::Shapes(shapes),
        Slip::DependentShapes,
        Slip::NoMotion,
        Slip::Unsatisfied,
        Slip::NotGeneral,
        Slip::TooFewConstants {
            found: 3,
            needed: 4,
        },
        Slip::NotFactors,
        Slip::OtherEquation,
        Slip::Tautology,
        Slip::CountedComplex { right: 1, of: 2 },
    ];
    let cycles = TwoPi::Cycles {
        typed: Box::new(unit("Hz")),
        asked: Box::new(unit("rad/s")),
    };
    let two_pi = [
        TwoPi::Formula,
        TwoPi::Frequency,
        TwoPi::Number,
        cycles,
        TwoPi::Wave,
    ];
    slips.extend(two_pi.map(Slip::TwoPi));
    let decades = [
        Decades::Prefix,
        Decades::Percent,
        Decades::Function(unit("m")),
    ];
    slips.extend(decades.map(Slip::PowerOfTen));
    let signs = [
        Negated::Whole,
        Negated::Number,
        Negated::Angle,
        Negated::Imaginary,
        Negated::Entries,
    ];
    slips.extend(signs.map(Slip::Sign));
    let near = [
        Close::Rounding,
        Close::RoundedFormula,
        Close::Function,
        Close::Ends,
    ];
    slips.extend(near.map(Slip::Near));
    for (found, surplus, is_order_wrong) in [
        (1, None, false),
        (2, None, true),
        (1, None, true),
        (1, Some(3), false),
    ] {
        slips.push(Slip::Counted {
            right: found,
            of: 2,
            surplus,
            is_order_wrong,
        });
    }
    for (typed, found) in [(2, 1), (3, 2), (1, 1)] {
        slips.push(Slip::Fewer {
            typed,
            found,
            needed: 3,
        });
    }
    slips.extend(terms().into_iter().map(Slip::Terms));
    slips
}

fn terms() -> Vec<Terms> {
    let damper = || vec![("c".to_owned(), Some("damping coefficient".to_owned()))];
    let mass = || vec![("m".to_owned(), None), ("k".to_owned(), None)];
    let data = |missed, surplus| Fault::Coefficient(Coefficient::Data { missed, surplus });
    let faults = [
        Fault::Missing,
        Fault::Surplus,
        Fault::Sign,
        Fault::Coefficient(Coefficient::Number),
        Fault::Coefficient(Coefficient::Other),
        data(damper(), Vec::new()),
        data(Vec::new(), mass()),
        data(mass(), damper()),
    ];
    let kinds = [
        TermKind::Exciting,
        TermKind::Inertia,
        TermKind::Friction,
        TermKind::Damping,
        TermKind::Stiffness,
        TermKind::Other,
    ];
    let term = |kind| Term {
        kind,
        unknown: (kind != TermKind::Exciting).then(|| "x′".to_owned()),
        without: vec!["x".to_owned(), "y".to_owned()],
    };
    let of = |equation, faults: &[(Term, Fault)], linearity| Terms {
        equation,
        faults: faults.to_vec(),
        linearity,
    };
    let pairs = faults.iter().cloned().zip(kinds.into_iter().cycle());
    let pairs: Vec<(Term, Fault)> = pairs.map(|(fault, kind)| (term(kind), fault)).collect();
    vec![
        of(Some(2), &pairs, None),
        of(None, &[], Some(Linearity::Due)),
        of(None, &[], Some(Linearity::Surplus)),
        of(None, &[], Some(Linearity::WrongForLarge)),
        of(None, &[], Some(Linearity::DueBesides)),
        of(None, &pairs[..1], Some(Linearity::DueBesides)),
    ]
}

fn misfits() -> Vec<Misfit> {
    let units = [
        ("kg", "m"),
        ("N m/rad", "s"),
        ("N m", "J"),
        ("m/s", "N m^4"),
        ("m", "1"),
    ];
    let units = units.map(|(typed, asked)| Misfit::Unit {
        typed: unit(typed),
        asked: if asked == "1" { Unit::ONE } else { unit(asked) },
    });
    let comes = |entry, found, asked, own: Option<&str>| Misfit::Comes {
        entry,
        found,
        unit: own.map(unit),
        asked,
    };
    let unknown = CheckError::UnknownName {
        name: Name::new("q"),
        nearest: None,
        span: Span::NONE,
    };
    let mut misfits = vec![
        Misfit::UnitOf(unit("ohm")),
        Misfit::Count,
        comes(None, Dimension::PURE, Some(Dimension::TIME), None),
        comes(Some((1, 2)), Dimension::TIME, Some(Dimension::PURE), None),
        comes(None, Dimension::TIME, None, Some("N")),
        comes(None, Dimension::TIME, None, None),
        Misfit::Step {
            entry: None,
            error: None,
        },
        Misfit::Step {
            entry: Some((1, 1)),
            error: Some(unknown),
        },
        Misfit::BoundUnit {
            symbol: "μ".to_owned(),
            typed: unit("m"),
            asked: Unit::ONE,
        },
        Misfit::BoundUnit {
            symbol: "x".to_owned(),
            typed: unit("s"),
            asked: unit("m"),
        },
        Misfit::Bound {
            typed: "k".to_owned(),
            read: "k".to_owned(),
            symbol: "x".to_owned(),
        },
    ];
    misfits.extend(units);
    misfits
}

fn notes() -> Vec<Note> {
    let figures = |typed| Note::Figures { asked: 3, typed };
    vec![
        Note::TakenIn(unit("m")),
        figures(None),
        figures(Some(("5.0".to_owned(), 2))),
        Note::JouleForMoment(unit("N m")),
        Note::RightBut(Misfit::Count),
        Note::LettersCarryUnits("rad/s".to_owned()),
        Note::RightTogether,
        Note::OthersBelongElsewhere,
        Note::OtherForm,
        Note::WithValues,
        Note::ByTextbooks,
        Note::RoundedNumbers,
        Note::ConstantsToSpare {
            needed: 4,
            found: 5,
        },
    ]
}

fn troubles() -> Vec<Trouble> {
    let letters = || vec!["k".to_owned(), "m".to_owned()];
    let unknown = |near: Option<&str>, letters| Trouble::Unknown {
        near: near.map(str::to_owned),
        letters,
    };
    vec![
        Trouble::Missing,
        Trouble::TooLong,
        Trouble::TooDeep,
        unknown(None, Vec::new()),
        unknown(None, letters()),
        unknown(Some("omega"), Vec::new()),
        Trouble::NotAllowed(Vec::new()),
        Trouble::NotAllowed(letters()),
        Trouble::Unit,
        Trouble::Sign,
        Trouble::Number,
        Trouble::Bracket,
        Trouble::NumberAfter,
        Trouble::List,
        Trouble::Exponent,
        Trouble::Logarithm,
        Trouble::Arguments {
            name: "sin",
            least: 1,
            most: 1,
        },
        Trouble::Arguments {
            name: "atan2",
            least: 2,
            most: 2,
        },
        Trouble::TwoValues,
        Trouble::Unsolved,
        Trouble::LeftOver,
        Trouble::NoRelation,
        Trouble::UnitOfEntry,
        Trouble::UnitOrLetter,
        Trouble::Order,
        Trouble::Determinant,
        Trouble::NamedMatrices,
        Trouble::Ragged,
    ]
}

#[expect(clippy::too_many_lines, reason = "a list of them all")]
fn reasons() -> Vec<Why> {
    let text = || "5".to_owned();
    let turn = Quantity::parse("360 °").expect("a quantity");
    let absent = Absent::Function {
        label: "key".into(),
        of: Vec::new(),
    };
    let unread = crate::unit::Error {
        kind: ErrorKind::NumberMissing,
        span: 0..1,
    };
    let mut all = vec![
        Why::TooLong,
        Why::LongerThan(4000),
        Why::NoKey(absent),
        Why::Dollar,
        Why::Quantity(unread),
        Why::Dimension(None),
        Why::Letters,
        Why::UnitNotLast,
        Why::Counted(text()),
        Why::CountedUnit,
        Why::NumberAlone,
        Why::AngleInUnit(Unit::radian()),
        Why::OtherQuantity,
        Why::LabelsInOtherOrder,
        Why::LabelTwice,
        Why::EmptyPlace,
        Why::TwoSigns(text()),
        Why::NoValue(text()),
        Why::ExponentMissing(text()),
        Why::RangeOrDifference(text()),
        Why::MixedDegrees,
        Why::TwoUnits,
        Why::CommaOfThree {
            typed: "1,250".to_owned(),
            decimal: "1.250".to_owned(),
            thousands: "1250".to_owned(),
        },
        Why::PointOrProduct(text()),
        Why::BracketAfterNumber,
        Why::Inequality,
        Why::UnitOfZero,
        Why::UnequalSides(text(), text()),
        Why::UnclearSide,
        Why::OutsideOfSpan,
        Why::Withdrawn,
        Why::TooManyTurns { times: 100, turn },
        Why::Gram,
        Why::MostNumbers(100),
        Why::TightComma,
        Why::AngleWithoutUnit(text()),
        Why::AngleUnit,
        Why::SeveralComplex,
        Why::NoOption('d'),
        Why::OneOption,
        Why::Ranking(3),
        Why::JoinInequalities,
        Why::NoneSatisfies(text()),
        Why::LongChain,
        Why::SameWay,
        Why::NoInterval,
        Why::BeforeInterval(text()),
        Why::IntervalBracket,
        Why::NoUnit,
        Why::TwoEnds,
        Why::SolveForDistance(text()),
        Why::SolveFor(text()),
        Why::NotInInequality(text()),
        Why::BoundsOrder,
        Why::BoundsAsFormulas,
        Why::BoundsAsNumbers,
        Why::BoundValue,
        Why::FormulaNotNumber,
        Why::Incomparable,
        Why::DigitsLost,
        Why::TwoReadings(text(), text()),
        Why::UnitBehindLetters,
        Why::UnitComesOut(None),
        Why::UnitComesOut(Some(unit("m"))),
        Why::NoEquation,
        Why::NotInequality,
        Why::EquationNumber,
        Why::InitialState,
        Why::IncomparableEquation,
        Why::RoundedNumbers,
        Why::Figures {
            asked: 4,
            number: "1.99".to_owned(),
            has: 3,
        },
        Why::ValuesForLetters,
        Why::EntriesAsNumbers,
        Why::IncomparableEntries,
        Why::UnitBehindMatrix,
        Why::Shape {
            found: (1, 2),
            asked: (2, 2),
        },
        Why::NumbersNotFormulas,
        Why::FormulasNotNumbers,
        Why::EntryValue,
        Why::UnitOfEntries(unit("m")),
        Why::UnitOfComponents,
        Why::UnitOfShape(unit("m")),
        Why::ComponentValue,
        Why::Components { found: 1, asked: 2 },
        Why::ShapesOf {
            found: 4,
            rows: 2,
            shapes: 2,
            width: 3,
        },
        Why::UnequalFunctions(text()),
        Why::UnitOrQuantity,
        Why::AngleAdded,
        Why::UnitOfTerms,
        Why::UnitOfArgument,
        Why::UnitOfFunction(unit("m")),
        Why::OneFunction("x(t)".to_owned()),
        Why::OtherFunction("x(t)".to_owned()),
        Why::UnclearFunction("x(t)".to_owned()),
        Why::Functions(vec!["x1".to_owned(), "x2".to_owned()]),
        Why::TwoFunctions("x1".to_owned()),
        Why::FunctionMissing,
        Why::Undifferentiable,
        Why::TooManyConstants {
            most: 16,
            needed: 4,
        },
    ];
    all.extend(troubles().into_iter().map(Why::Formula));
    all
}

fn remarks() -> Vec<Remark> {
    let mut remarks = vec![
        Remark::Followed(Vec::new()),
        Remark::Followed(["x", "y", "z"].map(symbol).to_vec()),
    ];
    remarks.extend(slips().into_iter().map(Remark::from));
    remarks.extend(misfits().into_iter().map(Remark::from));
    remarks.extend(notes().into_iter().map(Remark::from));
    for why in reasons() {
        remarks.push(Remark::unreadable(why.clone()));
        remarks.push(Remark::Unreadable(Unreadable::at("k/", why.clone())));
        let at = Some(At::Behind("k/".to_owned()));
        remarks.push(Remark::Unreadable(Unreadable {
            at,
            why: Box::new(why),
            example: None,
        }));
    }
    for example in [
        Example::Number,
        Example::UnitLast,
        Example::Complex,
        Example::Interval,
        Example::OneValue,
    ] {
        remarks.push(Remark::Unreadable(Unreadable::of(Why::Form).like(example)));
    }
    remarks
}

#[test]
fn each_remark_is_a_sentence_in_each_language() {
    for language in Language::ALL {
        for remark in remarks() {
            let said = language.say(&remark).map(|said| said.plain(&Vec::new()));
            let said = said.unwrap_or_default();
            let said = said.trim();
            let begins = said.starts_with(|char: char| !char.is_lowercase());
            let is_quoted = said.starts_with(|char: char| char.is_ascii());
            assert!(begins || is_quoted, "{remark:?}: {said}");
            assert!(said.ends_with(['.', '?']), "{remark:?}: {said}");
            let is_clean = !said.contains("  ") && !said.contains(['{', '}']) && said.len() > 8;
            assert!(is_clean, "{remark:?}: {said}");
        }
        for verdict in [
            Verdict::Right,
            Verdict::Partial,
            Verdict::Wrong,
            Verdict::Unreadable,
            Verdict::Missing,
        ] {
            assert!(
                !language
                    .verdict(verdict)
                    .plain(&Vec::new())
                    .trim()
                    .is_empty()
            );
        }
    }
}

#[test]
fn what_a_person_did_is_said_in_each_language() {
    let row = |given: Option<&str>| ByHand::Row {
        given: given.map(str::to_owned),
        most: "2".to_owned(),
    };
    let sentences = [
        ByHand::Open,
        ByHand::Marked,
        ByHand::ReadAs,
        ByHand::Unclear,
        ByHand::Accepted,
        ByHand::Shared,
        ByHand::FullMarks,
        ByHand::Rescaled,
        ByHand::LeftOut,
        ByHand::Charged {
            points: "0.5".to_owned(),
            is_one: false,
        },
        row(None),
        row(Some("1")),
    ];
    for what in sentences {
        let said = Language::ALL.iter().map(|language| language.by_hand(&what));
        let said: std::collections::BTreeSet<String> = said.collect();
        assert_eq!(said.len(), Language::ALL.len(), "{what:?}");
    }
}

#[test]
fn derivations_are_worded_in_each_language() {
    let name = || Name::new("x");
    let reasons = [
        Reason::Kinematics,
        Reason::Terms(name()),
        Reason::Lagrange(name()),
        Reason::Linearized,
        Reason::Energy,
        Reason::Power,
        Reason::Balance,
        Reason::Divided(name()),
        Reason::Body(name()),
        Reason::Elimination(name(), vec![name(), name(), name()]),
        Reason::Characteristic,
        Reason::Row(0),
        Reason::Row(1),
        Reason::AtRest,
        Reason::Letters,
        Reason::InMotion,
    ];
    let mut said = std::collections::BTreeSet::new();
    for reason in &reasons {
        for language in Language::ALL {
            let words = language.step(reason, &crate::expr::PlainNotation);
            let text = Document::of(vec![Block::Paragraph(words)], Vec::new());
            let text = text.plain(&Vec::new());
            assert!(text.trim_end().ends_with(':'), "{text}");
            assert!(said.insert(text.clone()), "{reason:?}: {text}");
        }
    }
    let shown = Phrase::ModeShown {
        number: 2,
        shape: &[(Math::letter('x'), "1".to_owned())],
    };
    for phrase in [
        Phrase::TurningPoints,
        Phrase::AndSoOnUntil,
        Phrase::Nonexistent,
        Phrase::Moving,
        shown,
    ] {
        for language in Language::ALL {
            let text = language.phrase(&phrase);
            assert!(said.insert(text.clone()), "{phrase:?}: {text}");
        }
    }
}

#[test]
fn what_an_item_words_is_left_to_it() {
    let text = Document::sentence("Look again.");
    for language in Language::ALL {
        assert!(language.say(&Remark::Mistake(0)).is_none());
        assert_eq!(
            language.say(&Remark::Option(text.clone())),
            Some(text.clone())
        );
    }
}
