//! Which column of a class list is which: by the blueprint, else by the words that schools use.

use std::collections::BTreeMap;

use vibank::math::is_invisible;
use vibank::worksheet::{Columns, Student};

use crate::cli::table::TableRow;

/// What is known of a student.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum ColumnRole {
    Id,
    Given,
    Family,
    Name,
    Group,
    Room,
    Seat,
    Language,
    LargePrint,
    ExtraTime,
}

/// Words for headings, without accents and signs; of several columns for one thing the one of the earliest word counts.
const WORDS: [(ColumnRole, &[&str]); 10] = [
    (
        ColumnRole::Id,
        &[
            "id",
            "student id",
            "studentid",
            "student number",
            "student no",
            "student nr",
            "id number",
            "sis user id",
            "registration number",
            "matriculation number",
            "matriculation no",
            "matric number",
            "enrolment number",
            "enrollment number",
            "id nummer",
            "nummer id",
            "numero d identification",
            "numero de id",
            "numero de identificacao id",
            "codice identificativo",
            "numero etudiant",
            "numero d etudiant",
            "n etudiant",
            "no etudiant",
            "num etudiant",
            "code etudiant",
            "id etudiant",
            "identifiant",
            "matricule",
            "matrikelnummer",
            "matrikelnr",
            "matrikel nr",
            "matr nr",
            "matrikel",
            "matricola",
            "numero di matricola",
            "numero de matricula",
            "matricula",
            "numero de estudiante",
            "numero de aluno",
            "studentnummer",
            "opiskelijanumero",
            "studentnr",
            "studienummer",
            "numer albumu",
            "nr albumu",
            "ogrenci no",
            "ogrenci numarasi",
            "номер студента",
            "номер зачетной книжки",
            "зачетка",
            "学号",
            "學號",
            "学籍番号",
            "학번",
            "login",
            "username",
            "user name",
        ],
    ),
    (
        ColumnRole::Given,
        &[
            "first name",
            "firstname",
            "given name",
            "given names",
            "forename",
            "prenom",
            "prenoms",
            "vorname",
            "vornamen",
            "nombres",
            "voornaam",
            "voornamen",
            "fornamn",
            "fornavn",
            "imie",
            "jmeno",
            "etunimi",
            "ad",
            "adi",
            "имя",
            "имя и отчество",
        ],
    ),
    (
        ColumnRole::Family,
        &[
            "last name",
            "lastname",
            "surname",
            "family name",
            "nom de famille",
            "nachname",
            "familienname",
            "cognome",
            "apellido",
            "apellidos",
            "apelido",
            "apelidos",
            "achternaam",
            "efternamn",
            "etternavn",
            "nazwisko",
            "prijmeni",
            "sukunimi",
            "soyad",
            "soyadi",
            "фамилия",
        ],
    ),
    (
        ColumnRole::Name,
        &[
            "name",
            "full name",
            "fullname",
            "student name",
            "display name",
            "student",
            "nom complet",
            "nom et prenom",
            "nom prenom",
            "nom prenoms",
            "nom et prenoms",
            "prenom nom",
            "prenom et nom",
            "nombre completo",
            "nombre y apellidos",
            "apellidos y nombre",
            "nome completo",
            "nom",
            "nome",
            "nombre",
            "naam",
            "navn",
            "namn",
            "imie i nazwisko",
            "nimi",
            "ad soyad",
            "фио",
            "ф и о",
            "姓名",
            "氏名",
            "이름",
            "성명",
        ],
    ),
    (
        ColumnRole::Group,
        &[
            "group",
            "groupe",
            "gruppe",
            "grupo",
            "gruppo",
            "groep",
            "section",
            "class",
            "classe",
            "klasse",
            "groupe de td",
            "groupe td",
            "td",
            "tutorial group",
            "tutorial",
            "ubungsgruppe",
            "grupa",
            "skupina",
            "ryhma",
            "группа",
            "班级",
            "班級",
            "クラス",
            "분반",
            "cohort",
        ],
    ),
    (
        ColumnRole::Room,
        &[
            "room",
            "exam room",
            "hall",
            "exam hall",
            "salle",
            "raum",
            "horsaal",
            "saal",
            "aula",
            "sala",
            "zaal",
            "lokaal",
            "аудитория",
            "教室",
            "sal",
        ],
    ),
    (
        ColumnRole::Seat,
        &[
            "seat",
            "seat number",
            "place",
            "siege",
            "numero de place",
            "sitz",
            "sitzplatz",
            "platz",
            "platznummer",
            "asiento",
            "posto",
            "plaats",
            "место",
            "座位",
            "座席",
            "좌석",
        ],
    ),
    (
        ColumnRole::Language,
        &["language", "langue", "sprache", "idioma", "lingua", "taal"],
    ),
    (
        ColumnRole::LargePrint,
        &[
            "large print",
            "enlarged print",
            "gros caracteres",
            "grossdruck",
            "großdruck",
        ],
    ),
    (
        ColumnRole::ExtraTime,
        &[
            "extra time",
            "additional time",
            "more time",
            "temps majore",
            "tiers temps",
            "zeitverlangerung",
            "zeitzuschlag",
            "tempo aggiuntivo",
            "tiempo adicional",
        ],
    ),
];

/// The columns of a class list.
#[derive(Debug, PartialEq)]
pub(crate) struct Places {
    /// What they give, in the order in which they are joined.
    given: Vec<(&'static str, Vec<usize>)>,
}

/// Why the columns are not known.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(crate) enum HeadingError {
    #[error("has no column `id`")]
    NoId,
    #[error("has no column `{0}`, which the blueprint names")]
    Missing(String),
    #[error("has two columns `{0}`")]
    Twice(String),
}

impl Places {
    /// The columns that mean something to the program.
    pub(crate) fn columns(&self) -> impl Iterator<Item = usize> {
        self.given.iter().flat_map(|(_, columns)| columns).copied()
    }

    pub(crate) fn of(headings: &[String], columns: &Columns) -> Result<Self, HeadingError> {
        let folded: Vec<String> = headings.iter().map(|heading| fold(heading)).collect();
        let place = |heading: &str| {
            let mut found = (0..folded.len()).filter(|at| folded[*at] == fold(heading));
            match (found.next(), found.next()) {
                (_, Some(at)) => Err(HeadingError::Twice(headings[at].clone())),
                (found, None) => Ok(found),
            }
        };
        let known = |role: ColumnRole| -> Result<Option<usize>, HeadingError> {
            let words = WORDS.iter().find(|(own, _)| *own == role);
            for word in words.map_or(&[] as &[&str], |(_, words)| words) {
                if let Some(at) = place(word)? {
                    return Ok(Some(at));
                }
            }
            Ok(None)
        };
        let mut given = Vec::new();
        for (what, role) in [
            ("id", ColumnRole::Id),
            ("name", ColumnRole::Name),
            ("group", ColumnRole::Group),
            ("room", ColumnRole::Room),
            ("seat", ColumnRole::Seat),
            ("language", ColumnRole::Language),
            ("large_print", ColumnRole::LargePrint),
            ("extra_time", ColumnRole::ExtraTime),
        ] {
            let own = columns.headings.iter().find(|(own, _)| *own == what);
            let places = match (own, role) {
                (Some((_, headings)), _) => {
                    let places = headings.iter().map(|heading| {
                        place(&heading.value)?
                            .ok_or_else(|| HeadingError::Missing(heading.value.clone()))
                    });
                    places.collect::<Result<Vec<_>, _>>()?
                }
                (None, ColumnRole::Name) => {
                    let whole = known(ColumnRole::Name)?;
                    let (first, last) = (known(ColumnRole::Given)?, known(ColumnRole::Family)?);
                    // `Nom` is the family name beside `Prénom`, and `Nome` the given name beside `Cognome`.
                    match (first, last) {
                        (None, None) => whole.into_iter().collect(),
                        (first, last) => {
                            first.or(whole).into_iter().chain(last.or(whole)).collect()
                        }
                    }
                }
                (None, role) => known(role)?.into_iter().collect(),
            };
            given.push((what, places));
        }
        // One column does not make up a name twice.
        given.iter_mut().for_each(|(_, places)| places.dedup());
        if given[0].1.is_empty() {
            return Err(HeadingError::NoId);
        }
        Ok(Self { given })
    }

    /// The student of a row; columns that mean nothing here are kept under their headings.
    pub(crate) fn student(&self, headings: &[String], row: &TableRow<'_>) -> Student {
        let mut columns: BTreeMap<String, String> = headings
            .iter()
            .enumerate()
            .filter(|(at, heading)| {
                !self.given.iter().any(|(_, places)| places.contains(at)) && !heading.is_empty()
            })
            .map(|(at, heading)| (heading.to_lowercase(), visible(row.cell(at))))
            .collect();
        for (what, places) in &self.given {
            let words = places.iter().map(|at| visible(row.cell(*at)));
            let words: Vec<String> = words.filter(|word| !word.is_empty()).collect();
            if !places.is_empty() {
                columns.insert((*what).to_owned(), words.join(" "));
            }
        }
        let column = |name: &str| columns.get(name).cloned().unwrap_or_default();
        Student {
            id: column("id"),
            name: column("name"),
            group: column("group"),
            room: column("room"),
            seat: column("seat"),
            extra_time: column("extra_time"),
            type_size: None,
            columns,
        }
    }
}

/// A cell as it is seen: marks of direction and byte order, which would reverse what comes after a name, are dropped, those
/// that join letters of some scripts are kept.
fn visible(cell: &str) -> String {
    let seen = cell.chars().filter(|char| {
        matches!(*char, '\u{200c}' | '\u{200d}' | '\u{fe0e}' | '\u{fe0f}') || !is_invisible(*char)
    });
    let seen: String = seen
        .map(|char| if char.is_control() { ' ' } else { char })
        .collect();
    seen.trim().to_owned()
}

/// A heading in small letters without accents, signs between words as one blank.
fn fold(heading: &str) -> String {
    let mut folded = String::with_capacity(heading.len());
    for char in heading.chars().flat_map(char::to_lowercase) {
        match char {
            'à' | 'á' | 'â' | 'ã' | 'ä' | 'å' | 'ą' => folded.push('a'),
            'ç' | 'č' | 'ć' => folded.push('c'),
            'è' | 'é' | 'ê' | 'ë' | 'ę' | 'ě' => folded.push('e'),
            'ì' | 'í' | 'î' | 'ï' => folded.push('i'),
            'ñ' | 'ń' | 'ň' => folded.push('n'),
            'ł' => folded.push('l'),
            'ś' | 'š' | 'ş' => folded.push('s'),
            'ý' => folded.push('y'),
            'ğ' => folded.push('g'),
            'ı' => folded.push('i'),
            'ř' => folded.push('r'),
            'ž' | 'ź' | 'ż' => folded.push('z'),
            'ò' | 'ó' | 'ô' | 'õ' | 'ö' | 'ø' => folded.push('o'),
            'ù' | 'ú' | 'û' | 'ü' => folded.push('u'),
            // Accents on their own.
            '\u{300}'..='\u{36f}' => {}
            _ if char.is_alphanumeric() => folded.push(char),
            _ if folded.ends_with(' ') || folded.is_empty() => {}
            _ => folded.push(' '),
        }
    }
    folded.trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the cells `0`, `1`, … of a row give under these headings.
    fn columns(headings: &str) -> Result<String, HeadingError> {
        let headings: Vec<String> = headings.split(';').map(str::to_owned).collect();
        let places = Places::of(&headings, &Columns::default())?;
        let cells = (0..headings.len()).map(|at| at.to_string().into());
        let row = TableRow {
            line: 2,
            cells: cells.collect(),
        };
        let student = places.student(&headings, &row);
        let Student {
            id,
            name,
            group,
            seat,
            ..
        } = student;
        Ok([id, name, group, seat].join(";"))
    }

    #[test]
    fn headings_of_schools_are_known() {
        for (headings, given) in [
            ("id;name;group;seat", "0;1;2;3"),
            ("Name;ID", "1;0;;"),
            ("Last name;First name;Student ID;Section", "2;1 0;3;"),
            ("Nom;Prénom;N° étudiant;Groupe de TD", "2;1 0;3;"),
            ("Nom ;Pre\u{301}nom;Numéro d'étudiant", "2;1 0;;"),
            ("Nachname;Vorname;Matrikelnummer;Sitzplatz", "2;1 0;;3"),
            ("Name;Vorname;Matr.-Nr.", "2;1 0;;"),
            ("Cognome;Nome;Matricola", "2;1 0;;"),
            ("Nom de famille;Prénom;Numéro d’identification", "2;1 0;;"),
            ("Nachname;Vorname;ID-Nummer", "2;1 0;;"),
            ("Apelido;Nome;Número de identificação (ID)", "2;1 0;;"),
            ("Apellidos;Nombre;Matrícula;Grupo", "2;1 0;3;"),
            ("Student;ID;SIS User ID;Section", "1;0;3;"),
            ("Username;First name;Last name;ID number", "3;1 2;;"),
            ("STUDENT_ID;FULL_NAME", "0;1;;"),
            ("id;Hall;Seat", "0;;;2"),
            ("Nazwisko;Imię;Numer albumu;Grupa", "2;1 0;3;"),
            ("Příjmení;Jméno;ID", "2;1 0;;"),
            ("Öğrenci No;Ad Soyad", "0;1;;"),
            ("Номер студента;Фамилия;Имя;Группа", "0;2 1;3;"),
            ("学号;姓名;班级;座位", "0;1;2;3"),
            ("Efternamn;Förnamn;Studienummer", "2;1 0;;"),
        ] {
            assert_eq!(columns(headings).as_deref(), Ok(given), "{headings}");
        }
    }

    #[test]
    fn what_is_not_known_is_said() {
        assert_eq!(columns("Nr;Wer"), Err(HeadingError::NoId));
        let twice = Err(HeadingError::Twice("ID".to_owned()));
        assert_eq!(columns("id;name;ID"), twice);
    }
}
