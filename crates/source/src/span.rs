use std::ops::Range;

/// A range of bytes in a text, `start..end`.
///
/// Two spans are compared as ranges; a [`Span::NONE`] marks what was not written by anybody.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Span {
    /// The span of something derived, which stands nowhere.
    pub const NONE: Self = Self {
        start: u32::MAX,
        end: u32::MAX,
    };

    /// The span of the bytes `start..end`.
    ///
    /// ```
    /// use vibank_source::Span;
    /// assert_eq!(&"m*x''"[Span::new(2, 5).range()], "x''");
    /// ```
    pub fn new(start: usize, end: usize) -> Self {
        Self {
            start: start as u32,
            end: end as u32,
        }
    }

    /// Whether this is the span of something derived.
    pub fn is_none(self) -> bool {
        self == Self::NONE
    }

    /// The smallest span that holds both; what stands nowhere does not count.
    #[must_use]
    pub fn join(self, other: Self) -> Self {
        if self.is_none() {
            return other;
        }
        if other.is_none() {
            return self;
        }
        Self {
            start: self.start.min(other.start),
            end: self.end.max(other.end),
        }
    }

    /// The same span in a text that begins `offset` bytes further on.
    #[must_use]
    pub fn shifted(self, offset: usize) -> Self {
        if self.is_none() {
            return self;
        }
        Self {
            start: self.start + offset as u32,
            end: self.end + offset as u32,
        }
    }

    /// As a range of bytes, to slice with.
    pub fn range(self) -> Range<usize> {
        self.start as usize..self.end as usize
    }
}

impl From<Range<usize>> for Span {
    fn from(range: Range<usize>) -> Self {
        Self::new(range.start, range.end)
    }
}
