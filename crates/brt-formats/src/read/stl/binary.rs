//! The binary form: a head of 80 bytes, the number of triangles, and 50 bytes for each.

use brt_geometry::vec3;

use super::Solid;
use crate::import::{Draft, Stop, fault};

const HEAD: usize = 84;
const TRIANGLE: usize = 50;

/// Is the size that of a binary file with as many triangles as it says?
pub(crate) fn is_binary(bytes: &[u8]) -> bool {
    count(bytes).is_some_and(|n| n > 0 && bytes.len() as u64 == HEAD as u64 + n * TRIANGLE as u64)
}

fn count(bytes: &[u8]) -> Option<u64> {
    let count = bytes.get(80..HEAD)?;
    Some(u64::from(u32::from_le_bytes(count.try_into().ok()?)))
}

pub(super) fn read(bytes: &[u8], draft: &mut Draft) -> Result<(), Stop> {
    let Some(count) = count(bytes) else {
        let found =
            if bytes.len() == 1 { "1 byte is".to_owned() } else { format!("{} bytes are", bytes.len()) };
        let message =
            format!("{found} too few for a binary STL (at least {HEAD}), and it does not begin with `solid`");
        return Err(fault(message, None));
    };
    let body = &bytes[HEAD..];
    let whole = (body.len() / TRIANGLE) as u64;
    if whole < count {
        let message = format!("the file ends after {whole} of {count} triangles");
        return Err(fault(message, None));
    }
    draft.expect(0, count as usize)?;
    let mut solid = Solid {
        triangles: draft.budget.list(count as usize, || "the triangles".to_owned())?,
        ..Solid::default()
    };
    let after = body.len() as u64 - count * TRIANGLE as u64;
    draft.notices.note_many("bytes after the last triangle ignored", after, format!("triangle {count}"));
    let mut attributes = 0;
    for record in body.chunks_exact(TRIANGLE).take(count as usize) {
        draft.budget.go_on()?;
        solid.triangles.push([12, 24, 36].map(|at| {
            let coordinate = |i: usize| {
                let b = &record[at + 4 * i..at + 4 * i + 4];
                f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]]))
            };
            solid.weld.point(vec3(coordinate(0), coordinate(1), coordinate(2)))
        }));
        attributes += u64::from(record[48..50] != [0, 0]);
    }
    draft.notices.note_many(
        "triangle attributes (perhaps colours) ignored",
        attributes,
        "the triangles".to_owned(),
    );
    solid.add_to(draft)
}
