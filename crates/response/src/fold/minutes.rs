//! Angles in degrees, minutes and seconds.

use super::Folder;
use crate::signs::{ANGLES, is_digit};

impl Folder<'_> {
    /// `53°7'48"`, degrees with their minutes and seconds, as a sum; whether they stand here.
    pub(crate) fn minutes(&mut self) -> bool {
        if self.typed[..self.at]
            .ends_with(|before: char| before.is_ascii_digit() || ".,".contains(before))
        {
            return false;
        }
        let typed = self.typed;
        let rest = &typed[self.at..self.answer.end];
        let number = |text: &'_ str| {
            let bare = text.trim_start_matches(' ');
            let end = bare.find(|char: char| !(char.is_ascii_digit() || ".,".contains(char)));
            let end = end.unwrap_or(bare.len());
            (end > 0 && bare.starts_with(is_digit))
                .then(|| (text.len() - bare.len(), text.len() - bare.len() + end))
        };
        let Some((0, degrees)) = number(rest) else {
            return false;
        };
        let behind_sign = |text: &'_ str, signs: &[&str]| -> Option<usize> {
            let bare = text.trim_start_matches(' ');
            let sign = signs.iter().find(|sign| bare.starts_with(**sign))?;
            Some(text.len() - bare.len() + sign.len())
        };
        let Some(sign) = behind_sign(&rest[degrees..], &["°", "º", "˚"]) else {
            return false;
        };
        let mut at = degrees + sign;
        let mut sum = rest[..degrees].to_owned();
        for (signs, share) in ANGLES {
            let Some((from, to)) = number(&rest[at..]) else {
                break;
            };
            let Some(sign) = behind_sign(&rest[at + to..], signs) else {
                break;
            };
            sum.push_str(&format!("+{}/{share}", &rest[at + from..at + to]));
            at += to + sign;
        }
        let has_minutes = sum.contains("/60");
        if has_minutes {
            self.write(&format!("({sum})°"), at);
        }
        has_minutes
    }
}
