//! Lines of text files with commas.

use csv::WriterBuilder;

/// Lines of fields, those in quotation marks that need them.
pub(crate) fn lines<F: AsRef<[u8]>>(lines: impl IntoIterator<Item = impl IntoIterator<Item = F>>) -> String {
    let mut writer = WriterBuilder::new().flexible(true).from_writer(Vec::new());
    for line in lines {
        // Writing to memory cannot fail.
        let _ = writer.write_record(line);
    }
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_are_quoted_that_need_it() {
        assert_eq!(lines([vec!["a", "b"], vec!["x, \"y\"", ""]]), "a,b\n\"x, \"\"y\"\"\",\n");
    }
}
