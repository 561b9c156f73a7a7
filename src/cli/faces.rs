//! Fonts for names in scripts that the press has no letters of.
//!
//! They come from the folder that the blueprint names with `fonts`, else from that of `VIBANK_FONTS`, else from the system.
//! Which letters a font has, it says itself; of several that have all letters of a name, one is taken by its name, so that
//! the same fonts give the same pages.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use fontdb::{Database, Source, Stretch, Style, Weight};
use ttf_parser::Face;
use vibank::output::Names;
use vibank::worksheet::{FileStamp, Student};
use vibank_press_protocol::has_sign;

use super::{Failure, files, setting};

/// Names a folder with fonts.
const VARIABLE: &str = "VIBANK_FONTS";

/// Fonts of one run. With scripts of all continents fewer are needed.
const MAX_COUNT: usize = 32;

/// The fonts of a run, and who is printed without their name.
#[derive(Clone, Debug, Default)]
pub(crate) struct Faces {
    /// Their files.
    pub(crate) paths: Vec<String>,
    /// The same as the manifest has them.
    pub(crate) stamps: Vec<FileStamp>,
    /// What the pages have to know.
    pub(crate) names: Names,
    /// Students whose name no font has, by `id`.
    pub(crate) without: Vec<String>,
}

/// A font, with those letters of the run that it has.
#[derive(Clone, Debug, PartialEq, Eq)]
struct FontCandidate {
    family: String,
    path: PathBuf,
    signs: BTreeSet<char>,
}

impl Faces {
    /// The fonts for what pages print of these students; `folder` is that of the blueprint.
    ///
    /// # Errors
    ///
    /// A folder that was named and cannot be read.
    pub(crate) fn of(students: &[Student], folder: Option<&Path>) -> Result<Self, Failure> {
        let printed = students.iter().flat_map(printed);
        let needed: BTreeSet<char> = printed.flat_map(wanting).collect();
        if needed.is_empty() {
            return Ok(Self::default());
        }
        let mut fonts = Database::new();
        let named = setting(VARIABLE).map(PathBuf::from);
        match folder.map(Path::to_owned).or(named) {
            Some(folder) => {
                if !folder.is_dir() {
                    let message = format!("there is no folder `{}` with fonts", folder.display());
                    return Err(Failure::new(message).help(format!(
                        "correct `fonts` in the blueprint, or {VARIABLE}; without both, the fonts of the system are used"
                    )));
                }
                fonts.load_fonts_dir(&folder);
            }
            None => fonts.load_system_fonts(),
        }
        Self::chosen(students, &candidates(&fonts, &needed))
    }

    fn chosen(students: &[Student], candidates: &[FontCandidate]) -> Result<Self, Failure> {
        let mut faces = Self::default();
        let mut taken: BTreeSet<&Path> = BTreeSet::new();
        for (student, words) in students
            .iter()
            .flat_map(|student| printed(student).map(move |words| (student, words)))
        {
            let signs: BTreeSet<char> = wanting(words).collect();
            if signs.is_empty() {
                continue;
            }
            let Some(own) = cover(&signs, candidates) else {
                faces.names.without.insert(words.to_owned());
                if faces.without.last() != Some(&student.id) {
                    faces.without.push(student.id.clone());
                }
                continue;
            };
            for candidate in own {
                let family = &candidate.family;
                if !faces.names.families.contains(family) {
                    faces.names.families.push(family.clone());
                }
                taken.insert(&candidate.path);
            }
        }
        for path in taken.into_iter().take(MAX_COUNT) {
            let name = path.file_name().unwrap_or_default();
            faces.stamps.push(FileStamp {
                path: name.to_string_lossy().into_owned(),
                digest: files::digest_of(path)?,
            });
            faces.paths.push(path.to_string_lossy().into_owned());
        }
        Ok(faces)
    }

    /// A line that names the students who are printed without their name.
    pub(crate) fn remark(&self) -> Option<String> {
        /// Students who are named in the line.
        const SHOWN: usize = 12;
        if self.without.is_empty() {
            return None;
        }
        let more = self.without.len().saturating_sub(SHOWN);
        let shown = self.without[..self.without.len() - more].join(", ");
        let more = if more > 0 {
            format!(" and {more} more")
        } else {
            String::new()
        };
        Some(format!(
            "no font has the names of these students, whose PDF shows the id in place of it: {shown}{more}; name a folder with fonts by `fonts` in the blueprint or by {VARIABLE}"
        ))
    }
}

/// What pages print of a student.
fn printed(student: &Student) -> [&str; 6] {
    let Student {
        name,
        id,
        group,
        room,
        seat,
        extra_time,
        ..
    } = student;
    [name, id, group, room, seat, extra_time]
}

/// The signs of a name that the press has no letters for; blanks and marks without a shape need none.
fn wanting(name: &str) -> impl Iterator<Item = char> {
    name.chars()
        .filter(move |sign| !has_sign(*sign) && !has_no_shape(*sign))
}

/// Whether a sign has no shape: a space, a control, or one that joins or directs others.
fn has_no_shape(sign: char) -> bool {
    sign.is_whitespace()
        || sign.is_control()
        || matches!(sign, '\u{200b}'..='\u{200f}' | '\u{2060}'..='\u{2064}' | '\u{fe00}'..='\u{fe0f}')
}

/// Upright fonts of normal weight that have some of the signs, best first.
fn candidates(fonts: &Database, needed: &BTreeSet<char>) -> Vec<FontCandidate> {
    let mut candidates: Vec<FontCandidate> = Vec::new();
    for face in fonts.faces() {
        let is_plain = face.style == Style::Normal
            && face.weight == Weight::NORMAL
            && face.stretch == Stretch::Normal;
        let (Source::File(path) | Source::SharedFile(path, _)) = &face.source else {
            continue;
        };
        let Some((family, _)) = face
            .families
            .first()
            .filter(|_| is_plain && path.to_str().is_some())
        else {
            continue;
        };
        let has = |data: &[u8], index: u32| {
            let face = Face::parse(data, index).ok()?;
            let signs = needed.iter().copied();
            Some(
                signs
                    .filter(|sign| face.glyph_index(*sign).is_some())
                    .collect::<BTreeSet<char>>(),
            )
        };
        let signs = fonts
            .with_face_data(face.id, has)
            .flatten()
            .unwrap_or_default();
        if !signs.is_empty() {
            candidates.push(FontCandidate {
                family: family.clone(),
                path: path.clone(),
                signs,
            });
        }
    }
    candidates.sort_by_key(|candidate| {
        (
            rank(&candidate.family),
            candidate.family.clone(),
            candidate.path.clone(),
        )
    });
    candidates
}

/// How well a family goes with the text: a serif one, then one without, then any other; of ideographs the simplified
/// forms, since a name alone does not say its language; and fonts that show a box for everything last.
fn rank(family: &str) -> u8 {
    let is_regional = ["HK", "JP", "KR", "TC"]
        .iter()
        .any(|region| family.ends_with(region));
    match family {
        _ if ["LastResort", "Last Resort", "Adobe Blank", "Unifont"]
            .iter()
            .any(|last| family.contains(last)) =>
        {
            9
        }
        _ if family.starts_with("Noto Serif") => u8::from(is_regional),
        _ if family.starts_with("Noto Sans") => 2 + u8::from(is_regional),
        _ if family.contains("Serif") => 4,
        _ => 5,
    }
}

/// The best font that has all signs, else few that have them together; nothing where a sign is in none.
fn cover<'c>(
    signs: &BTreeSet<char>,
    candidates: &'c [FontCandidate],
) -> Option<Vec<&'c FontCandidate>> {
    if let Some(whole) = candidates
        .iter()
        .find(|candidate| signs.is_subset(&candidate.signs))
    {
        return Some(vec![whole]);
    }
    let (mut open, mut own) = (signs.clone(), Vec::new());
    while let Some(sign) = open.first().copied() {
        let next = candidates
            .iter()
            .find(|candidate| candidate.signs.contains(&sign))?;
        open.retain(|sign| !next.signs.contains(sign));
        own.push(next);
    }
    Some(own)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn candidate(family: &str, signs: &str) -> FontCandidate {
        FontCandidate {
            family: family.to_owned(),
            path: PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml")),
            signs: signs.chars().collect(),
        }
    }

    fn student(id: &str, name: &str) -> Student {
        Student {
            id: id.to_owned(),
            name: name.to_owned(),
            ..Student::default()
        }
    }

    #[test]
    fn names_that_the_press_has_need_no_font() {
        let latin = [
            "Zoë Å. O'Neil",
            "Юлия Ёлкина",
            "שרה כהן",
            "Nguyễn Thị Ánh",
            "A\u{308}b\u{200b}",
        ];
        for name in latin {
            assert_eq!(wanting(name).count(), 0, "{name}");
        }
        assert_eq!(wanting("王 明").collect::<String>(), "王明");
    }

    #[test]
    fn one_font_for_a_name_is_better_than_two() {
        let fonts = [
            candidate("A", "王"),
            candidate("B", "王明"),
            candidate("C", "ก"),
        ];
        let families = |name: &str| {
            let cover = cover(&wanting(name).collect(), &fonts)?;
            Some(
                cover
                    .iter()
                    .map(|font| font.family.as_str())
                    .collect::<String>(),
            )
        };
        assert_eq!(families("王").as_deref(), Some("A"));
        assert_eq!(families("王明").as_deref(), Some("B"));
        assert_eq!(families("明ก").as_deref(), Some("CB"));
        assert_eq!(families("明ب"), None);
    }

    #[test]
    fn who_has_no_font_is_named() -> Result<(), Failure> {
        let students = [
            student("s1", "王"),
            student("s2", "ب"),
            student("s3", "Ann"),
        ];
        let faces = Faces::chosen(&students, &[candidate("A", "王")])?;
        assert_eq!(faces.names.families, ["A"]);
        assert_eq!(faces.without, ["s2"]);
        assert!(faces.names.without.contains("ب"));
        assert!(faces.remark().is_some_and(|line| line.contains(": s2;")));
        assert_eq!(faces.stamps.len(), 1);
        Ok(())
    }

    #[test]
    fn families_are_ranked_by_how_they_go_with_the_text() {
        let mut families = [
            "Unifont",
            "Noto Sans CJK SC",
            "Droid",
            "Noto Sans CJK JP",
            "Noto Serif Thai",
        ];
        families.sort_by_key(|family| rank(family));
        assert_eq!(
            families,
            [
                "Noto Serif Thai",
                "Noto Sans CJK SC",
                "Noto Sans CJK JP",
                "Droid",
                "Unifont"
            ]
        );
    }
}
