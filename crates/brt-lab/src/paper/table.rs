//! Tables: what an experiment measured, as it stands in its CSV file. Charts are drawn from them.
#![expect(clippy::disallowed_methods, reason = "digits of measured numbers")]

use crate::csv_text;

/// A table with named columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Table {
    /// Its file's name without `.csv`.
    pub(crate) name: &'static str,
    columns: Vec<&'static str>,
    rows: Vec<Vec<Cell>>,
}

/// A text or a number.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Cell {
    Text(String),
    Number(f64),
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<&String> for Cell {
    fn from(text: &String) -> Self {
        Self::Text(text.clone())
    }
}

impl From<f64> for Cell {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<u32> for Cell {
    fn from(number: u32) -> Self {
        Self::Number(f64::from(number))
    }
}

impl From<u64> for Cell {
    fn from(number: u64) -> Self {
        Self::Number(number as f64)
    }
}

impl From<usize> for Cell {
    fn from(number: usize) -> Self {
        Self::Number(number as f64)
    }
}

impl Cell {
    /// As it stands in the file.
    pub(crate) fn text(&self) -> String {
        match self {
            Self::Text(text) => text.clone(),
            Self::Number(number) => exact(*number),
        }
    }
}

/// Fields that must have these values.
pub(crate) type Where<'a> = &'a [(&'static str, &'a str)];

impl Table {
    pub(crate) fn new(name: &'static str, columns: &[&'static str]) -> Self {
        Self { name, columns: columns.to_vec(), rows: Vec::new() }
    }

    /// Adds a row: a cell for each column.
    pub(crate) fn push<const N: usize>(&mut self, row: [Cell; N]) {
        debug_assert_eq!(N, self.columns.len(), "{}", self.name);
        self.rows.push(row.into());
    }

    pub(crate) fn columns(&self) -> &[&'static str] {
        &self.columns
    }

    pub(crate) fn rows(&self) -> &[Vec<Cell>] {
        &self.rows
    }

    /// The rows with these fields.
    fn selected(&self, fields: Where) -> impl Iterator<Item = &Vec<Cell>> {
        let wanted: Vec<(Option<usize>, String)> =
            fields.iter().map(|(column, value)| (self.position(column), (*value).to_owned())).collect();
        self.rows.iter().filter(move |row| {
            wanted.iter().all(|(column, value)| column.is_some_and(|c| row[c].text() == *value))
        })
    }

    /// Numbers of two columns.
    pub(crate) fn points(&self, fields: Where, x: &str, y: &str) -> Vec<(f64, f64)> {
        let (Some(x), Some(y)) = (self.position(x), self.position(y)) else { return Vec::new() };
        self.selected(fields)
            .filter_map(|row| match (&row[x], &row[y]) {
                (Cell::Number(x), Cell::Number(y)) => Some((*x, *y)),
                _ => None,
            })
            .collect()
    }

    /// The number in the first row with these fields.
    pub(crate) fn number(&self, fields: Where, column: &str) -> Option<f64> {
        self.points(fields, column, column).first().map(|p| p.0)
    }

    fn position(&self, column: &str) -> Option<usize> {
        self.columns.iter().position(|c| *c == column)
    }

    /// The file.
    pub(crate) fn csv(&self) -> String {
        let columns = self.columns.iter().map(|&column| column.to_owned()).collect();
        let rows = self.rows.iter().map(|row| row.iter().map(Cell::text).collect());
        csv_text::lines(std::iter::once::<Vec<String>>(columns).chain(rows))
    }
}

/// A number to six significant digits, without an exponent.
pub(crate) fn exact(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 { "0".to_owned() } else { value.to_string() };
    }
    let decimals = (5 - value.abs().log10().floor() as i32).clamp(0, 12) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> Table {
        let mut table = Table::new("t", &["scene", "size", "seconds"]);
        for (scene, size, seconds) in [("A", 128_u32, 0.5), ("B", 128, 1.0), ("A", 256, 2.0)] {
            table.push([scene.into(), size.into(), seconds.into()]);
        }
        table
    }

    #[test]
    fn points_are_selected_by_text_and_number() {
        assert_eq!(table().points(&[("scene", "A")], "size", "seconds"), [(128.0, 0.5), (256.0, 2.0)]);
        assert_eq!(table().number(&[("scene", "A"), ("size", "256")], "seconds"), Some(2.0));
        assert_eq!(table().number(&[("scene", "Z")], "seconds"), None);
        assert_eq!(table().points(&[("none", "A")], "size", "seconds"), []);
    }

    #[test]
    fn files_quote_what_needs_quoting_and_round_to_six_digits() {
        let mut table = Table::new("t", &["a", "b"]);
        table.push(["x, \"y\"".into(), (1.0 / 3.0).into()]);
        assert_eq!(table.csv(), "a,b\n\"x, \"\"y\"\"\",0.333333\n");
        assert_eq!(
            [exact(1_234_567.0), exact(1.5), exact(0.000_012_345_67)],
            ["1234567", "1.5", "0.0000123457"]
        );
    }
}
