//! `qti`: content packages of QTI 2.1, 2.2 and 3.0, and the QTI 1.2 that Canvas reads.
//!
//! A package has an item for each question of each variant and a test with a section for each question, from which one
//! variant is drawn.

mod canvas;
mod item;
mod xml;

pub use canvas::Canvas;

use self::xml::Xml;
use super::held::Sorted;
use super::pictures::Pictures;
use super::words::QuestionWords;
use super::{Export, ExportTally, Wish};
use crate::course::archive;
use crate::worksheet::{Sheet, SheetQuestion};

/// A version of the standard with items as files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Version {
    /// QTI 2.1 (2012).
    V21,
    /// QTI 2.2 (2015).
    V22,
    /// QTI 3.0 (2022).
    V30,
}

impl Version {
    fn namespace(self) -> &'static str {
        match self {
            Self::V21 => "http://www.imsglobal.org/xsd/imsqti_v2p1",
            Self::V22 => "http://www.imsglobal.org/xsd/imsqti_v2p2",
            Self::V30 => "http://www.imsglobal.org/xsd/imsqtiasi_v3p0",
        }
    }

    /// Namespace and schema, as items name them.
    fn location(self) -> String {
        let schema = match self {
            Self::V21 => "http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd",
            Self::V22 => "http://www.imsglobal.org/xsd/qti/qtiv2p2/imsqti_v2p2.xsd",
            Self::V30 => {
                "https://purl.imsglobal.org/spec/qti/v3p0/schema/xsd/imsqti_asiv3p0_v1p0.xsd"
            }
        };
        format!("{} {schema}", self.namespace())
    }

    /// Namespace, name and version of packages.
    fn package(self) -> [&'static str; 3] {
        match self {
            Self::V21 => [
                "http://www.imsglobal.org/xsd/imscp_v1p1",
                "QTIv2.1 Package",
                "1.0.0",
            ],
            Self::V22 => [
                "http://www.imsglobal.org/xsd/imscp_v1p1",
                "QTIv2.2 Package",
                "1.0.0",
            ],
            Self::V30 => [
                "http://www.imsglobal.org/xsd/qti/qtiv3p0/imscp_v1p1",
                "QTI Package",
                "3.0.0",
            ],
        }
    }

    /// The type of a resource: an item or a test.
    fn resource(self, what: &str) -> String {
        let version = match self {
            Self::V21 => "v2p1",
            Self::V22 => "v2p2",
            Self::V30 => "v3p0",
        };
        format!("imsqti_{what}_xml{version}")
    }
}

/// A package while it is made.
pub struct Qti {
    wish: Wish,
    version: Version,
    tally: ExportTally,
    sections: Vec<Section>,
    items: Vec<Item>,
}

/// The variants of a question: those that are marked, and those that a person marks.
struct Section {
    title: String,
    marked: Vec<String>,
    essays: Vec<String>,
}

struct Item {
    identifier: String,
    xml: String,
    pictures: Pictures,
}

impl Qti {
    /// An empty package.
    pub fn new(wish: Wish, version: Version) -> Self {
        Self {
            wish,
            version,
            tally: ExportTally::default(),
            sections: Vec::new(),
            items: Vec::new(),
        }
    }

    /// The section that questions are added to.
    fn section(&mut self) -> &mut Section {
        if self.sections.is_empty() {
            self.category(&[]);
        }
        let last = self.sections.len() - 1;
        &mut self.sections[last]
    }

    fn item(&mut self, identifier: String, xml: String, pictures: Pictures) {
        self.tally.questions += 1;
        self.items.push(Item {
            identifier,
            xml,
            pictures,
        });
    }

    /// The test: one variant of each question.
    fn test(&self) -> String {
        let mut xml = Xml::new(self.version);
        let location = self.version.location();
        let attributes = [
            ("xmlns", self.version.namespace()),
            ("xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"),
            ("xsi:schemaLocation", &location),
            ("identifier", "test"),
            ("title", &self.wish.title),
        ];
        xml.open("assessmentTest", &attributes);
        let part = [
            ("identifier", "part"),
            ("navigationMode", "nonlinear"),
            ("submissionMode", "individual"),
        ];
        xml.open("testPart", &part);
        let lists = self
            .sections
            .iter()
            .flat_map(|section| [(section, &section.marked), (section, &section.essays)]);
        for (number, (section, items)) in lists.filter(|(_, list)| !list.is_empty()).enumerate() {
            let identifier = format!("section.{}", number + 1);
            let attributes = [
                ("identifier", identifier.as_str()),
                ("title", section.title.as_str()),
                ("visible", "true"),
            ];
            xml.open("assessmentSection", &attributes);
            xml.empty("selection", &[("select", "1")]);
            for item in items {
                let href = format!("{item}/item.xml");
                let attributes = [("identifier", item.as_str()), ("href", href.as_str())];
                xml.empty("assessmentItemRef", &attributes);
            }
            xml.close();
        }
        xml.close();
        xml.close();
        xml.out
    }

    fn manifest(&self) -> String {
        // Packages are not of the namespace whose names version 3 writes with hyphens.
        let mut xml = Xml::new(Version::V21);
        let [namespace, schema, version] = self.version.package();
        let attributes = [("xmlns", namespace), ("identifier", "vibank")];
        xml.open("manifest", &attributes);
        xml.open("metadata", &[]);
        xml.words("schema", &[], schema);
        xml.words("schemaversion", &[], version);
        xml.close();
        xml.empty("organizations", &[]);
        xml.open("resources", &[]);
        let kind = self.version.resource("test");
        let attributes = [
            ("identifier", "test"),
            ("type", &kind),
            ("href", "test.xml"),
        ];
        xml.open("resource", &attributes);
        xml.empty("file", &[("href", "test.xml")]);
        for item in &self.items {
            xml.empty("dependency", &[("identifierref", &item.identifier)]);
        }
        xml.close();
        let kind = self.version.resource("item");
        for item in &self.items {
            let href = format!("{}/item.xml", item.identifier);
            let attributes = [
                ("identifier", item.identifier.as_str()),
                ("type", kind.as_str()),
                ("href", href.as_str()),
            ];
            xml.open("resource", &attributes);
            xml.empty("file", &[("href", &href)]);
            for (name, _) in &item.pictures.files {
                let href = format!("{}/{name}", item.identifier);
                xml.empty("file", &[("href", &href)]);
            }
            xml.close();
        }
        xml.close();
        xml.close();
        xml.out
    }
}

impl Export for Qti {
    fn category(&mut self, path: &[&str]) {
        self.sections.push(Section {
            title: path.join(": "),
            marked: Vec::new(),
            essays: Vec::new(),
        });
    }

    fn add(&mut self, sheet: &Sheet<'_>, question: &SheetQuestion<'_>, number: usize) {
        let wish = self.wish.clone();
        let words = QuestionWords::of(sheet, question, number, &wish, "");
        let sorted = Sorted::of(&words.scene, question, &mut self.tally.unfit);
        let identifier = words.identifier();
        if !sorted.fit.is_empty() {
            self.tally.boxes += sorted
                .fit
                .iter()
                .map(|(_, held)| held.boxes())
                .sum::<usize>();
            let mut pictures = Pictures::default();
            let xml = item::marked(&words, &sorted, &identifier, self.version, &mut pictures);
            self.section().marked.push(identifier.clone());
            self.item(identifier.clone(), xml, pictures);
        }
        let parts = &sorted.essays(self.wish.has_essays);
        if !parts.is_empty() {
            let identifier = format!("{identifier}.essay");
            let mut pictures = Pictures::default();
            let xml = item::essay(&words, parts, &identifier, self.version, &mut pictures);
            self.section().essays.push(identifier.clone());
            self.item(identifier, xml, pictures);
        }
    }

    fn tally(&self) -> &ExportTally {
        &self.tally
    }

    fn finish(self: Box<Self>) -> std::io::Result<Vec<u8>> {
        let [manifest, test] = [self.manifest(), self.test()];
        let mut files = vec![
            ("imsmanifest.xml".to_owned(), manifest.as_bytes()),
            ("test.xml".to_owned(), test.as_bytes()),
        ];
        for item in &self.items {
            files.push((format!("{}/item.xml", item.identifier), item.xml.as_bytes()));
            for (name, svg) in &item.pictures.files {
                files.push((format!("{}/{name}", item.identifier), svg.as_bytes()));
            }
        }
        archive(files.iter().map(|(name, bytes)| (name.as_str(), *bytes)))
    }
}
