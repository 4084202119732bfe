//! Fields on points and cells: VTK XML `UnstructuredGrid`, for ParaView, VTK, PyVista and meshio.
//!
//! Numbers are 64-bit and lose no bit; how they stand in the file is said in `binary.rs`.

mod binary;

use super::{atomic, xml};
use binary::Items;
use std::io::{self, Write};
use std::ops::Range;
use std::path::Path;

/// A field: one or more components for each point or cell.
#[derive(Debug, Clone, Copy)]
pub struct DataArray<'a> {
    /// Its name in the viewer.
    pub name: &'a str,
    /// Numbers per point or cell: 1, 3 for a vector.
    pub components: usize,
    /// Shape `[points or cells][components]`, point-major.
    pub values: &'a [f64],
    /// Their unit, which viewers show; empty if they have none.
    pub unit: &'a str,
}

/// The form of a cell, with the number that VTK gives it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CellType {
    /// One point.
    Vertex = 1,
    /// Two points.
    Line = 3,
    /// Three points.
    Triangle = 5,
    /// Four points, around.
    Quad = 9,
    /// Eight points: four around, then those above them.
    Hexahedron = 12,
}

impl CellType {
    /// Points of a cell.
    pub fn points(self) -> usize {
        match self {
            CellType::Vertex => 1,
            CellType::Line => 2,
            CellType::Triangle => 3,
            CellType::Quad => 4,
            CellType::Hexahedron => 8,
        }
    }
}

/// Cells of one form.
#[derive(Debug, Clone, Copy)]
pub struct Cells<'a> {
    /// Their form.
    pub cell_type: CellType,
    /// Points of the first cell, of the second, and so on.
    pub connectivity: &'a [u32],
}

/// Points, cells and what is known on them.
#[derive(Debug, Clone, Copy, Default)]
pub struct Grid<'a> {
    /// Coordinates.
    pub points: &'a [[f64; 3]],
    /// Cells, in the order of the cell data.
    pub cells: &'a [Cells<'a>],
    /// Fields on the points.
    pub point_data: &'a [DataArray<'a>],
    /// Fields on the cells.
    pub cell_data: &'a [DataArray<'a>],
}

/// Writes a grid. Points without any cell are shown by no viewer: give them [`CellType::Vertex`].
///
/// # Errors
/// What the file system reports.
///
/// # Panics
/// If a field has not `components` numbers per point or cell, or a cell names a point that is not there.
pub fn write(path: &Path, grid: &Grid<'_>) -> io::Result<()> {
    check(grid);
    let cells: usize = grid.cells.iter().map(Cells::len).sum();
    atomic::replace(path, |out| {
        writeln!(out, "<?xml version=\"1.0\"?>")?;
        write!(out, "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" ")?;
        writeln!(out, "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">")?;
        writeln!(out, "<UnstructuredGrid>")?;
        writeln!(out, "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{cells}\">", grid.points.len())?;
        writeln!(out, "<Points>")?;
        let points = grid.points.as_flattened();
        floats(out, &DataArray { name: "Points", components: 3, values: points, unit: "" })?;
        writeln!(out, "</Points>\n<Cells>")?;
        topology(out, grid.cells)?;
        writeln!(out, "</Cells>")?;
        for (tag, fields) in [("PointData", grid.point_data), ("CellData", grid.cell_data)] {
            writeln!(out, "<{tag}>")?;
            fields.iter().try_for_each(|field| floats(out, field))?;
            writeln!(out, "</{tag}>")?;
        }
        writeln!(out, "</Piece>\n</UnstructuredGrid>\n</VTKFile>")
    })
}

impl Cells<'_> {
    fn len(&self) -> usize {
        self.connectivity.len() / self.cell_type.points()
    }
}

fn check(grid: &Grid<'_>) {
    for cells in grid.cells {
        assert_eq!(cells.connectivity.len() % cells.cell_type.points(), 0, "a cell is cut off");
        assert!(
            cells.connectivity.iter().all(|&p| (p as usize) < grid.points.len()),
            "a cell names no point"
        );
    }
    let cells = grid.cells.iter().map(Cells::len).sum();
    for (fields, count) in [(grid.point_data, grid.points.len()), (grid.cell_data, cells)] {
        for field in fields {
            assert_eq!(field.values.len(), field.components * count, "length of field {}", field.name);
        }
    }
}

fn topology(out: &mut dyn Write, cells: &[Cells<'_>]) -> io::Result<()> {
    let nodes = |block: &Cells<'_>| block.connectivity.len();
    let connectivity = of_parts(cells, nodes, |block, part, _, bytes| {
        bytes.extend(block.connectivity[part].iter().flat_map(|&p| i64::from(p).to_le_bytes()));
    });
    let offsets = of_parts(
        cells,
        |block| block.len(),
        |block, part, before, bytes| {
            let (points, start) = (block.cell_type.points(), before.iter().map(nodes).sum::<usize>());
            bytes.extend(part.flat_map(|cell| ((start + (cell + 1) * points) as i64).to_le_bytes()));
        },
    );
    let types = of_parts(
        cells,
        |block| block.len(),
        |block, part, _, bytes| {
            bytes.resize(bytes.len() + part.len(), block.cell_type as u8);
        },
    );
    let [all, count] = [cells.iter().map(nodes).sum(), cells.iter().map(Cells::len).sum()];
    array(out, "Int64", ("connectivity", 1, ""), &Items { count: all, size: 8, bytes: &connectivity })?;
    array(out, "Int64", ("offsets", 1, ""), &Items { count, size: 8, bytes: &offsets })?;
    array(out, "UInt8", ("types", 1, ""), &Items { count, size: 1, bytes: &types })
}

/// The bytes of a range of items of all blocks, each part of a block added by `add`, which also gets the blocks before.
fn of_parts<'a>(
    cells: &'a [Cells<'a>],
    items: impl Fn(&Cells<'_>) -> usize,
    add: impl Fn(&Cells<'_>, Range<usize>, &[Cells<'_>], &mut Vec<u8>),
) -> impl Fn(Range<usize>) -> Vec<u8> {
    move |range| {
        let (mut bytes, mut first) = (Vec::new(), 0);
        for (number, block) in cells.iter().enumerate() {
            let end = first + items(block);
            let part = range.start.max(first)..range.end.min(end);
            if !part.is_empty() {
                add(block, part.start - first..part.end - first, &cells[..number], &mut bytes);
            }
            first = end;
        }
        bytes
    }
}

fn floats(out: &mut dyn Write, field: &DataArray<'_>) -> io::Result<()> {
    let bytes = |range: Range<usize>| field.values[range].iter().flat_map(|v| v.to_le_bytes()).collect();
    let items = Items { count: field.values.len(), size: size_of::<f64>(), bytes: &bytes };
    array(out, "Float64", (field.name, field.components, field.unit), &items)
}

fn array(
    out: &mut dyn Write,
    kind: &str,
    (name, components, unit): (&str, usize, &str),
    items: &Items<'_>,
) -> io::Result<()> {
    let name = xml(name);
    write!(out, "<DataArray type=\"{kind}\" Name=\"{name}\" ")?;
    write!(out, "NumberOfComponents=\"{components}\" format=\"binary\">")?;
    binary::encode(out, items)?;
    if !unit.is_empty() {
        let unit = xml(unit);
        // After the numbers, as VTK writes it.
        write!(
            out,
            "<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{unit}</InformationKey>"
        )?;
    }
    writeln!(out, "</DataArray>")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str, name: &str) -> Vec<u8> {
        let at = text.find(&format!("Name=\"{name}\"")).unwrap();
        let body = &text[at + text[at..].find('>').unwrap() + 1..];
        binary::decode(&body[..body.find('<').unwrap()])
    }

    fn write_and_read(grid: &Grid<'_>) -> String {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.vtu");
        write(&path, grid).unwrap();
        std::fs::read_to_string(path).unwrap()
    }

    fn bytes(values: &[f64]) -> Vec<u8> {
        values.iter().flat_map(|value| value.to_le_bytes()).collect()
    }

    #[test]
    fn values_and_topology_come_back_bit_for_bit() {
        let points = [[0.0, 0.1, -0.0], [1.0, 1e-300, 2.0], [f64::MAX, 3.0, f64::NAN]];
        let cells = [
            Cells { cell_type: CellType::Line, connectivity: &[0, 1, 1, 2] },
            Cells { cell_type: CellType::Triangle, connectivity: &[0, 1, 2] },
        ];
        let w = DataArray { name: "w <m>", components: 1, values: &[1.0, 2.0, 1.0 / 3.0], unit: "N/mm²" };
        let force =
            DataArray { name: "force", components: 2, values: &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0], unit: "" };
        let text =
            write_and_read(&Grid { points: &points, cells: &cells, point_data: &[w], cell_data: &[force] });
        assert!(text.contains("NumberOfPoints=\"3\" NumberOfCells=\"3\""));
        assert_eq!(read(&text, "Points"), bytes(points.as_flattened()));
        assert_eq!(read(&text, "w &lt;m&gt;"), bytes(w.values));
        assert_eq!(read(&text, "force"), bytes(force.values));
        // As VTK writes units, after the numbers; a field without one has none.
        let label = "<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">N/mm²</InformationKey></DataArray>";
        assert_eq!((text.matches(label).count(), text.matches("UNITS_LABEL").count()), (1, 1));
        // Lines end at 2 and 4, the triangle at 7; 3 and 5 are their numbers in vtkCellType.h.
        assert_eq!(read(&text, "offsets"), [2_i64, 4, 7].map(i64::to_le_bytes).concat());
        assert_eq!(read(&text, "types"), [3, 3, 5]);
        assert_eq!(read(&text, "connectivity"), [0_i64, 1, 1, 2, 0, 1, 2].map(i64::to_le_bytes).concat());
    }

    #[test]
    #[should_panic(expected = "length of field w")]
    fn a_field_of_the_wrong_length_is_a_broken_contract() {
        let field = DataArray { name: "w", components: 3, values: &[1.0], unit: "" };
        write_and_read(&Grid { points: &[[0.0; 3]], point_data: &[field], ..Grid::default() });
    }

    #[test]
    #[should_panic(expected = "a cell names no point")]
    fn a_cell_of_an_absent_point_is_a_broken_contract() {
        let cells = [Cells { cell_type: CellType::Vertex, connectivity: &[1] }];
        write_and_read(&Grid { points: &[[0.0; 3]], cells: &cells, ..Grid::default() });
    }
}
