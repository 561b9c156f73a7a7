//! Free-body diagrams in words.

use crate::figure::Point;

/// A direction in words.
pub(crate) fn towards(direction: Point) -> &'static str {
    const WORDS: [&str; 8] = [
        "to the right",
        "up and to the right",
        "upwards",
        "up and to the left",
        "to the left",
        "down and to the left",
        "downwards",
        "down and to the right",
    ];
    let eighths = direction.angle() / std::f64::consts::FRAC_PI_4;
    WORDS[(eighths.round() as i64).rem_euclid(8) as usize]
}

/// What acts on a body, in one sentence.
pub(crate) fn sentence(body: &str, forces: &[String]) -> String {
    match forces {
        [] => format!("Nothing acts on {body}."),
        [one] => format!("On {body} acts {one}."),
        [rest @ .., last] => format!("On {body} act {} and {last}.", rest.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_have_words() {
        assert_eq!(towards(Point::new(0.1, 1.0)), "upwards");
        assert_eq!(towards(Point::new(-1.0, 0.0)), "to the left");
        assert_eq!(towards(Point::new(1.0, -1.0)), "down and to the right");
    }
}
