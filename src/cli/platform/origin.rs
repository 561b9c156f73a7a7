//! Where an answer belongs, as exports and packages write it into what platforms give back.

use vibank::seed::Variant;

/// What the last line of an exported question says: its item, its code, its number, and the part of each box.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct QuestionOrigin {
    /// A word that ends in the identity of the item; platforms that drop line breaks glue the word before to it.
    pub(crate) item: String,
    pub(crate) code: Variant,
    /// Its number in the export; none in questions that were exported before these were written.
    pub(crate) number: Option<usize>,
    pub(crate) boxes: Vec<BoxAnswer>,
}

/// What a box asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct BoxAnswer {
    /// The letter of the part.
    pub(crate) letter: String,
    /// The power of ten of the unit after the box: -3 where millimetres are asked in place of metres.
    pub(crate) power: i32,
}

impl QuestionOrigin {
    /// Reads the text of a question; none if it is not one of an export.
    pub(crate) fn read(text: &str) -> Option<Self> {
        let words: Vec<&str> = text.split_whitespace().collect();
        let at = words.iter().rposition(|word| code(word).is_some())?;
        let rest = &words[at + 1..];
        let number = rest.first().and_then(|word| word.parse().ok());
        let boxes: Vec<BoxAnswer> = rest[usize::from(number.is_some())..]
            .iter()
            .map_while(|word| BoxAnswer::read(word))
            .collect();
        let item = words[..at].last()?;
        let is_item = item.contains('/') && !boxes.is_empty();
        is_item.then_some(Self {
            item: (*item).to_owned(),
            code: code(words[at])?,
            number,
            boxes,
        })
    }
}

impl BoxAnswer {
    fn read(word: &str) -> Option<Self> {
        let (letter, power) = match word.split_once("*1e") {
            Some((letter, power)) => (letter, power.parse().ok()?),
            None => (word, 0),
        };
        let number = letter.trim_start_matches(|char: char| char.is_ascii_lowercase());
        let is_letter = (1..=4).contains(&(letter.len() - number.len()))
            && number.len() <= 3
            && number.bytes().all(|byte| byte.is_ascii_digit());
        is_letter.then(|| Self {
            letter: letter.to_owned(),
            power,
        })
    }
}

/// A code as it is printed, and no word that could be read as one.
fn code(word: &str) -> Option<Variant> {
    let code: Variant = word.parse().ok()?;
    (code.to_string() == word).then_some(code)
}

/// The identity of an interaction that a package reports: `ch3.item.part.XM2-9SB-THF.2`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Interaction {
    pub(crate) item: String,
    /// The identity of the part in the item.
    pub(crate) part: String,
    pub(crate) code: Variant,
    /// Which try it was, from 1.
    pub(crate) attempt: u64,
}

impl Interaction {
    pub(crate) fn read(text: &str) -> Option<Self> {
        let (rest, attempt) = text.trim().rsplit_once('.')?;
        let (rest, variant) = rest.rsplit_once('.')?;
        let (chapter, rest) = rest.split_once('.')?;
        let (item, part) = rest.split_once('.')?;
        Some(Self {
            item: format!("{chapter}/{item}"),
            part: part.to_owned(),
            code: code(variant)?,
            attempt: attempt.parse().ok()?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_line_of_a_question_names_its_boxes() {
        let code = Variant::new(7).expect("it is a variant");
        let text = format!("A block of 2 kg. ω = _____ rad/s\n\nch1/e2-block {code} 12 a b1 b2");
        let origin = QuestionOrigin::read(&text).expect("it is exported");
        let letters: Vec<&str> = origin.boxes.iter().map(|own| own.letter.as_str()).collect();
        assert_eq!((origin.item.as_str(), origin.code), ("ch1/e2-block", code));
        assert_eq!(
            (origin.number, &letters[..]),
            (Some(12), &["a", "b1", "b2"][..])
        );
        let before = QuestionOrigin::read(&text.replace(" 12 ", " ")).expect("it was exported");
        assert_eq!((before.number, before.boxes), (None, origin.boxes));
        let canvas = QuestionOrigin::read(&format!("How far?ch1/e2-block {code} c*1e-3"));
        let origin = canvas.expect("it is exported");
        assert_eq!(origin.item, "far?ch1/e2-block");
        assert_eq!(origin.boxes[0].power, -3);
        for text in ["", "What is 2 + 2?", "ch1/e2-block XXX-XXX-XXX a"] {
            assert_eq!(QuestionOrigin::read(text), None, "{text}");
        }
        for rest in ["", " 3", " 3 4 a", " a3b"] {
            let text = format!("ch1/e2-block {code}{rest}");
            assert_eq!(QuestionOrigin::read(&text), None, "{text}");
        }
    }

    #[test]
    fn an_interaction_names_part_and_try() {
        let code = Variant::new(7).expect("it is a variant");
        let read = Interaction::read(&format!("ch3.e5-decrement.damping.zeta_value.{code}.12"));
        let read = read.expect("it is one of a package");
        assert_eq!(read.item, "ch3/e5-decrement");
        assert_eq!(read.part, "damping.zeta_value");
        assert_eq!((read.code, read.attempt), (code, 12));
        assert_eq!(Interaction::read("Q1"), None);
        assert_eq!(Interaction::read("ch3.e5.part.ABC.1"), None);
    }
}
