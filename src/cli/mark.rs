//! `vibank mark`

use clap::builder::{PossibleValuesParser, TypedValueParser};
use serde_json::{Map, Value as Json};
use vibank::answer::{Doubt, Verdict};
use vibank::grade::request::{self, MarkRequest};
use vibank::solution::Session;
use vibank::unit::DecimalMark;

use super::bank::BankArgument;
use super::doubt::doubt;
use super::{Failure, Outcome, lines, solve};

/// Mark one response, or those of a script.
///
/// Example: vibank mark ch2/e8-springs-parallel-series k_par "k2 + k1"
///
/// Example: vibank mark ch4/p3-base-excited-relative omega_n "1.095 rad/s" --earlier "k_eq=k1*k2/(k1 + k2)"
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The id of the item, such as ch2/e8-springs-parallel-series.
    #[arg(required_unless_present = "jsonl")]
    item: Option<String>,
    /// The id of the part, such as k_par.
    #[arg(required_unless_present = "jsonl")]
    part: Option<String>,
    /// What was answered.
    #[arg(required_unless_present = "jsonl", allow_hyphen_values = true)]
    response: Option<String>,
    /// A value for a parameter, such as m=2kg.
    #[arg(long = "set", value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// What was answered to an earlier part: a wrong answer is followed through.
    ///
    /// What follows rightly from a wrong earlier answer is right. May be given for each part; equations of motion
    /// that are asked one by one are marked together.
    #[arg(long, value_name = "PART=RESPONSE")]
    earlier: Vec<String>,
    /// Draw what is not set from this seed.
    #[arg(short, long)]
    seed: Option<u64>,
    /// What becomes of a response with two readings of which one is right: it is asked back, or the right one counts
    /// as on paper, or it is left to the teacher.
    #[arg(long, value_name = "POLICY", default_value = "ask", value_parser = doubt())]
    doubt: Doubt,
    /// The decimal sign of whoever answers; with a comma, `1,250` has one reading.
    #[arg(long, value_name = "SIGN", default_value = ".", value_parser = decimal())]
    decimal: DecimalMark,
    /// Print JSON.
    #[arg(long)]
    json: bool,
    /// Read requests from standard input, one JSON object a line.
    #[arg(long, conflicts_with_all = ["item", "part", "response", "set", "earlier", "seed", "doubt", "decimal"])]
    jsonl: bool,
    #[command(flatten)]
    bank: BankArgument,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let catalogue = arguments.bank.catalogue()?;
    let mut session = Session::new(&catalogue);
    if arguments.jsonl {
        return lines::answer(|line| request::answer(&mut session, line));
    }
    let request = MarkRequest {
        id: arguments.item.clone().unwrap_or_default(),
        set: solve::settings(&arguments.set)?,
        seed: arguments.seed,
        part: arguments.part.clone().unwrap_or_default(),
        response: arguments.response.clone().unwrap_or_default(),
        earlier: earlier(&arguments.earlier)?,
        doubt: arguments.doubt,
        decimal: arguments.decimal,
        tag: None,
    };
    let reply = request::reply(&mut session, request);
    let marked = match &reply.outcome {
        request::MarkOutcome::Marked(marked) => marked,
        request::MarkOutcome::Refused { error } => {
            return Err(Failure::new(error.message.as_str()));
        }
    };
    if arguments.json {
        let text = serde_json::to_string(&reply).expect("a reply is plain data");
        println!("{text}");
    } else {
        println!(
            "{}, credit {}",
            marked.verdict.name(),
            Json::from(marked.credit.share().to_f64())
        );
        // In the letters of the sheet, which an item may have other names for.
        if let Some(reading) = &marked.reading {
            println!("read as {}", reading.plain());
        }
        for remark in &marked.feedback {
            println!("{}", remark.plain());
        }
    }
    Ok(match marked.verdict {
        Verdict::Right => Outcome::Done,
        _ => Outcome::Findings,
    })
}

/// Reads a decimal sign.
fn decimal() -> impl TypedValueParser<Value = DecimalMark> {
    let of_text = |sign: String| sign.chars().find_map(DecimalMark::of_char);
    PossibleValuesParser::new([".", ","]).map(move |sign| of_text(sign).unwrap_or_default())
}

/// Answers to earlier parts, by part.
fn earlier(given: &[String]) -> Result<Map<String, Json>, Failure> {
    given
        .iter()
        .map(|text| {
            let (part, response) = text.split_once('=').ok_or_else(|| {
                Failure::new(format!("`{text}` is not an answer to a part"))
                    .help("write the part, an equals sign and the answer, as in `k_eq=4 N/m`")
            })?;
            Ok((part.trim().to_owned(), Json::from(response.trim())))
        })
        .collect()
}
