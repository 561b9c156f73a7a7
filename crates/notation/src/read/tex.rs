//! LaTeX math into trees.

use pulldown_latex::event::{
    Content, DelimiterType, Dimension, DimensionUnit, EnvironmentFlow, Event, Font, Grouping,
    ScriptPosition, ScriptType, StateChange, Style as TexStyle, Visual,
};
use pulldown_latex::{Parser, Storage};

use super::LatexError;
use super::check::Checked;
use super::holes::{LITERAL, hole};
use super::tidy::tidy;
use crate::{Accent, Atom, Class, Math, Sign, Size, Style, TableKind};
use vibank_source::Span;

/// Reads the LaTeX source of a formula, without dollar signs.
///
/// Read is what `amsmath` has for formulas: letters, signs, numbers (a decimal comma as `2{,}5`),
/// fractions, roots, scripts, primes, accents, `\left…\right`, matrices, `cases`, `aligned`,
/// `\text`, `\operatorname`, the fonts `\mathrm \mathbf \boldsymbol \mathcal \mathbb`, and
/// `\qty{2}{kg}`. Length and nesting are bounded.
///
/// # Errors
///
/// The first thing that is wrong, with its place in the source.
///
/// # Examples
///
/// ```
/// use vibank_notation::read_latex;
///
/// let math = read_latex(r"\mu_\mathrm{crit}").unwrap();
/// assert_eq!(math.plain(), "μ_crit");
/// assert!(read_latex(r"\sqr{k/m}").is_err());
/// ```
pub fn read_latex(latex: &str) -> Result<Math, LatexError> {
    read_all(latex).map_err(|mut errors| errors.swap_remove(0))
}

/// The tree of a formula, like [`read_latex`].
///
/// # Errors
///
/// All that is wrong with it, at least one thing.
pub fn read_all(latex: &str) -> Result<Math, Vec<LatexError>> {
    let checked = Checked::of(latex);
    if !checked.errors.is_empty() {
        return Err(checked.errors);
    }
    let whole = Span::new(0, latex.len());
    let malformed = |reason: String| {
        vec![LatexError::Malformed {
            reason,
            span: whole,
        }]
    };
    let storage = Storage::new();
    let events: Vec<Event> = Parser::new(&checked.source, &storage)
        .collect::<Result<_, _>>()
        .map_err(|error| malformed(reason(&error)))?;
    let mut fold = Fold {
        events: &events,
        at: 0,
        font: None,
    };
    let math = fold
        .row(Atom::Edge)
        .ok_or_else(|| malformed("a piece of a formula is missing".to_owned()))?;
    if fold.at < events.len() {
        return Err(malformed("the groups do not match".to_owned()));
    }
    if depth(&math) > DEPTH {
        return Err(vec![LatexError::TooDeep { span: whole }]);
    }
    Ok(math)
}

/// How deep the JSON of a tree may be, so that every reader of it takes a compiled text.
const DEPTH: usize = 80;

/// How deep the JSON of a tree is.
fn depth(math: &Math) -> usize {
    let below = match math {
        Math::Row(pieces) => return 2 + pieces.iter().map(depth).max().unwrap_or(0),
        Math::Table { rows, .. } => {
            return 4 + rows.iter().flatten().map(depth).max().unwrap_or(0);
        }
        Math::Fraction {
            numerator,
            denominator,
            ..
        } => deepest(&[Some(numerator), Some(denominator)]),
        Math::Root { radicand, degree } => deepest(&[Some(radicand), degree.as_deref()]),
        Math::Script { base, sub, sup } => deepest(&[Some(base), sub.as_deref(), sup.as_deref()]),
        Math::Stack { base, under, over } => {
            deepest(&[Some(base), under.as_deref(), over.as_deref()])
        }
        Math::Accent { base, .. } | Math::Fence { body: base, .. } => deepest(&[Some(base)]),
        _ => None,
    };
    2 + below.unwrap_or(0)
}

/// How deep the deepest of some trees is.
fn deepest(children: &[Option<&Math>]) -> Option<usize> {
    children.iter().flatten().map(|child| depth(child)).max()
}

/// The parser's reason, without its drawing of the place.
fn reason(error: &dyn std::error::Error) -> String {
    error
        .source()
        .map_or_else(|| "this cannot be read".to_owned(), ToString::to_string)
}

/// Folds the parser's events into a tree; `None` where they end too soon.
struct Fold<'a> {
    events: &'a [Event<'a>],
    at: usize,
    font: Option<Style>,
}

impl<'a> Fold<'a> {
    fn peek(&self) -> Option<&'a Event<'a>> {
        self.events.get(self.at)
    }

    fn next(&mut self) -> Option<&'a Event<'a>> {
        let event = self.events.get(self.at);
        self.at += 1;
        event
    }

    /// Pieces up to the end of the group, cell or formula.
    fn row(&mut self, before: Atom) -> Option<Math> {
        let font = self.font;
        let mut pieces = Vec::new();
        let mut size = Size::Auto;
        loop {
            match self.peek() {
                None | Some(Event::End | Event::EnvironmentFlow(_)) => break,
                Some(Event::StateChange(change)) => {
                    self.at += 1;
                    match change {
                        StateChange::Font(font) => self.font = style_of(*font),
                        StateChange::Style(TexStyle::Display) => size = Size::Display,
                        StateChange::Style(_) => size = Size::Text,
                        StateChange::Color(_) => return None,
                    }
                }
                Some(_) if self.is_decimal_comma(&pieces) => {
                    self.at += 3;
                    pieces.push(Math::number(","));
                }
                Some(_) => {
                    let mut piece = self.element()?;
                    if let Math::Fraction { size: own, .. } = &mut piece
                        && size != Size::Auto
                    {
                        *own = size;
                    }
                    pieces.push(piece);
                }
            }
        }
        let style = self.font.filter(|_| self.font != font);
        self.font = font;
        Some(tidy(pieces, before, style))
    }

    /// `{,}` between two numbers.
    fn is_decimal_comma(&self, before: &[Math]) -> bool {
        matches!(before.last(), Some(Math::Number(_)))
            && matches!(
                self.events.get(self.at..self.at + 4),
                Some([
                    Event::Begin(Grouping::Normal),
                    Event::Content(Content::Punctuation(',')),
                    Event::End,
                    Event::Content(Content::Number(_)),
                ])
            )
    }

    /// One element: a character, a group, or what takes arguments.
    fn element(&mut self) -> Option<Math> {
        Some(match self.next()? {
            Event::Content(content) => self.content(content),
            Event::Begin(grouping) => self.group(grouping)?,
            Event::Visual(visual) => self.visual(*visual)?,
            Event::Script { ty, position } => self.script(*ty, *position)?,
            Event::Space { width, .. } => Math::Space(width.map_or(0, eighteenths)),
            Event::End | Event::StateChange(_) | Event::EnvironmentFlow(_) => return None,
        })
    }

    /// One element where a command or script takes it.
    fn argument(&mut self) -> Option<Math> {
        Some(match self.element()? {
            several @ (Math::Row(_) | Math::Operator { .. }) => {
                tidy(vec![several], Atom::Edge, None)
            }
            single => single,
        })
    }

    fn content(&self, content: &Content<'_>) -> Math {
        match *content {
            Content::Number(digits) => self.number(digits),
            Content::Function(name) => Math::function(name.trim()),
            Content::Text("&nbsp;") => Math::Space(6),
            Content::Text(raw) => words(raw),
            // `\|`, other than `\parallel`.
            Content::Ordinary { content: '∥', .. } => Math::operator("‖", Class::Ordinary),
            Content::Ordinary { content, .. }
            | Content::LargeOp { content, .. }
            | Content::BinaryOp { content, .. }
            | Content::Punctuation(content) => self.char(content),
            Content::Delimiter { content, ty, .. } => Math::operator(
                delimiter(content),
                match ty {
                    DelimiterType::Open => Class::Opening,
                    DelimiterType::Close => Class::Closing,
                    DelimiterType::Fence => Class::Ordinary,
                },
            ),
            Content::Relation { content, .. } => {
                let mut buffer = [0; 8];
                let bytes = content.encode_utf8_to_buf(&mut buffer);
                let text = std::str::from_utf8(bytes).unwrap_or_default();
                text.chars()
                    .next()
                    .map_or(Math::Row(Vec::new()), |char| self.char(char))
            }
        }
    }

    /// A number; a bare comma in it parts two, as in LaTeX.
    fn number(&self, digits: &str) -> Math {
        if let Some(style) = self.font.filter(|style| *style != Style::Upright) {
            return Math::identifier(digits, style);
        }
        let mut pieces = Vec::new();
        for (number, part) in digits.split(',').enumerate() {
            if number > 0 {
                pieces.push(Math::punctuation(","));
            }
            if !part.is_empty() {
                pieces.push(Math::number(part));
            }
        }
        Math::row(pieces)
    }

    /// A letter, sign or hole.
    fn char(&self, char: char) -> Math {
        if let Some(hole) = hole(char) {
            return Math::Hole(hole);
        }
        let char = match char {
            'µ' => 'μ',
            '·' => '⋅',
            '*' => '∗',
            '-' => '−',
            LITERAL => '≪',
            char => char,
        };
        if char.is_alphabetic() {
            return Math::identifier(char, self.font.unwrap_or_default());
        }
        let class = Sign::of(char).map_or(Class::Ordinary, |sign| sign.class);
        Math::operator(char, class)
    }

    fn group(&mut self, grouping: &Grouping) -> Option<Math> {
        let font = self.font;
        let math = match grouping {
            Grouping::Normal => self.row(Atom::Edge)?,
            Grouping::LeftRight(open, close) => {
                self.row(Atom::Edge)?.fenced(side(*open), side(*close))
            }
            Grouping::Matrix { .. } => self.table(TableKind::Matrix)?,
            Grouping::Cases { .. } => self.table(TableKind::Cases)?.fenced("{", ""),
            Grouping::Aligned | Grouping::Align { .. } | Grouping::Split => {
                self.table(TableKind::Aligned)?
            }
            _ => return None,
        };
        self.font = font;
        matches!(self.next()?, Event::End).then_some(math)
    }

    fn table(&mut self, kind: TableKind) -> Option<Math> {
        let mut rows = vec![Vec::new()];
        loop {
            let column = rows.last().map_or(0, Vec::len);
            // In the even columns of aligned lines LaTeX puts an empty symbol first.
            let before = if kind == TableKind::Aligned && column % 2 == 1 {
                Atom::Ordinary
            } else {
                Atom::Edge
            };
            let cell = self.row(before)?;
            rows.last_mut()?.push(cell);
            match self.peek()? {
                Event::EnvironmentFlow(EnvironmentFlow::Alignment) => self.at += 1,
                Event::EnvironmentFlow(EnvironmentFlow::NewLine { .. }) => {
                    self.at += 1;
                    rows.push(Vec::new());
                }
                Event::EnvironmentFlow(_) => return None,
                _ => break,
            }
        }
        if rows.len() > 1
            && rows.last().is_some_and(
                |row| matches!(row.as_slice(), [Math::Row(pieces)] if pieces.is_empty()),
            )
        {
            rows.pop();
        }
        Some(Math::Table { rows, kind })
    }

    fn visual(&mut self, visual: Visual) -> Option<Math> {
        Some(match visual {
            Visual::SquareRoot => Math::root(self.argument()?),
            Visual::Root => {
                let radicand = Box::new(self.argument()?);
                let degree = Some(Box::new(self.argument()?));
                Math::Root { radicand, degree }
            }
            Visual::Fraction(bar) => Math::Fraction {
                numerator: Box::new(self.argument()?),
                denominator: Box::new(self.argument()?),
                bar: bar.is_none_or(|bar| bar.value != 0.0),
                size: Size::Auto,
            },
            Visual::Negation => return None,
        })
    }

    fn script(&mut self, ty: ScriptType, position: ScriptPosition) -> Option<Math> {
        let base = self.argument()?;
        let lower = match ty {
            ScriptType::Superscript => None,
            _ => Some(self.mark()?),
        };
        let upper = match ty {
            ScriptType::Subscript => None,
            _ => Some(self.mark()?),
        };
        if position != ScriptPosition::AboveBelow {
            if is_degree(&base, lower.as_ref(), upper.as_ref()) {
                return Some(Math::operator("°", Class::Ordinary));
            }
            return Some(Math::Script {
                base: Box::new(base),
                sub: boxed(lower),
                sup: boxed(upper),
            });
        }
        if let (
            None,
            Some(Attachment {
                accent: Some(accent),
                ..
            }),
        ) = (&lower, &upper)
        {
            return Some(base.with_accent(*accent));
        }
        Some(stack(base, boxed(lower), boxed(upper)))
    }

    /// What stands below or above.
    fn mark(&mut self) -> Option<Attachment> {
        let sign = match self.peek()? {
            Event::Content(Content::Ordinary { content, .. }) => Some(*content),
            _ => None,
        };
        let math = self.argument()?;
        let is_dots = matches!(&math, Math::Operator { text, .. } if text == "…");
        let accent = match sign {
            Some('˙') => Some(Accent::Dot),
            Some('¨') => Some(Accent::DoubleDot),
            Some('^') => Some(Accent::Hat),
            Some('~') => Some(Accent::Tilde),
            Some('‾') => Some(Accent::Bar),
            Some('→') => Some(Accent::Vector),
            None if is_dots => Some(Accent::TripleDot),
            _ => None,
        };
        Some(Attachment { math, accent })
    }
}

/// What is attached, by itself.
fn boxed(mark: Option<Attachment>) -> Option<Box<Math>> {
    mark.map(|mark| Box::new(mark.math))
}

/// What stands below or above a base.
struct Attachment {
    math: Math,
    /// The accent that it is, over a base.
    accent: Option<Accent>,
}

/// `{}^\circ`, the degree sign of LaTeX.
fn is_degree(base: &Math, lower: Option<&Attachment>, upper: Option<&Attachment>) -> bool {
    let is_blank = matches!(base, Math::Row(pieces) if pieces.is_empty());
    is_blank && lower.is_none() && upper.is_some_and(|mark| mark.math.is_sign("∘"))
}

/// What stands below joined with what stands above: LaTeX writes one around the other.
fn stack(base: Math, under: Option<Box<Math>>, over: Option<Box<Math>>) -> Math {
    match base {
        Math::Stack {
            base,
            under: None,
            over: Some(own),
        } if over.is_none() && !own.is_brace() && !under.as_deref().is_some_and(Math::is_brace) => {
            Math::Stack {
                base,
                under,
                over: Some(own),
            }
        }
        Math::Stack {
            base,
            under: Some(own),
            over: None,
        } if under.is_none() && !own.is_brace() && !over.as_deref().is_some_and(Math::is_brace) => {
            Math::Stack {
                base,
                under: Some(own),
                over,
            }
        }
        base => Math::Stack {
            base: Box::new(base),
            under,
            over,
        },
    }
}

fn style_of(font: Option<Font>) -> Option<Style> {
    match font? {
        Font::Bold => Some(Style::Bold),
        Font::BoldSymbol => Some(Style::BoldItalic),
        Font::Script => Some(Style::Script),
        Font::DoubleStruck => Some(Style::Double),
        Font::UpRight => Some(Style::Upright),
        _ => None,
    }
}

fn delimiter(char: char) -> String {
    match char {
        '∥' => "‖".to_owned(),
        '∣' => "|".to_owned(),
        char => char.to_string(),
    }
}

fn side(delimiter: Option<char>) -> String {
    delimiter.map_or(String::new(), self::delimiter)
}

fn eighteenths(width: Dimension) -> i16 {
    let ems = match width.unit {
        DimensionUnit::Mu => width.value,
        _ => width.value * 18.0,
    };
    ems.round().clamp(-999.0, 999.0) as i16
}

/// Words as they are meant, their holes beside them.
fn words(raw: &str) -> Math {
    let mut pieces = Vec::new();
    let mut text = String::new();
    let mut rest = raw;
    while let Some(char) = rest.chars().next() {
        let (read, taken) = unescaped(rest, char);
        rest = &rest[taken..];
        let Some(char) = read else { continue };
        match hole(char) {
            Some(hole) => {
                if !text.is_empty() {
                    pieces.push(Math::Text(std::mem::take(&mut text)));
                }
                pieces.push(Math::Hole(hole));
            }
            None if char == LITERAL => text.push_str("<<"),
            None if char.is_ascii_whitespace() && text.ends_with(' ') => {}
            None if char.is_ascii_whitespace() => text.push(' '),
            None => text.push(char),
        }
    }
    if !text.is_empty() || pieces.is_empty() {
        pieces.push(Math::Text(text));
    }
    Math::row(pieces)
}

/// The character that begins a piece of words, and the length of its source.
fn unescaped(rest: &str, char: char) -> (Option<char>, usize) {
    const NAMES: &[(&str, char)] = &[
        (r"\textbackslash{}", '\\'),
        (r"\textasciicircum{}", '^'),
        (r"\textasciitilde{}", '~'),
    ];
    match char {
        '\\' => match NAMES.iter().find(|(name, _)| rest.starts_with(name)) {
            Some((name, char)) => (Some(*char), name.len()),
            None => match rest[1..].chars().next() {
                Some(escaped) => (Some(escaped), 1 + escaped.len_utf8()),
                None => (None, 1),
            },
        },
        '~' => (Some('\u{a0}'), 1),
        '{' | '}' => (None, 1),
        char => (Some(char), char.len_utf8()),
    }
}
