//! Fields of lines of text files with commas.

/// A field as it stands in a line.
pub(super) fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

/// The fields of a line; `None` if quotation marks are out of place.
pub(super) fn fields(line: &str) -> Option<Vec<String>> {
    let mut fields = Vec::new();
    let mut rest = line;
    loop {
        let (field, after) = match rest.strip_prefix('"') {
            Some(inside) => unquoted(inside)?,
            None => {
                let end = rest.find(',').unwrap_or(rest.len());
                let (field, after) = rest.split_at(end);
                (field.to_owned(), after)
            }
        };
        fields.push(field);
        match after.strip_prefix(',') {
            Some(next) => rest = next,
            None => return after.is_empty().then_some(fields),
        }
    }
}

/// What stands before the closing mark, two of which are one mark of the text, and what follows it.
fn unquoted(mut rest: &str) -> Option<(String, &str)> {
    let mut field = String::new();
    loop {
        let (part, after) = rest.split_once('"')?;
        field.push_str(part);
        match after.strip_prefix('"') {
            Some(next) => {
                field.push('"');
                rest = next;
            }
            None => return Some((field, after)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_written_is_read() {
        for texts in [vec![""], vec!["a", "b c", ""], vec!["a,b", "say \"a\"", "\"", ",", "ü"]] {
            let line: Vec<String> = texts.iter().map(|text| quoted(text)).collect();
            assert_eq!(fields(&line.join(",")).unwrap(), texts);
        }
    }

    #[test]
    fn marks_out_of_place_are_found() {
        for line in ["\"a", "\"a\"b", "\"a\"\"", "\""] {
            assert_eq!(fields(line), None, "{line}");
        }
    }
}
