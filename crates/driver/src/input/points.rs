//! Lists of points: CSV with a header that has `x`, `y` and one of `area` and `volume`; of a solid `x`, `y`, `z` and `volume`.

use super::ReadError;
use super::lines::Lines;
use peristat_assembly::body::{Cloud, CloudError};

/// What the column of sizes says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Areas, m².
    Area,
    /// Volumes, m³: in the plane areas times the thickness.
    Volume,
}

impl Measure {
    fn name(self) -> &'static str {
        match self {
            Self::Area => "area",
            Self::Volume => "volume",
        }
    }
}

/// The points of a file in its order.
#[derive(Clone, Debug, PartialEq)]
pub struct Points {
    /// Positions, m; z = 0 in the plane.
    pub positions: Vec<[f64; 3]>,
    /// Area or volume of each.
    pub sizes: Vec<f64>,
    /// Which of both.
    pub measure: Measure,
    /// Coordinates of a point.
    axes: usize,
    lines: Vec<usize>,
}

/// Reads a list of points with two or three coordinates. Columns may come in any order, others are passed over, and so are blank lines.
///
/// # Errors
/// [`ReadError`] with the line.
pub fn read(bytes: &[u8], axes: usize) -> Result<Points, ReadError> {
    let columns = match axes {
        2 => "the first line names the columns: x, y and either area or volume, with commas between them",
        _ => "the first line names the columns: x, y, z and volume, with commas between them",
    };
    let mut lines = Lines::new(bytes);
    let header = lines.text("a header").map_err(|e| e.hint(columns))?;
    let names: Vec<&str> = header.split(',').map(str::trim).collect();
    let line = lines.number();
    let find = |name: &str| names.iter().position(|n| *n == name);
    let need = |name: &'static str| match find(name) {
        Some(column) => Ok((column, name)),
        None => Err(ReadError::at(line, format!("there is no column `{name}`")).hint(columns)),
    };
    let measure = match (find("area").filter(|_| axes == 2), find("volume")) {
        (Some(_), Some(_)) => {
            let message = "there are columns `area` and `volume`, one too many";
            return Err(ReadError::at(line, message).hint(columns));
        }
        (Some(_), None) => Measure::Area,
        _ => Measure::Volume,
    };
    let size = need(measure.name())?;
    let along = ["x", "y", "z"][..axes].iter().map(|name| need(name)).collect::<Result<Vec<_>, _>>()?;
    let mut points = Points { positions: Vec::new(), sizes: Vec::new(), measure, axes, lines: Vec::new() };
    while let Some(row) = lines.raw() {
        let line = lines.number();
        let cells: Vec<&[u8]> = row.split(|b| *b == b',').collect();
        let number = |(column, name): (usize, &str)| {
            let text = cells.get(column).and_then(|c| std::str::from_utf8(c.trim_ascii()).ok());
            let value = text.and_then(|t| t.parse::<f64>().ok()).filter(|v| v.is_finite());
            value.ok_or_else(|| ReadError::at(line, format!("there is no number in column `{name}`")))
        };
        let mut at = [0.0; 3];
        for (x, column) in at.iter_mut().zip(&along) {
            *x = number(*column)?;
        }
        points.positions.push(at);
        points.sizes.push(number(size)?);
        points.lines.push(line);
    }
    if points.positions.is_empty() { Err(ReadError::whole("has no points")) } else { Ok(points) }
}

impl Points {
    /// The points of a body, in the plane of some thickness, m.
    ///
    /// # Errors
    /// [`ReadError`] with the line of a point that has no size or is at the place of another one.
    pub fn cloud(self, thickness: f64) -> Result<Cloud, ReadError> {
        let cloud = match (self.axes, self.measure) {
            (3, _) => Cloud::in_space(self.positions, self.sizes.clone(), Vec::new()),
            (_, measure) => {
                let thickness = if measure == Measure::Area { 1.0 } else { thickness };
                let areas = self.sizes.iter().map(|size| size / thickness).collect();
                let positions = self.positions.iter().map(|&[x, y, _]| [x, y]).collect();
                Cloud::in_plane(positions, areas, Vec::new())
            }
        };
        cloud.map_err(|error| match error {
            CloudError::Size { point, .. } => {
                let (name, found) = (self.measure.name(), self.sizes[point]);
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
        let points = read(text, 2).unwrap();
        assert_eq!(points.positions, [[0.5, 1.0, 0.0], [0.5, 0.0, 0.0]]);
        let cloud = points.cloud(0.1).unwrap();
        assert_eq!(cloud.sizes(), [2e-3 / 0.1, 1e-3 / 0.1]);
        let plain = read(b"x,y,area\n0,0,1", 2).unwrap().cloud(f64::NAN).unwrap();
        assert_eq!(plain.sizes(), [1.0]);
        let solid = read(b"area,z,y,x,volume\n9,3,2,1,4\n", 3).unwrap().cloud(f64::NAN).unwrap();
        assert_eq!((solid.axes(), solid.positions(), solid.sizes()), (3, &[[1.0, 2.0, 3.0]][..], &[4.0][..]));
    }

    #[test]
    fn faults_name_the_line() {
        let fault_of = |text: &str, axes| match read(text.as_bytes(), axes).and_then(|p| p.cloud(1.0)) {
            Err(error) => error.to_string(),
            Ok(_) => panic!("{text} is no list of points"),
        };
        let fault = |text: &str| fault_of(text, 2);
        assert_eq!(fault_of("x,y,volume\n0,0,1", 3), "line 1: there is no column `z`");
        assert_eq!(fault_of("x,y,z,area\n0,0,0,1", 3), "line 1: there is no column `volume`");
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
        fn any_bytes_are_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..200), header: bool, axes in 2_usize..4) {
            let head: &[u8] = if header { b"x,y,z,volume\n" } else { b"" };
            if let Ok(points) = read(&[head, &bytes].concat(), axes) {
                let _ = points.cloud(1.0);
            }
        }
    }
}
