//! `vibank solve`

use serde_json::{Map, Value as Json, json};
use vibank::solution::request::{self, Request};

use super::bank::BankArgument;
use super::{Failure, Outcome, lines};

/// Solve an item for given data, or requests of a script.
///
/// Example: vibank solve ch4/p1-rolling-disk-hub-moment --set m=2kg --set "r=12.5 cm" --json
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The item.
    #[arg(required_unless_present = "jsonl")]
    item: Option<String>,
    /// A value for a parameter, such as m=2kg; a bare number is in SI units.
    #[arg(long = "set", value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Draw what is not set from this seed.
    #[arg(long)]
    seed: Option<u64>,
    /// A time in seconds, for functions of time.
    #[arg(long = "at", value_name = "SECONDS")]
    at: Vec<String>,
    /// An answer that is wanted; all without any.
    #[arg(long = "want", value_name = "ANSWER")]
    want: Vec<String>,
    /// Print JSON.
    #[arg(long)]
    json: bool,
    /// Read requests from standard input, one JSON object a line.
    #[arg(long, conflicts_with_all = ["item", "set", "seed", "at", "want"])]
    jsonl: bool,
    /// Print what was computed and what was not.
    #[arg(long)]
    trace: bool,
    #[command(flatten)]
    bank: BankArgument,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let catalogue = arguments.bank.catalogue()?;
    if arguments.jsonl {
        return lines::answer(|line| request::answer(&catalogue, line));
    }
    let request = Request {
        id: arguments.item.clone().unwrap_or_default(),
        set: settings(&arguments.set)?,
        seed: arguments.seed,
        at: arguments
            .at
            .iter()
            .map(|time| Json::String(time.clone()))
            .collect(),
        want: (!arguments.want.is_empty()).then(|| arguments.want.clone()),
        tag: None,
    };
    let (reply, trace) = request::reply_traced(&catalogue, &request);
    if arguments.json {
        println!("{}", Json::Object(reply.clone()));
    }
    if let Some(error) = reply.get("error") {
        let message = error
            .get("message")
            .and_then(Json::as_str)
            .unwrap_or_default();
        return if arguments.json {
            Ok(Outcome::Findings)
        } else {
            Err(Failure::new(message))
        };
    }
    if !arguments.json {
        print(&reply);
    }
    if let Some(trace) = trace.filter(|_| arguments.trace) {
        eprintln!("computed: {}", trace.computed.join(", "));
        eprintln!("skipped:  {}", trace.skipped.join(", "));
    }
    Ok(Outcome::Done)
}

/// `name=value` pairs.
pub(crate) fn settings(pairs: &[String]) -> Result<Map<String, Json>, Failure> {
    let pair =
        |pair: &String| match pair.split_once('=') {
            Some((name, value)) => Ok((name.trim().to_owned(), json!(value.trim()))),
            None => Err(Failure::new(format!("`{pair}` sets nothing"))
                .help("write for example `--set m=2kg`")),
        };
    pairs.iter().map(pair).collect()
}

fn print(reply: &Map<String, Json>) {
    let objects = |key: &str| {
        reply
            .get(key)
            .and_then(Json::as_object)
            .cloned()
            .unwrap_or_default()
    };
    println!("{}\n\ngiven", reply["id"].as_str().unwrap_or_default());
    for (name, value) in objects("parameters") {
        println!("  {name:<12} {} {}", value["value"], unit(&value["unit"]));
    }
    println!("\nanswers");
    for (id, entry) in objects("answers") {
        let shown = match (entry.get("si"), entry.get("value"), entry.get("text")) {
            (Some(Json::Null), ..) => format!("– {}", entry["reason"].as_str().unwrap_or_default()),
            (Some(si), ..) => format!("{si} {}", unit(&entry["unit"])),
            (_, Some(Json::String(value)), _) | (_, _, Some(Json::String(value))) => value.clone(),
            (_, Some(value), _) => value.to_string(),
            _ => String::new(),
        };
        println!("  {id:<12} {shown}");
    }
}

fn unit(unit: &Json) -> String {
    match unit {
        Json::String(unit) if unit == "1" => String::new(),
        Json::String(unit) => unit.clone(),
        Json::Null => String::new(),
        other => other.to_string(),
    }
}
