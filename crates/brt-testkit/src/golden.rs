//! Golden files: pictures and tables under version control that a rendering must equal, code by code.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};

use brt_image::{
    Encoding, Picture, PictureLimits, PictureSize, Target, Transfer, encoder, heat_map, read_picture,
};
use thiserror::Error;

/// A folder of golden files.
///
/// With `UPDATE_GOLDEN=1` in the environment they are written instead of compared.
#[derive(Clone, Debug)]
pub struct Golden {
    folder: PathBuf,
    is_updating: bool,
}

/// A picture or table that is not the golden one.
#[derive(Debug, Error)]
pub enum GoldenError {
    /// They differ.
    #[error(
        "{name}: pixel {x},{y} has levels {actual:?}, expected {expected:?}; {count} pixels differ; see {see}"
    )]
    Differs {
        /// Name of the image.
        name: String,
        /// Column of the first pixel that differs.
        x: u32,
        /// Its row.
        y: u32,
        /// Levels of 255 there in the golden image.
        expected: [f64; 3],
        /// Levels of 255 there now.
        actual: [f64; 3],
        /// Number of pixels that differ.
        count: usize,
        /// File with the golden image, the differences and the new image side by side.
        see: String,
    },
    /// A line of a table differs.
    #[error("{name}: line {line} is\n  {actual}\nexpected\n  {expected}\nthe whole table is now\n{table}")]
    Line {
        /// Name of the table.
        name: String,
        /// Number of the first line that differs.
        line: usize,
        /// That line in the golden table.
        expected: String,
        /// That line now.
        actual: String,
        /// All of it as it is now.
        table: String,
    },
    /// There is no golden image, or it has another size.
    #[error("{0}; if it should be new, run the test with UPDATE_GOLDEN=1")]
    Missing(String),
    /// A file could not be written.
    #[error("{0}")]
    Write(String),
}

impl Golden {
    /// The images in a folder.
    pub fn new(folder: impl Into<PathBuf>) -> Self {
        let is_updating = env::var_os("UPDATE_GOLDEN").is_some_and(|v| v == "1");
        Self { folder: folder.into(), is_updating }
    }

    /// Compares a table with a golden one, line by line, or writes it.
    ///
    /// # Errors
    /// If they differ, or the file cannot be read or written.
    pub fn check_table(&self, name: &str, table: &str) -> Result<(), GoldenError> {
        let path = self.folder.join(format!("{name}.txt"));
        if self.is_updating {
            return fs::write(&path, table).map_err(|error| GoldenError::Write(error.to_string()));
        }
        let golden = fs::read_to_string(&path).map_err(|error| GoldenError::Missing(error.to_string()))?;
        let lines = golden.lines().count().max(table.lines().count());
        let line = |text: &str, i: usize| text.lines().nth(i).unwrap_or("(none)").to_owned();
        let Some(i) = (0..lines).find(|&i| line(&golden, i) != line(table, i)) else { return Ok(()) };
        Err(GoldenError::Line {
            name: name.to_owned(),
            line: i + 1,
            expected: line(&golden, i),
            actual: line(table, i),
            table: table.to_owned(),
        })
    }

    /// Compares colours (linear RGB) with a golden image that is stored by this transfer function, or writes it.
    ///
    /// # Errors
    /// If they differ, or a file cannot be read or written.
    pub fn check(
        &self,
        name: &str,
        size: [u64; 2],
        colors: &[[f32; 3]],
        transfer: Transfer,
    ) -> Result<(), GoldenError> {
        let size = PictureSize::new(size[0] as u32, size[1] as u32);
        let golden_path = self.folder.join(format!("{name}.png"));
        let failed_path = self.folder.join(format!("{name}.failed.png"));
        if self.is_updating {
            return write(&golden_path, size, colors, transfer);
        }
        let expected = read_picture(&golden_path, PictureLimits::default())
            .map_err(|error| GoldenError::Missing(error.to_string()))?;
        if expected.size() != size {
            let message = format!("{name} is {size}, the golden image {}", expected.size());
            return Err(GoldenError::Missing(message));
        }
        // Through a file, so that exactly what is stored is compared.
        write(&failed_path, size, colors, transfer)?;
        let actual = read_picture(&failed_path, PictureLimits::default())
            .map_err(|error| GoldenError::Write(error.to_string()))?;
        let result = self.compare(name, &expected, &actual, &failed_path);
        if result.is_ok() {
            fs::remove_file(&failed_path).map_err(|error| GoldenError::Write(error.to_string()))?;
        }
        result
    }

    fn compare(
        &self,
        name: &str,
        expected: &Picture,
        actual: &Picture,
        see: &Path,
    ) -> Result<(), GoldenError> {
        let size = expected.size();
        let pixels = size.pixels() as usize;
        let mut differing = (0..pixels).filter(|&i| expected.levels(i) != actual.levels(i));
        let Some(first) = differing.next() else { return Ok(()) };
        write_triptych(see, expected, actual)?;
        Err(GoldenError::Differs {
            name: name.to_owned(),
            x: first as u32 % size.width,
            y: first as u32 / size.width,
            expected: expected.levels(first),
            actual: actual.levels(first),
            count: 1 + differing.count(),
            see: see.display().to_string(),
        })
    }
}

/// Expected, difference and actual, side by side.
fn write_triptych(path: &Path, expected: &Picture, actual: &Picture) -> Result<(), GoldenError> {
    let size = expected.size();
    let heat = heat_map(expected, actual).map_err(|error| GoldenError::Write(error.to_string()))?;
    let width = size.width as usize;
    let linear = |p: &Picture, i: usize| p.levels(i).map(|l| Transfer::Srgb.decode(l / 255.0) as f32);
    let mut colors = Vec::with_capacity(3 * width * size.height as usize);
    for row in 0..size.height as usize {
        let row = row * width..(row + 1) * width;
        colors.extend(row.clone().map(|i| linear(expected, i)));
        colors.extend(&heat.pixels()[row.clone()]);
        colors.extend(row.map(|i| linear(actual, i)));
    }
    write(path, PictureSize::new(3 * size.width, size.height), &colors, Transfer::Srgb)
}

fn write(path: &Path, size: PictureSize, colors: &[[f32; 3]], transfer: Transfer) -> Result<(), GoldenError> {
    let save = || -> Result<(), Box<dyn std::error::Error>> {
        let encoding = Encoding { transfer, ..Encoding::default() };
        let mut encoder = encoder(Target::File(path.to_owned()).open()?, size, encoding)?;
        encoder.write(colors)?;
        Ok(encoder.finish()?)
    };
    save().map_err(|error| GoldenError::Write(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_code_more_is_a_difference_and_leaves_three_pictures_side_by_side() {
        let folder = tempfile::tempdir().unwrap();
        let update = Golden { folder: folder.path().to_owned(), is_updating: true };
        let check = Golden { is_updating: false, ..update.clone() };
        let mut colors = vec![[0.5, 0.25, 0.0]; 12];
        assert!(matches!(check.check("grey", [4, 3], &colors, Transfer::Srgb), Err(GoldenError::Missing(_))));
        update.check("grey", [4, 3], &colors, Transfer::Srgb).unwrap();
        check.check("grey", [4, 3], &colors, Transfer::Srgb).unwrap();
        assert!(!folder.path().join("grey.failed.png").exists());
        colors[6][2] = 0.0004; // one level of 255 in sRGB
        let error = check.check("grey", [4, 3], &colors, Transfer::Srgb).unwrap_err();
        assert!(matches!(error, GoldenError::Differs { x: 2, y: 1, count: 1, .. }), "{error}");
        let three = read_picture(&folder.path().join("grey.failed.png"), PictureLimits::default()).unwrap();
        assert_eq!(three.size(), PictureSize::new(12, 3));
    }

    #[test]
    fn a_table_names_its_first_line_that_differs() {
        let folder = tempfile::tempdir().unwrap();
        let update = Golden { folder: folder.path().to_owned(), is_updating: true };
        let check = Golden { is_updating: false, ..update.clone() };
        assert!(matches!(check.check_table("counts", "a 1\n"), Err(GoldenError::Missing(_))));
        update.check_table("counts", "a 1\nb 2\n").unwrap();
        check.check_table("counts", "a 1\nb 2\n").unwrap();
        for (other, line) in [("a 1\nb 3\n", 2), ("a 1\n", 2), ("a 1\nb 2\nc 3\n", 3)] {
            let error = check.check_table("counts", other).unwrap_err();
            assert!(matches!(error, GoldenError::Line { line: l, .. } if l == line), "{error}");
        }
    }
}
