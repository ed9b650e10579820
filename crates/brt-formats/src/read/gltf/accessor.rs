//! Numbers in buffers, with every position checked.

use gltf::Accessor;
use gltf::accessor::DataType;
use gltf::buffer::View;

use super::buffers::Buffers;
use crate::import::{Stop, fault};

/// Rows that no bytes of the file stand for: a few words in a hostile file must not fill the memory.
const MOST_ZEROS: usize = 1 << 20;

/// Rows of N numbers, as floats; normalised integers are from 0 (or −1) to 1.
pub(super) fn rows<const N: usize>(accessor: &Accessor, buffers: &Buffers) -> Result<Vec<[f64; N]>, Stop> {
    let kind = accessor.data_type();
    let components = accessor.dimensions().multiplicity();
    if components < N {
        return Err(at(accessor, &format!("has {components} numbers a row, expected {N}")));
    }
    let scale = if accessor.normalized() { 1.0 / greatest(kind) } else { 1.0 };
    let size = kind.size();
    let row = |bytes: &[u8]| {
        std::array::from_fn(|i| clamped(scalar(kind, &bytes[i * size..(i + 1) * size]) * scale, scale))
    };
    let mut rows: Vec<[f64; N]> = match accessor.view() {
        Some(view) => {
            let slice = Strided::new(
                accessor,
                &view,
                accessor.offset(),
                components * size,
                accessor.count(),
                buffers,
            )?;
            slice.iter().map(row).collect()
        }
        None if accessor.count() > MOST_ZEROS => {
            return Err(at(
                accessor,
                &format!("has {} rows, but no data for most of them", accessor.count()),
            ));
        }
        None => vec![[0.0; N]; accessor.count()],
    };
    if let Some(sparse) = accessor.sparse() {
        let (indices, values) = (sparse.indices(), sparse.values());
        let index_kind = match indices.index_type() {
            gltf::accessor::sparse::IndexType::U8 => DataType::U8,
            gltf::accessor::sparse::IndexType::U16 => DataType::U16,
            gltf::accessor::sparse::IndexType::U32 => DataType::U32,
        };
        let count = sparse.count();
        let places =
            Strided::new(accessor, &indices.view(), indices.offset(), index_kind.size(), count, buffers)?;
        let values =
            Strided::new(accessor, &values.view(), values.offset(), components * size, count, buffers)?;
        for (place, value) in places.iter().zip(values.iter()) {
            let i = scalar(index_kind, place) as usize;
            *rows
                .get_mut(i)
                .ok_or_else(|| at(accessor, &format!("has a sparse index {i} beyond its end")))? = row(value);
        }
    }
    Ok(rows)
}

/// Whole numbers of one component.
pub(super) fn indices(accessor: &Accessor, buffers: &Buffers) -> Result<Vec<u32>, Stop> {
    let kind = accessor.data_type();
    if kind == DataType::F32 {
        return Err(at(accessor, "has floats where whole numbers are expected"));
    }
    Ok(rows::<1>(accessor, buffers)?.iter().map(|[i]| *i as u32).collect())
}

/// Rows at equal distances.
struct Strided<'b> {
    bytes: &'b [u8],
    stride: usize,
    row: usize,
    count: usize,
}

impl<'b> Strided<'b> {
    fn new(
        accessor: &Accessor,
        view: &View,
        offset: usize,
        row: usize,
        count: usize,
        buffers: &'b Buffers<'b>,
    ) -> Result<Self, Stop> {
        let buffer = buffers.get(view.buffer().index()).map_or(&[][..], AsRef::as_ref);
        let stride = view.stride().unwrap_or(row);
        let needed = count.saturating_sub(1).checked_mul(stride).and_then(|n| n.checked_add(row));
        let range = || {
            let start = view.offset();
            let bytes = buffer.get(start..start.checked_add(view.length())?)?;
            let end = offset.checked_add(needed?)?;
            if count == 0 { Some(&[][..]) } else { bytes.get(offset..end) }
        };
        match range() {
            Some(bytes) => Ok(Self { bytes, stride: stride.max(1), row, count }),
            None => Err(at(accessor, &format!("reaches beyond the end of buffer view {}", view.index()))),
        }
    }

    fn iter(&self) -> impl Iterator<Item = &'b [u8]> {
        let Self { bytes, stride, row, count } = *self;
        (0..count).map(move |i| &bytes[i * stride..i * stride + row])
    }
}

fn at(accessor: &Accessor, what: &str) -> Stop {
    fault(format!("accessor {} {what}", accessor.index()), None)
}

fn scalar(kind: DataType, b: &[u8]) -> f64 {
    match kind {
        DataType::I8 => f64::from(b[0] as i8),
        DataType::U8 => f64::from(b[0]),
        DataType::I16 => f64::from(i16::from_le_bytes([b[0], b[1]])),
        DataType::U16 => f64::from(u16::from_le_bytes([b[0], b[1]])),
        DataType::U32 => f64::from(u32::from_le_bytes([b[0], b[1], b[2], b[3]])),
        DataType::F32 => f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])),
    }
}

/// What stands for 1 in a normalised integer.
fn greatest(kind: DataType) -> f64 {
    match kind {
        DataType::I8 => 127.0,
        DataType::U8 => 255.0,
        DataType::I16 => 32767.0,
        DataType::U16 => 65535.0,
        DataType::U32 | DataType::F32 => 1.0,
    }
}

/// The most negative integer would be below −1. Not a number stays so, for the scene's check to find.
fn clamped(value: f64, scale: f64) -> f64 {
    if scale < 1.0 && value < -1.0 { -1.0 } else { value }
}
