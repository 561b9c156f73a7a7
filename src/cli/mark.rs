//! `vibank mark`

use serde_json::{Value as Json, json};
use vibank::grade::request;

use super::bank::BankArgument;
use super::{Failure, Outcome, lines, solve};

/// Mark one response, or those of a script.
///
/// Example: vibank mark ch2/e8-springs-parallel-series k_par "k2 + k1"
///
/// Example: vibank mark ch4/p3-base-excited-relative omega_n "1.095 rad/s" --earlier "k_eq=k1*k2/(k1 + k2)"
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The item.
    #[arg(required_unless_present = "jsonl")]
    item: Option<String>,
    /// The part.
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
    #[arg(long)]
    seed: Option<u64>,
    /// Print JSON.
    #[arg(long)]
    json: bool,
    /// Read requests from standard input, one JSON object a line.
    #[arg(long, conflicts_with_all = ["item", "part", "response", "set", "earlier", "seed"])]
    jsonl: bool,
    #[command(flatten)]
    bank: BankArgument,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let catalogue = arguments.bank.catalogue()?;
    if arguments.jsonl {
        return lines::answer(|line| request::answer(&catalogue, line));
    }
    let line = json!({
        "id": arguments.item,
        "part": arguments.part,
        "response": arguments.response,
        "set": solve::settings(&arguments.set)?,
        "earlier": earlier(&arguments.earlier)?,
        "seed": arguments.seed,
    });
    let reply = request::answer(&catalogue, &line.to_string());
    let value: Json = serde_json::from_str(&reply).expect("the reply is JSON");
    if let Some(error) = value.get("error") {
        return Err(Failure::new(error["message"].as_str().unwrap_or_default()));
    }
    if arguments.json {
        println!("{reply}");
    } else {
        println!(
            "{}, credit {}",
            value["verdict"].as_str().unwrap_or_default(),
            value["credit"]
        );
        if let Some(text) = value["text"].as_str() {
            println!("read as {text}");
        }
        for feedback in value["feedback"].as_array().into_iter().flatten() {
            println!("{}", feedback.as_str().unwrap_or_default());
        }
    }
    Ok(if value["verdict"] == "right" {
        Outcome::Done
    } else {
        Outcome::Findings
    })
}

/// Answers to earlier parts, by part.
fn earlier(given: &[String]) -> Result<Json, Failure> {
    let pair = |text: &String| {
        let (part, response) = text.split_once('=').ok_or_else(|| {
            Failure::new(format!("`{text}` is no answer to a part"))
                .help("write the part, an equals sign and the answer, as in `k_eq=4 N/m`")
        })?;
        Ok((part.trim().to_owned(), Json::from(response.trim())))
    };
    given
        .iter()
        .map(pair)
        .collect::<Result<_, _>>()
        .map(Json::Object)
}
