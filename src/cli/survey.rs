//! Surveys of items as tables, which read well in a terminal and are Markdown.

use vibank::examine::Examination;
use vibank::survey::{AnswerSurvey, Survey};
use vibank::unit::Decimal;

/// Prints a line for each item; of items that were named also their answers.
pub(crate) fn print(surveys: &[Survey], in_full: bool) {
    if surveys.is_empty() {
        return;
    }
    let head = [
        "item",
        "instances",
        "redrawn",
        "unfit",
        "routes agree to",
        "least tolerance",
        "3-figure work",
        "nearest mistake",
    ];
    table(&head, surveys.iter().map(of_item).collect());
    for survey in surveys
        .iter()
        .filter(|survey| in_full && !survey.answers.is_empty())
    {
        println!("\n{}\n", survey.item);
        let head = [
            "part",
            "from",
            "to",
            "unit",
            "least tolerance",
            "widest",
            "3-figure work",
            "nearest mistake",
        ];
        table(&head, survey.answers.iter().map(of_answer).collect());
    }
}

fn of_item(survey: &Survey) -> Vec<String> {
    let routes = survey.disagreement.as_ref();
    vec![
        survey.item.clone(),
        number(Some(survey.instances), 2),
        percent(Some(survey.redrawn)),
        percent(Some(survey.unfit)),
        number(routes.map(|routes| routes.share), 2),
        percent(survey.least(|answer| answer.tightest)),
        percent(survey.greatest(|answer| answer.work)),
        number(survey.least(|answer| answer.clearance), 2),
    ]
}

fn of_answer(answer: &AnswerSurvey) -> Vec<String> {
    vec![
        answer.part.clone(),
        number(answer.least, 3),
        number(answer.greatest, 3),
        answer.unit.clone(),
        percent(answer.tightest),
        percent(answer.widest),
        percent(answer.work),
        number(answer.clearance, 2),
    ]
}

/// A number in this many figures.
fn number(number: Option<f64>, figures: u32) -> String {
    match number {
        None => "–".to_owned(),
        Some(number) if number.fract() == 0.0 && number.abs() < 1e4 => number.to_string(),
        Some(number) => Decimal::rounded(number, figures)
            .map_or_else(|| number.to_string(), |decimal| decimal.to_string()),
    }
}

fn percent(share: Option<f64>) -> String {
    match share {
        None => "–".to_owned(),
        Some(share) => format!("{} %", number(Some(100.0 * share), 2)),
    }
}

/// Prints a table with columns of even width.
fn table(head: &[&str], rows: Vec<Vec<String>>) {
    let widths = (0..head.len()).map(|column| {
        let cells = rows.iter().map(|row| row[column].chars().count());
        cells
            .chain([head[column].chars().count()])
            .max()
            .unwrap_or(0)
    });
    let widths: Vec<usize> = widths.collect();
    let line = |cells: &[String]| {
        let cells = cells.iter().zip(&widths);
        let padded = cells.map(|(cell, width)| format!(" {cell:<width$} |"));
        format!("|{}", padded.collect::<String>())
    };
    let head: Vec<String> = head.iter().map(|&cell| cell.to_owned()).collect();
    println!("{}", line(&head));
    let rule = widths
        .iter()
        .map(|width| format!("{}|", "-".repeat(width + 2)));
    println!("|{}", rule.collect::<String>());
    for row in &rows {
        println!("{}", line(row));
    }
}

/// Prints for each part of some items how many wrong ways lead to it, and the exceptions of the items.
pub(crate) fn print_examined(examined: &[Examination]) {
    for item in examined {
        println!("\n{}, ways that lead elsewhere\n", item.item);
        let head = [
            "part",
            "wrong methods",
            "named mistakes",
            "draws of honest work",
        ];
        let rows = item.parts.iter().map(|part| {
            vec![
                part.part.clone(),
                part.methods.to_string(),
                part.mistakes.to_string(),
                part.honest.to_string(),
            ]
        });
        table(&head, rows.collect());
        for own in &item.allowed {
            let part = own.part.as_ref().map(|part| format!(" of part `{part}`"));
            println!(
                "\nexcepted: {}{}: {}",
                own.rule,
                part.unwrap_or_default(),
                own.reason
            );
        }
    }
}
