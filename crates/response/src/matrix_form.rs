//! Equations of motion in matrices, `[m1 0; 0 m2] [x1''; x2''] + [k -k; -k k] [x1; x2] = 0`, as one equation a row.

/// Most rows of a matrix.
const MAX_ROWS: usize = 6;
/// Most terms of an equation.
const MAX_TERMS: usize = 12;

/// The equations, one a row, that an equation of matrices and vectors is, parted by semicolons; nothing where it is none.
pub(crate) fn equations_of(text: &str) -> Option<String> {
    let sides = cut(text, |_, char| char == '=');
    let [left, right] = sides[..] else {
        return None;
    };
    let (left, right) = (terms(left)?, terms(right)?);
    let width = left.iter().chain(&right).find_map(Term::width)?;
    let has_matrix = left
        .iter()
        .chain(&right)
        .any(|term| matches!(term, Term::Product { .. }));
    let rows = |terms: &[Term]| -> Option<Vec<String>> {
        let rows = (0..width).map(|row| {
            let all: Option<Vec<String>> = terms.iter().map(|term| term.row(row, width)).collect();
            Some(all?.join(" + "))
        });
        rows.collect()
    };
    let (left, right) = (rows(&left)?, rows(&right)?);
    let equations = left.iter().zip(&right);
    let equations: Vec<String> = equations
        .map(|(left, right)| format!("{left} = {right}"))
        .collect();
    has_matrix.then(|| equations.join("; "))
}

/// A term with what multiplies it.
enum Term {
    Zero,
    Vector {
        factor: String,
        entries: Vec<String>,
    },
    Product {
        factor: String,
        rows: Vec<Vec<String>>,
        entries: Vec<String>,
    },
}

impl Term {
    fn width(&self) -> Option<usize> {
        match self {
            Self::Zero => None,
            Self::Vector { entries, .. } | Self::Product { entries, .. } => Some(entries.len()),
        }
    }

    /// A row of it, as a formula.
    fn row(&self, row: usize, width: usize) -> Option<String> {
        if self.width().is_some_and(|own| own != width) {
            return None;
        }
        Some(match self {
            Self::Zero => "0".to_owned(),
            Self::Vector { factor, entries } => format!("{factor}({})", entries.get(row)?),
            Self::Product {
                factor,
                rows,
                entries,
            } => {
                let pairs = rows.get(row)?.iter().zip(entries);
                let products: Vec<String> = pairs
                    .map(|(entry, unknown)| format!("({entry})*({unknown})"))
                    .collect();
                format!("{factor}({})", products.join(" + "))
            }
        })
    }
}

/// The terms of a side.
fn terms(side: &str) -> Option<Vec<Term>> {
    let side = side.trim();
    let mut found = Vec::new();
    let mut start = 0;
    let pieces = cut(side, |before, char| {
        matches!(char, '+' | '-') && !before.trim_end().ends_with(['*', '/', '^', '+', '-'])
    });
    for piece in pieces {
        let sign = side[..start].chars().next_back();
        start += piece.len() + 1;
        if piece.trim().is_empty() && found.is_empty() {
            continue;
        }
        let sign = if sign == Some('-') { "-" } else { "" };
        found.push(term(piece.trim(), sign)?);
    }
    (1..=MAX_TERMS).contains(&found.len()).then_some(found)
}

fn term(text: &str, sign: &str) -> Option<Term> {
    if text == "0" {
        return Some(Term::Zero);
    }
    let (mut factor, mut lists, mut rest) = (sign.to_owned(), Vec::new(), text);
    while let Some(open) = rest.find(['(', '[', '{']) {
        let end = open + group(&rest[open..])?;
        let rows = rows(&rest[open..end]);
        let before = rest[..open].trim();
        let is_scalar = rows.len() == 1 && rows[0].len() == 1;
        // What multiplies stands before.
        if !lists.is_empty() && (is_scalar || !matches!(before, "" | "*")) {
            return None;
        }
        if is_scalar {
            factor.push_str(&rest[..end]);
        } else {
            if lists.is_empty() {
                factor.push_str(&rest[..open]);
            }
            lists.push(rows);
        }
        rest = &rest[end..];
    }
    if !rest.trim().is_empty() {
        return None;
    }
    let factor = match factor.trim() {
        "" => String::new(),
        "-" => "-".to_owned(),
        own => format!("{}*", own.trim_end_matches(['*', ' '])),
    };
    let mut lists = lists.into_iter();
    match (lists.next(), lists.next(), lists.next()) {
        (Some(vector), None, None) => {
            let entries = entries(vector)?;
            Some(Term::Vector { factor, entries })
        }
        (Some(rows), Some(vector), None) => {
            let entries = entries(vector)?;
            let is_square =
                rows.len() == entries.len() && rows.iter().all(|row| row.len() == entries.len());
            is_square.then_some(Term::Product {
                factor,
                rows,
                entries,
            })
        }
        _ => None,
    }
}

/// The entries of a column or a row.
fn entries(rows: Vec<Vec<String>>) -> Option<Vec<String>> {
    let is_line = rows.len() == 1 || rows.iter().all(|row| row.len() == 1);
    let entries = rows.concat();
    (is_line && (2..=MAX_ROWS).contains(&entries.len())).then_some(entries)
}

/// The length of a bracket with what is in it.
fn group(text: &str) -> Option<usize> {
    let mut depth = 0_i32;
    for (at, char) in text.char_indices() {
        match char {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some(at + char.len_utf8());
        }
    }
    None
}

/// The rows of a list in brackets.
fn rows(list: &str) -> Vec<Vec<String>> {
    let inner = list[1..list.len() - 1].trim();
    let is_nested = inner.starts_with(['[', '{', '('])
        && group(inner).is_some_and(|end| {
            let behind = inner[end..].trim_start();
            behind.is_empty() || behind.starts_with([',', ';'])
        });
    if is_nested {
        let pieces = cut(inner, |_, char| matches!(char, ',' | ';'));
        let pieces = pieces.into_iter().map(str::trim);
        let are_groups = pieces
            .clone()
            .all(|piece| piece.starts_with(['[', '{', '(']) && group(piece) == Some(piece.len()));
        if are_groups {
            return pieces
                .map(|piece| row(&piece[1..piece.len() - 1]))
                .collect();
        }
    }
    let rows = cut(inner, |_, char| matches!(char, ';' | '\n')).into_iter();
    rows.filter(|piece| !piece.trim().is_empty())
        .map(row)
        .collect()
}

/// The entries of a row, parted by the first of these signs that stands in it.
fn row(text: &str) -> Vec<String> {
    for sign in ['&', ','] {
        let pieces = cut(text, |_, char| char == sign);
        if pieces.len() > 1 {
            return pieces.iter().map(|piece| piece.trim().to_owned()).collect();
        }
    }
    // A space parts entries unless a sign joins what stands around it.
    let text = text.trim();
    let mut pieces: Vec<String> = Vec::new();
    let mut joins = true;
    for piece in cut(text, |_, char| char == ' ') {
        if piece.is_empty() {
            continue;
        }
        let is_joined = joins || matches!(piece, "+" | "-" | "*" | "/");
        match pieces.last_mut().filter(|_| is_joined) {
            Some(last) => {
                last.push(' ');
                last.push_str(piece);
            }
            None => pieces.push(piece.to_owned()),
        }
        // `\ddot x` is one entry.
        joins = piece.ends_with(['+', '-', '*', '/', '^']) || piece.starts_with('\\');
    }
    pieces
}

/// The pieces of a text between signs outside of brackets; a sign is also recognized by what stands before it.
fn cut(text: &str, is_end: impl Fn(&str, char) -> bool) -> Vec<&str> {
    let (mut pieces, mut start, mut depth) = (Vec::new(), 0, 0_i32);
    for (at, char) in text.char_indices() {
        match char {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ if depth == 0 && is_end(&text[..at], char) => {
                pieces.push(&text[start..at]);
                start = at + char.len_utf8();
            }
            _ => {}
        }
    }
    pieces.push(&text[start..]);
    pieces
}

#[cfg(test)]
mod tests {
    use super::equations_of;

    #[test]
    fn matrices_and_vectors_are_equations_a_row() {
        for (typed, equations) in [
            (
                "[m1 0; 0 m2] [x1''; x2''] + [k -k; -k k] [x1; x2] = [0; 0]",
                "((m1)*(x1'') + (0)*(x2'')) + ((k)*(x1) + (-k)*(x2)) = (0); \
                 ((0)*(x1'') + (m2)*(x2'')) + ((-k)*(x1) + (k)*(x2)) = (0)",
            ),
            (
                "[[m1,0],[0,m2]]*[x1'',x2''] - k*[[1,-1],[-1,1]]*[x1,x2] = 0",
                "((m1)*(x1'') + (0)*(x2'')) + -k*((1)*(x1) + (-1)*(x2)) = 0; \
                 ((0)*(x1'') + (m2)*(x2'')) + -k*((-1)*(x1) + (1)*(x2)) = 0",
            ),
            (
                r"[m 0; 0 m][\ddot x; \ddot y] = 0",
                r"((m)*(\ddot x) + (0)*(\ddot y)) = 0; ((0)*(\ddot x) + (m)*(\ddot y)) = 0",
            ),
            (
                "(m+M & -k - c ; 0 & 1)(x ; y) = (F/2)(1 ; 0)",
                "((m+M)*(x) + (-k - c)*(y)) = (F/2)*(1); ((0)*(x) + (1)*(y)) = (F/2)*(0)",
            ),
        ] {
            assert_eq!(equations_of(typed).as_deref(), Some(equations), "{typed}");
        }
    }

    #[test]
    fn what_is_no_equation_of_matrices_stays() {
        for typed in [
            "m x'' + k x = 0",
            "m (x'' + y'') = 0",
            "M x'' + K x = 0",
            "[1 2; 3 4] [x; y]",
            "[1 2; 3 4] [x; y; z] = 0",
            "[1 2; 3 4] [x; y] + [1; 2; 3] = 0",
            "[x; y] = 0",
            "(1, 2) = (3, 4)",
            "[1 2; 3 4] [x; y] k = 0",
            "[1 2; 3 4 = 0",
        ] {
            assert_eq!(equations_of(typed), None, "{typed}");
        }
    }
}
