//! The pages of a marking run: the feedback on each sheet and the report.

use vibank::grade::Feedback;
use vibank::output::{self, Pages, Run};
use vibank::worksheet::Student;

use super::manifest::Sheets;
use crate::cli::faces::Faces;
use crate::cli::press::{Missing, Press, Printed};
use crate::cli::{Failure, Outcome};

/// What fills the pages, with what stands before and after each.
pub(crate) struct Layout {
    pub(crate) pages: Pages,
    press: Option<Press>,
    /// Why nothing can be printed, where the format needs it.
    pub(crate) missing: Option<Missing>,
    /// Files of fonts for names.
    fonts: Vec<String>,
    pub(crate) begin: String,
    pub(crate) end: String,
}

impl Layout {
    /// How pages are written in a format, for these students.
    pub(crate) fn of(sheets: &Sheets, format: &str, students: &[Student]) -> Result<Self, Failure> {
        let writer = output::writer(format).ok_or_else(|| Failure::unknown_format(format, &[]))?;
        let head = &sheets.head;
        let faces = if writer.is_bound() {
            Faces::of(students, None)?
        } else {
            Faces::default()
        };
        if let Some(line) = faces.remark() {
            eprintln!("warning: {line}");
        }
        let run = Run::plain(&head.title, &head.language, head.decimal)
            .with_paper(head.paper)
            .with_names(faces.names);
        let pages = Pages::new(writer, run, &[]).map_err(Failure::of)?;
        let (press, missing) = match writer.is_bound().then(Press::find) {
            Some(Ok(press)) => (Some(press), None),
            Some(Err(missing)) => (None, Some(missing)),
            None => (None, None),
        };
        Ok(Self {
            begin: pages
                .begin(pages.feedback_subtitle())
                .map_err(Failure::of)?,
            end: pages.end().map_err(Failure::of)?,
            fonts: faces.paths,
            press,
            missing,
            pages,
        })
    }

    /// The file with the feedback on a sheet, or why it could not be printed.
    pub(crate) fn file(&self, feedback: &Feedback) -> Result<Printed, Failure> {
        let page = output::feedback_page(&self.pages, feedback);
        let page = page.map_err(Failure::of)?;
        let text = format!("{}{page}{}", self.begin, self.end);
        Ok(match &self.press {
            Some(press) => press.page(text, &self.fonts),
            None => Ok(text.into_bytes()),
        })
    }

    /// Reports the pages that could not be printed, and says how the run ends with them.
    pub(crate) fn ending(&self, unprinted: &[String]) -> Outcome {
        for line in unprinted {
            eprintln!("error: {line}");
        }
        if let Some(missing) = &self.missing {
            let failure = missing.failure("feedback pages as PDF");
            eprintln!("{}", failure.to_string().trim_end());
        }
        if unprinted.is_empty() && self.missing.is_none() {
            Outcome::Done
        } else {
            Outcome::Unprinted
        }
    }
}
