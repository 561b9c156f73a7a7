//! A page in a course: which package it is, which data a learner has, what answers are worth.
//!
//! The platform knows who learns; a package knows what is asked. From both follow the data, the same at every visit, so
//! that no state has to hold them: [`first_variant`] is the number from which a variant is looked for. The page computes
//! the same (`templates/page/scorm.js`).

#[cfg(feature = "render")]
mod archive;
mod state;

use serde::Serialize;
use sha2::{Digest, Sha256};

use crate::bank::Compiled;
use crate::seed::Variant;
use crate::worksheet::{Practice, Rules, Weighed};

#[cfg(feature = "render")]
pub use archive::archive;
pub use state::{NoRoom, Room};

/// What a package is: its identity, its questions and its rules. Its JSON is what the page reads, and `vibank.json` in
/// the package.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Package {
    /// What it is known by; the same for a package that is made anew.
    pub id: String,
    /// Of the questions and the revisions of their items: where it is another, old answers belong to other questions.
    pub digest: String,
    /// Attempts, feedback, worked solutions, and the share with which the package is passed.
    #[serde(flatten)]
    pub rules: Rules,
    /// The questions in the order of the page.
    pub questions: Vec<Asked>,
}

/// A question of a package.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Asked {
    /// By what it is known.
    pub key: String,
    /// The text of its item.
    pub revision: String,
    /// The parts that are asked, in their order.
    pub parts: Vec<Weighed>,
}

impl Package {
    /// The package of a practice; `seed` parts those of one title.
    pub fn of(practice: &Practice, items: &[Compiled], rules: &Rules, seed: u64) -> Self {
        let questions: Vec<Asked> = practice
            .questions
            .iter()
            .map(|question| Asked {
                key: question.key(),
                revision: items[question.place].revision.to_string(),
                parts: question.weights.clone(),
            })
            .collect();
        let mut content = Sha256::new();
        content.update([practice.decimal as u8]);
        for (asked, question) in questions.iter().zip(&practice.questions) {
            content.update(format!("{}\n{}\n", asked.key, asked.revision));
            for (name, value) in &question.set {
                content.update(format!("{name}={value}\n"));
            }
            for part in &asked.parts {
                content.update(format!("{}\n", part.id));
            }
        }
        let name = Sha256::digest(format!("{}\n{seed}", practice.title));
        Self {
            id: rules.id.clone().unwrap_or_else(|| hexadecimal(&name[..6])),
            digest: hexadecimal(&content.finalize()[..4]),
            rules: rules.clone(),
            questions,
        }
    }

    /// How many parts its questions have.
    pub fn parts(&self) -> usize {
        self.questions.iter().map(|asked| asked.parts.len()).sum()
    }
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The number from which the variant of a learner's question is looked for.
///
/// FNV-1a of 64 bits over package, question and learner, one a line, with the finalizer of SplitMix64 (Steele, Lea and
/// Flood 2014), of which the upper 40 bits are taken. It spreads learners over variants; it keeps nothing secret, since
/// a page can compute its keys anyway. A browser computes it without a context that it takes for safe.
///
/// ```
/// use vibank::course::first_variant;
/// let number = first_variant("week-3", "ch3/e5-log-decrement", "4711");
/// assert!(number < vibank::seed::Variant::COUNT);
/// assert_ne!(number, first_variant("week-3", "ch3/e5-log-decrement", "4712"));
/// ```
pub fn first_variant(package: &str, question: &str, learner: &str) -> u64 {
    let text = format!("{package}\n{question}\n{learner}");
    let hash = text.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    });
    let hash = (hash ^ (hash >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let hash = (hash ^ (hash >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (hash ^ (hash >> 31)) >> (64 - Variant::COUNT.ilog2())
}
