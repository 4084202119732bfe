//! Lists of points: CSV with a header that has `x`, `y` and one of `area` and `volume`.

use super::ReadError;
use super::lines::Lines;
use peristat_assembly::body::{Cloud, CloudError};

/// What the third column says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Areas, m².
    Area,
    /// Volumes, m³: areas times the thickness.
    Volume,
}

/// The points of a file in its order.
#[derive(Clone, Debug, PartialEq)]
pub struct Points {
    /// Positions, m.
    pub positions: Vec<[f64; 2]>,
    /// Area or volume of each.
    pub sizes: Vec<f64>,
    /// Which of both.
    pub measure: Measure,
    lines: Vec<usize>,
}

/// Reads a list of points. Columns may come in any order, others are passed over, and so are blank lines.
///
/// # Errors
/// [`ReadError`] with the line.
pub fn read(bytes: &[u8]) -> Result<Points, ReadError> {
    const COLUMNS: &str =
        "the first line names the columns: x, y and either area or volume, with commas between them";
    let mut lines = Lines::new(bytes);
    let header = lines.text("a header").map_err(|e| e.hint(COLUMNS))?;
    let names: Vec<&str> = header.split(',').map(str::trim).collect();
    let line = lines.number();
    let find = |name: &str| names.iter().position(|n| *n == name);
    let need = |name: &str| {
        find(name).ok_or_else(|| ReadError::at(line, format!("there is no column `{name}`")).hint(COLUMNS))
    };
    let (size, measure) = match (find("area"), find("volume")) {
        (Some(_), Some(_)) => {
            return Err(
                ReadError::at(line, "there are columns `area` and `volume`, one too many").hint(COLUMNS)
            );
        }
        (Some(column), None) => (column, Measure::Area),
        _ => (need("volume")?, Measure::Volume),
    };
    let columns = [(need("x")?, "x"), (need("y")?, "y"), (size, names[size])];
    let mut points = Points { positions: Vec::new(), sizes: Vec::new(), measure, lines: Vec::new() };
    while let Some(row) = lines.raw() {
        let line = lines.number();
        let cells: Vec<&[u8]> = row.split(|b| *b == b',').collect();
        let number = |(column, name): (usize, &str)| {
            let text = cells.get(column).and_then(|c| std::str::from_utf8(c.trim_ascii()).ok());
            let value = text.and_then(|t| t.parse::<f64>().ok()).filter(|v| v.is_finite());
            value.ok_or_else(|| ReadError::at(line, format!("there is no number in column `{name}`")))
        };
        let [x, y, size] = [number(columns[0])?, number(columns[1])?, number(columns[2])?];
        points.positions.push([x, y]);
        points.sizes.push(size);
        points.lines.push(line);
    }
    if points.positions.is_empty() { Err(ReadError::whole("has no points")) } else { Ok(points) }
}

impl Points {
    /// The points of a body of some thickness, m.
    ///
    /// # Errors
    /// [`ReadError`] with the line of a point that has no area or is at the place of another one.
    pub fn cloud(self, thickness: f64) -> Result<Cloud, ReadError> {
        let areas = match self.measure {
            Measure::Area => self.sizes.clone(),
            Measure::Volume => self.sizes.iter().map(|v| v / thickness).collect(),
        };
        let name = if self.measure == Measure::Area { "area" } else { "volume" };
        Cloud::new(self.positions, areas, Vec::new()).map_err(|error| match error {
            CloudError::Area { point, .. } => {
                let found = self.sizes[point];
                ReadError::at(self.lines[point], format!("the {name} must be above zero, found {found}"))
            }
            CloudError::Coincident { first, second } => ReadError::at(
                self.lines[first.max(second)],
                format!("the point is at the place of the one in line {}", self.lines[first.min(second)]),
            ),
            other => ReadError::whole(other.to_string()),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn columns_may_come_in_any_order() {
        let text = b"\xef\xbb\xbfvolume, y ,x,note\r\n2e-3,1,0.5,a\r\n\r\n1e-3,0,0.5,b\r\n";
        let points = read(text).unwrap();
        assert_eq!(points.positions, [[0.5, 1.0], [0.5, 0.0]]);
        let cloud = points.cloud(0.1).unwrap();
        assert_eq!(cloud.areas(), [2e-3 / 0.1, 1e-3 / 0.1]);
        let plain = read(b"x,y,area\n0,0,1").unwrap().cloud(f64::NAN).unwrap();
        assert_eq!(plain.areas(), [1.0]);
    }

    #[test]
    fn faults_name_the_line() {
        let fault = |text: &str| match read(text.as_bytes()).and_then(|p| p.cloud(1.0)) {
            Err(error) => error.to_string(),
            Ok(_) => panic!("{text} is no list of points"),
        };
        assert_eq!(fault(""), "ends where a header belongs");
        assert_eq!(fault("x,y,area\n"), "has no points");
        assert_eq!(fault("x;y;area\n0;0;1\n"), "line 1: there is no column `volume`");
        assert_eq!(fault("x,area\n"), "line 1: there is no column `y`");
        assert_eq!(fault("x,y,area,volume\n"), "line 1: there are columns `area` and `volume`, one too many");
        assert_eq!(fault("x,y,area\n0,0,1\n\n1,inf,1\n"), "line 4: there is no number in column `y`");
        assert_eq!(fault("x,y,area\n0,0\n"), "line 2: there is no number in column `area`");
        assert_eq!(fault("x,y,volume\n0,0,-1\n"), "line 2: the volume must be above zero, found -1");
        assert_eq!(
            fault("x,y,area\n0,0,1\n\n0,0,1\n"),
            "line 4: the point is at the place of the one in line 2"
        );
    }

    proptest! {
        #[test]
        fn any_bytes_are_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..200), header: bool) {
            let head: &[u8] = if header { b"x,y,area\n" } else { b"" };
            if let Ok(points) = read(&[head, &bytes].concat()) {
                let _ = points.cloud(1.0);
            }
        }
    }
}
