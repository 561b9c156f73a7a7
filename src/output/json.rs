//! `json`: a sheet with its data and keys, for other programs.

use serde_json::{Value as Json, json};

use crate::answer::Blank;
use crate::message::Language;
use crate::scene::{Data, Scene};
use crate::solution::Solution;
use crate::worksheet::{Sheet, SheetQuestion, headings};

/// A sheet with its data and keys; answer lines and keys as they are printed in a language.
pub fn sheet(sheet: &Sheet<'_>, language: Language) -> Json {
    json!({
        "code": sheet.variant,
        "seed": sheet.variant.number(),
        "student": sheet.student.as_ref().map(|student| &student.columns),
        "points": sheet.points.to_f64(),
        "questions": sheet.questions.iter().map(|own| question(own, language)).collect::<Vec<_>>(),
    })
}

fn question(question: &SheetQuestion<'_>, language: Language) -> Json {
    let solution = &question.solution;
    let template = solution.template();
    let values = template.parameters.iter().zip(solution.instance().values());
    json!({
        "number": question.number,
        "item": template.id,
        "revision": template.revision,
        "seed": solution.instance().seed(),
        "title": template.about.title,
        "points": question.total().to_f64(),
        "values": values.map(|(parameter, value)| (parameter.name.to_string(), json!(value.to_string()))).collect::<serde_json::Map<_, _>>(),
        "parts": headings(template, &question.parts).iter().zip(question.parts.iter().zip(&question.points).zip(&question.spaces)).map(|(heading, ((place, points), space))| {
            let part = &template.parts[*place];
            json!({
                "letter": heading.letter,
                "id": part.id,
                "group": part.group.as_ref().map(|group| &group.id),
                "kind": part.answer.kind().name(),
                "points": points.to_f64(),
                "space": space.to_string(),
                "blank": blank(part.blank(), language),
                "key": key(solution, *place, language),
            })
        }).collect::<Vec<_>>(),
    })
}

/// What an answer line says, in parts and in words.
fn blank(blank: &Blank, language: Language) -> Json {
    let said = language.blank(blank).plain(&Vec::new());
    json!({
        "form": blank.form_name(),
        "letters": blank.letters.iter().map(|letter| &letter.typed).collect::<Vec<_>>(),
        "unit": blank.unit.map(|unit| unit.to_string()),
        "figures": blank.figures,
        "printed": said.trim(),
    })
}

/// A key, with its text as key pages print it. Values of functions need times, which a sheet does not ask for.
fn key(solution: &Solution<'_>, place: usize, language: Language) -> Json {
    let id = &solution.template().parts[place].id;
    let entry = solution.entry(id, &[]).unwrap_or_default();
    let mut entry = serde_json::to_value(entry).unwrap_or_default();
    let scene = Scene::of(solution, Data::Both).spoken(language);
    if let Json::Object(entry) = &mut entry {
        entry.retain(|_, value| !value.is_null() && *value != json!([]));
        if let Ok(Some(math)) = scene.key(place) {
            entry.insert("printed".to_owned(), math.plain().into());
        }
    }
    entry
}
