//! Everything that was measured: tables, and the named numbers that verdicts and sentences are made of.

use super::table::{Table, Where, exact};

/// Tables and numbers.
#[derive(Clone, Debug, Default)]
pub(crate) struct Findings {
    pub(crate) tables: Vec<Table>,
    pub(crate) numbers: Vec<Number>,
    /// What was left out, and why.
    pub(crate) remarks: Vec<String>,
}

/// A number that follows from a table.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Number {
    pub(crate) name: String,
    pub(crate) value: f64,
    /// The table's name.
    pub(crate) table: &'static str,
}

impl Findings {
    pub(crate) fn add(&mut self, table: Table) {
        self.tables.push(table);
    }

    /// Names a number; nothing if there is none.
    pub(crate) fn note(&mut self, table: &'static str, name: impl Into<String>, value: Option<f64>) {
        if let Some(value) = value.filter(|v| v.is_finite()) {
            self.numbers.push(Number { name: name.into(), value, table });
        }
    }

    pub(crate) fn number(&self, name: &str) -> Option<f64> {
        self.numbers.iter().find(|n| n.name == name).map(|n| n.value)
    }

    /// A number for the page, tied to its name so that a test can look it up.
    pub(crate) fn show(&self, name: &str, decimals: usize) -> String {
        match self.number(name) {
            Some(value) => data(name, value, decimals),
            None => "–".to_owned(),
        }
    }

    /// Is any of these numbers known?
    pub(crate) fn knows_any(&self, names: &[String]) -> bool {
        names.iter().any(|name| self.number(name).is_some())
    }

    /// The least and the greatest of some numbers for the page, as "a to b".
    pub(crate) fn show_range(&self, names: &[String], decimals: usize) -> String {
        let mut found: Vec<(&String, f64)> =
            names.iter().filter_map(|n| self.number(n).map(|v| (n, v))).collect();
        found.sort_by(|a, b| a.1.total_cmp(&b.1));
        match found[..] {
            [] => "–".to_owned(),
            [(name, value)] => data(name, value, decimals),
            [(low, a), .., (_, b)] if format!("{a:.decimals$}") == format!("{b:.decimals$}") => {
                data(low, a, decimals)
            }
            [(low, a), .., (high, b)] => format!("{} to {}", data(low, a, decimals), data(high, b, decimals)),
        }
    }

    /// The numbers as a table.
    pub(crate) fn numbers_table(&self) -> Table {
        let mut table = Table::new("numbers", &["name", "value", "table"]);
        for number in &self.numbers {
            table.push([(&number.name).into(), number.value.into(), number.table.into()]);
        }
        table
    }

    /// Points of a table, for charts and fits.
    pub(crate) fn points(&self, table: &'static str, fields: Where, x: &str, y: &str) -> Vec<(f64, f64)> {
        self.tables.iter().find(|t| t.name == table).map_or(Vec::new(), |t| t.points(fields, x, y))
    }
}

fn data(name: &str, value: f64, decimals: usize) -> String {
    format!("<data data-number=\"{name}\" value=\"{}\">{value:.decimals$}</data>", exact(value))
}

/// A sentence of the page without its elements.
pub(crate) fn without_elements(html: &str) -> String {
    let mut text = String::new();
    let mut inside = false;
    for c in html.chars() {
        match c {
            '<' => inside = true,
            '>' => inside = false,
            c if !inside => text.push(c),
            _ => {}
        }
    }
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_on_the_page_are_tied_to_their_names() {
        let mut findings = Findings::default();
        findings.note("fig1", "exponent/A", Some(1.987_654_321));
        findings.note("fig1", "exponent/B", None);
        assert_eq!(
            findings.show("exponent/A", 2),
            "<data data-number=\"exponent/A\" value=\"1.98765\">1.99</data>"
        );
        assert_eq!(findings.show("exponent/B", 2), "–");
        assert_eq!(findings.numbers_table().csv(), "name,value,table\nexponent/A,1.98765,fig1\n");
        assert_eq!(without_elements(&findings.show("exponent/A", 1)), "2.0");
    }
}
