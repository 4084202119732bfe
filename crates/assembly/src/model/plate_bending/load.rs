//! Loads of plates, on the points.

use super::{PHI_X, PHI_Y, PlateBending, W};

impl PlateBending {
    /// Adds a pressure on the cells that are `inside`, by position, Pa, to `force`: a quarter of every cell on each of its
    /// corners, and the couples `q h²/12` per length of the edges of what is loaded, inwards, which the bonds of a beam have at
    /// their ends under a uniform load.
    pub fn add_pressure(
        &self,
        inside: impl Fn([i32; 2]) -> bool,
        pressure: impl Fn([f64; 2]) -> f64,
        force: &mut [f64],
    ) {
        let (nodes, n) = (self.nodes(), self.nodes().points());
        let h = nodes.spacing();
        for cell in nodes.all_cells().filter(|&cell| inside(cell)) {
            for point in nodes.corners(cell).into_iter().flatten() {
                force[W * n + point] += 0.25 * h * h * pressure(nodes.place(point));
            }
        }
        for edge in nodes.edges_of(&inside) {
            for point in edge.points.map(|p| p as usize) {
                let couple = pressure(nodes.place(point)) * h * h / 12.0 * (0.5 * h);
                for (c, normal) in [PHI_X, PHI_Y].into_iter().zip(edge.outward) {
                    force[c * n + point] -= couple * normal;
                }
            }
        }
    }

    /// Adds a load along lines from point to point, per length, to `force`: by position, a force along z, N/m, and the moments
    /// that do work with the two rotations, N.
    pub fn add_line(
        &self,
        segments: &[[u32; 2]],
        load: impl Fn(usize, [f64; 2]) -> [f64; 3],
        force: &mut [f64],
    ) {
        let n = self.nodes().points();
        for (index, segment) in segments.iter().enumerate() {
            let [a, b] = segment.map(|p| self.nodes().place(p as usize));
            let half = 0.5 * (b[0] - a[0]).hypot(b[1] - a[1]);
            for (point, place) in segment.iter().zip([a, b]) {
                for (c, part) in load(index, place).into_iter().enumerate() {
                    force[c * n + *point as usize] += half * part;
                }
            }
        }
    }
}
