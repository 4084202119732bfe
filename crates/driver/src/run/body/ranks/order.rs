//! The points of a body, process by process.

use super::boxes::Boxes;
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::plane::Mirrors;

/// Where every point stands: one process after the other, with each by their numbers. Images are with their points.
pub(super) struct Order {
    /// Where the points of every process begin, and the end of all.
    starts: Vec<usize>,
    places: Vec<u32>,
}

impl Order {
    /// The order of the points of a lattice with images.
    pub(super) fn new(lattice: &SquareLattice, mirrors: &Mirrors, boxes: &Boxes, processes: usize) -> Self {
        let mut owners = Vec::with_capacity(lattice.points());
        for run in lattice.runs() {
            owners.extend(run.columns.clone().map(|column| boxes.owner(mirrors.image(run.cell(column)).0)));
        }
        let mut starts = vec![0; processes + 1];
        owners.iter().for_each(|&owner| starts[owner + 1] += 1);
        (0..processes).for_each(|k| starts[k + 1] += starts[k]);
        let mut next = starts.clone();
        let place = |owner: usize| {
            next[owner] += 1;
            (next[owner] - 1) as u32
        };
        Self { places: owners.into_iter().map(place).collect(), starts }
    }

    /// How many points a process has.
    pub(super) fn count(&self, process: usize) -> usize {
        self.starts[process + 1] - self.starts[process]
    }

    /// The process of a point.
    pub(super) fn owner(&self, point: usize) -> usize {
        let place = self.places[point] as usize;
        self.starts.partition_point(|&start| start <= place) - 1
    }

    /// Place in the long vector of the first unknown of a point, of `unknowns`, and how far behind each other these are: the part
    /// of a process has component planes.
    pub(super) fn place(&self, point: usize, unknowns: usize) -> (usize, usize) {
        let owner = self.owner(point);
        let start = self.starts[owner];
        (unknowns * start + self.places[point] as usize - start, self.count(owner))
    }

    /// Writes the long vector of unknowns in component planes.
    pub(super) fn arrange(&self, planes: &[f64], long: &mut [f64]) {
        self.each(planes.len(), |plane, place| long[place] = planes[plane]);
    }

    /// The reverse of [`arrange`](Self::arrange).
    pub(super) fn restore(&self, long: &[f64], planes: &mut [f64]) {
        self.each(planes.len(), |plane, place| planes[plane] = long[place]);
    }

    /// Adds a long vector to unknowns in component planes.
    pub(super) fn add(&self, long: &[f64], planes: &mut [f64]) {
        self.each(planes.len(), |plane, place| planes[plane] += long[place]);
    }

    /// Calls `visit` with the numbers of all unknowns in planes and their places in the long vector.
    fn each(&self, size: usize, mut visit: impl FnMut(usize, usize)) {
        let points = self.places.len();
        for point in 0..points {
            let (first, step) = self.place(point, size / points);
            (0..size / points).for_each(|c| visit(c * points + point, first + c * step));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_vectors_have_the_planes_of_one_process_after_the_other() {
        let lattice = SquareLattice::rectangle(1.0, [0.0; 2], [4, 2]);
        let boxes = Boxes::new(&lattice, 2).unwrap();
        let order = Order::new(&lattice, &Mirrors::NONE, &boxes, 2);
        let planes: Vec<f64> = (0..16).map(f64::from).collect();
        let mut long = vec![0.0; 16];
        order.arrange(&planes, &mut long);
        assert_eq!(long, [0, 1, 4, 5, 8, 9, 12, 13, 2, 3, 6, 7, 10, 11, 14, 15].map(f64::from));
        let mut back = vec![0.0; 16];
        order.restore(&long, &mut back);
        assert_eq!(back, planes);
        assert_eq!((order.owner(1), order.owner(2), order.count(1)), (0, 1, 4));
    }
}
