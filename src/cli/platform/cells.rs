//! What a cell of a report holds: entities, the boxes of a question in one text, the parts of an essay.

/// A text without the entities that some reports write; each is decoded once.
pub(crate) fn decoded(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('&') {
        out.push_str(&rest[..at]);
        rest = &rest[at..];
        let end = rest.find(';').filter(|end| *end <= 10);
        match end.and_then(|end| Some((entity(&rest[1..end])?, end))) {
            Some((sign, end)) => {
                out.push(sign);
                rest = &rest[end + 1..];
            }
            None => {
                out.push('&');
                rest = &rest[1..];
            }
        }
    }
    out.push_str(rest);
    out
}

fn entity(name: &str) -> Option<char> {
    let number = name.strip_prefix('#').and_then(|number| {
        number.strip_prefix(['x', 'X']).map_or_else(
            || number.parse().ok(),
            |digits| u32::from_str_radix(digits, 16).ok(),
        )
    });
    match name {
        "amp" => Some('&'),
        "lt" => Some('<'),
        "gt" => Some('>'),
        "quot" => Some('"'),
        "apos" => Some('\''),
        "nbsp" => Some(' '),
        "minus" => Some('−'),
        _ => number.and_then(char::from_u32),
    }
}

/// HTML without its tags and signs of spacing, as two texts of one option are compared.
pub(crate) fn bare(html: &str) -> String {
    let mut text = String::with_capacity(html.len());
    let mut is_tag = false;
    for (at, char) in html.char_indices() {
        let begins = char == '<'
            && html[at + 1..].starts_with(|next: char| next.is_ascii_alphabetic() || next == '/');
        match char {
            '<' if begins => is_tag = true,
            '>' if is_tag => is_tag = false,
            _ if is_tag => {}
            _ => text.push(char),
        }
    }
    decoded(&text)
        .chars()
        .filter(|char| !char.is_whitespace() && !vibank::math::is_invisible(*char))
        .flat_map(char::to_lowercase)
        .collect()
}

/// Longest words before the colon of a box.
const MAX_LABEL_LENGTH: usize = 40;

/// The answers of several boxes in one text, as Moodle writes them: `part 1: 5.2; part 2: 7`, in the language of the site.
///
/// `None` where the text does not begin like that. An answer in which the words of another box stand cannot be cut:
/// `Some(Err(()))`.
pub(crate) fn boxes(text: &str, count: usize) -> Option<Result<Vec<String>, ()>> {
    let colon = text.find([':', '：'])?;
    let end = colon + text[colon..].chars().next()?.len_utf8();
    let label = &text[..end];
    let digits: String = label.chars().filter(char::is_ascii_digit).collect();
    let has_word = label.chars().any(char::is_alphabetic);
    if digits != "1" || !has_word || end > MAX_LABEL_LENGTH {
        return None;
    }
    let (mut answers, mut from) = (Vec::with_capacity(count), end);
    for number in 2..=count + 1 {
        let label = format!("; {}", label.replace('1', &number.to_string()));
        let mut places = text.match_indices(label.as_str()).map(|(at, _)| at);
        match (places.next(), places.next()) {
            (Some(at), None) if number <= count && at >= from => {
                answers.push(text[from..at].trim().to_owned());
                from = at + label.len();
            }
            (None, None) if number > count => answers.push(text[from..].trim().to_owned()),
            _ => return Some(Err(())),
        }
    }
    Some(Ok(answers))
}

/// The lines of a text that a student has typed.
///
/// Tables that Moodle writes have three spaces in place of each line break.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = &str> {
    text.lines().flat_map(|line| line.split("   "))
}

/// The answers to several parts in one text, each after its letter: `c) k1 + k2`, a new line, `d) …`.
///
/// `None` if letters are missing, in another order, or twice.
pub(crate) fn essay(text: &str, letters: &[&str]) -> Option<Vec<String>> {
    let mut answers: Vec<String> = Vec::new();
    for line in lines(text) {
        match labelled(line, letters) {
            Some((at, rest)) if at == answers.len() => answers.push(rest.trim().to_owned()),
            Some(_) => return None,
            None => match answers.last_mut() {
                Some(answer) => {
                    answer.push('\n');
                    answer.push_str(line.trim());
                }
                None if line.trim().is_empty() => {}
                None => return None,
            },
        }
    }
    answers
        .iter_mut()
        .for_each(|answer| *answer = answer.trim().to_owned());
    (answers.len() == letters.len()).then_some(answers)
}

/// The part whose letter a line begins with, and what comes after it.
fn labelled<'l>(line: &'l str, letters: &[&str]) -> Option<(usize, &'l str)> {
    let line = line.trim_start();
    let (word, rest) = line.strip_prefix('(').unwrap_or(line).split_once(')')?;
    let at = letters.iter().position(|letter| *letter == word.trim())?;
    Some((at, rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut(text: &str, count: usize) -> String {
        match boxes(text, count) {
            None => "none".to_owned(),
            Some(Err(())) => "doubt".to_owned(),
            Some(Ok(answers)) => answers.join("|"),
        }
    }

    #[test]
    fn boxes_are_cut_in_each_language() {
        for (text, count, answers) in [
            ("part 1: 5.2; part 2: 7", 2, "5.2|7"),
            ("part 1: ; part 2:", 2, "|"),
            ("Teil 1: 5,2; Teil 2: 1,4 ; 1,6", 2, "5,2|1,4 ; 1,6"),
            ("partie 1 : 5,2; partie 2 : -", 2, "5,2|-"),
            ("1. osa: 3; 2. osa: 4", 2, "3|4"),
            ("部分 1：3; 部分 2：4", 2, "3|4"),
            ("part 1: 5", 1, "5"),
            ("5.2", 1, "none"),
            ("x = 5: maybe", 1, "none"),
            ("part 1: 5; part 2: 6", 1, "doubt"),
            ("part 1: 5", 2, "doubt"),
            ("part 1: 5; part 2: 6; part 2: 7", 2, "doubt"),
        ] {
            assert_eq!(cut(text, count), answers, "{text}");
        }
        let many: Vec<String> = (1..=12).map(|own| format!("part {own}: {own}")).collect();
        let answers: Vec<String> = (1..=12).map(|own: i32| own.to_string()).collect();
        assert_eq!(cut(&many.join("; "), 12), answers.join("|"));
    }

    #[test]
    fn parts_of_an_essay_stand_behind_their_letters() {
        let letters = ["c", "d1"];
        let read = essay("c) k1 + k2\n\n(d1) m x'' + k x\n= 0\n", &letters);
        assert_eq!(
            read,
            Some(vec!["k1 + k2".to_owned(), "m x'' + k x\n= 0".to_owned()])
        );
        // As Moodle writes the end of a paragraph.
        let read = essay("c) k1 + k2      (d1) m x'' + k x   = 0", &letters);
        assert_eq!(
            read,
            Some(vec!["k1 + k2".to_owned(), "m x'' + k x\n= 0".to_owned()])
        );
        for text in [
            "k1 + k2",
            "d1) x\nc) y",
            "c) x",
            "c) x\nc) y",
            "first\nc) x\nd1) y",
        ] {
            assert_eq!(essay(text, &letters), None, "{text}");
        }
    }

    #[test]
    fn entities_are_decoded_once() {
        assert_eq!(
            decoded("a &lt; b &amp;lt; &#x3c9;&#8722; & x; &nope;"),
            "a < b &lt; ω− & x; &nope;"
        );
        assert_eq!(bare("<b>k</b> &lt; 2 <mi>ω</mi>"), "k<2ω");
        assert_eq!(bare("x < 2 m"), "x<2m");
    }
}
