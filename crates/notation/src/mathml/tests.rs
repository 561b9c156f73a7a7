use super::*;

fn check(math: Math, expected: &str) {
    let written = math.mathml(Display::Inline, Voice::ENGLISH);
    let body = written
        .split_once("\">")
        .and_then(|(_, rest)| rest.strip_suffix("</math>"));
    assert_eq!(body, Some(expected));
}

#[test]
fn letters_are_set_in_their_style() {
    check(Math::letter('x'), "<mi>x</mi>");
    check(Math::letter('Ω'), "<mi mathvariant=\"normal\">Ω</mi>");
    check(Math::upright("kg"), "<mi>kg</mi>");
    check(Math::upright("d"), "<mi mathvariant=\"normal\">d</mi>");
    for (text, style, set) in [
        ("M", Style::Bold, "𝐌"),
        ("ω1", Style::Bold, "𝛚𝟏"),
        ("q", Style::BoldItalic, "𝒒"),
        ("Φ", Style::BoldItalic, "𝚽"),
        ("LT", Style::Script, "ℒ𝒯"),
        ("RC", Style::Double, "ℝℂ"),
        ("ß<", Style::Bold, "ß&lt;"),
    ] {
        check(Math::identifier(text, style), &format!("<mi>{set}</mi>"));
    }
}

#[test]
fn functions_keep_a_thin_space_from_letters_alone() {
    let thin = "<mspace width=\".1667em\"></mspace>";
    let sine = "<mo form=\"prefix\" lspace=\"0\" rspace=\"0\">sin</mo>";
    let row = |argument| Math::row([Math::letter('a'), Math::function("sin"), argument]);
    check(
        row(Math::letter('x')),
        &format!("<mi>a</mi>{thin}{sine}{thin}<mi>x</mi>"),
    );
    let closed = row(Math::letter('x').in_parentheses()).mathml(Display::Inline, Voice::ENGLISH);
    assert!(
        closed.contains(&format!("<mi>a</mi>{thin}{sine}<mrow>")),
        "{closed}"
    );
}

#[test]
fn scripts_hold_no_spaces() {
    let sum = Math::row([Math::letter('n'), Math::binary("+"), Math::number("1")]);
    check(
        Math::letter('x').with_sub(sum),
        "<msub><mi>x</mi><mrow><mi>n</mi><mo lspace=\"0\" rspace=\"0\">+</mo><mn>1</mn></mrow></msub>",
    );
}

#[test]
fn words_cannot_leave_their_element() {
    let text = Math::text("a\"></math><script>&");
    let written = text.mathml(Display::Block, Voice::ENGLISH);
    assert_eq!(
        written,
        "<math display=\"block\" alttext=\"a&quot;&gt;&lt;/math&gt;&lt;script&gt;&amp;\">\
         <mtext>a&quot;&gt;&lt;/math&gt;&lt;script&gt;&amp;</mtext></math>"
    );
}

#[test]
fn a_filling_has_no_holes_of_its_own() {
    let fills = vec![Math::Hole(0), Math::row([Math::Hole(1), Math::letter('y')])];
    let mut out = String::new();
    Math::row([Math::Hole(0), Math::Hole(1)]).write_mathml(
        &mut out,
        Display::Inline,
        &fills,
        Voice::ENGLISH,
    );
    assert!(
        out.ends_with("<mi>□</mi><mi>□</mi><mi>y</mi></math>"),
        "{out}"
    );
}
