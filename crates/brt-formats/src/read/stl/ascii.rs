//! The text form: `solid … facet … vertex x y z … endsolid`, any number of times.

use super::Solid;
use crate::common::{Word, Words};
use crate::import::{Draft, Stop, fault};

pub(super) fn read(bytes: &[u8], draft: &mut Draft) -> Result<(), Stop> {
    let mut words = Words::new(bytes);
    while let Some(word) = words.next() {
        if !word.is("solid") {
            return Err(unexpected(&word, "`solid`"));
        }
        read_solid(&mut words, draft)?;
    }
    Ok(())
}

fn read_solid(words: &mut Words, draft: &mut Draft) -> Result<(), Stop> {
    let name = String::from_utf8_lossy(words.rest_of_line()).trim().to_owned();
    let mut solid = Solid { name: (!name.is_empty()).then_some(name), ..Solid::default() };
    let mut corners = Vec::new();
    loop {
        let Some(word) = words.next() else {
            return Err(fault("the file ends within a solid", None));
        };
        match &word.bytes.to_ascii_lowercase()[..] {
            b"vertex" => corners.push(solid.weld.point(words.vector("a point, `vertex x y z`")?)),
            b"endloop" => {
                let &[a, b, c] = &corners[..] else {
                    let message = format!("a facet needs 3 points, found {}", corners.len());
                    return Err(fault(message, Some(word.span)));
                };
                draft.expect(0, 1)?;
                solid.triangles.push([a, b, c]);
                corners.clear();
            }
            // Numbers of the normal are words that mean nothing here.
            b"facet" | b"endfacet" | b"outer" | b"loop" | b"normal" => {}
            b"endsolid" => break,
            _ if word.is_number() => {}
            _ => return Err(unexpected(&word, "`facet`, `vertex` or `endsolid`")),
        }
    }
    words.rest_of_line();
    solid.add_to(draft)
}

fn unexpected(word: &Word, expected: &str) -> Stop {
    fault(format!("found `{}`, expected {expected}", word.excerpt()), Some(word.span.clone()))
}
