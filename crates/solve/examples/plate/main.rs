//! Plate.
#![allow(clippy::print_stdout)]
mod lattice;
mod symbolic;
use lattice::{Plate, write};
use peristat_solve::*;

#[derive(Clone, Copy)]
struct Instant(std::time::Instant, f64);
fn cpu() -> f64 {
    let s = std::fs::read_to_string("/proc/self/stat").unwrap();
    let f: Vec<&str> = s.rsplit(')').next().unwrap().split_whitespace().collect();
    (f[11].parse::<f64>().unwrap() + f[12].parse::<f64>().unwrap()) / 100.0
}
impl Instant {
    fn now() -> Self {
        Self(std::time::Instant::now(), cpu())
    }
    fn elapsed(&self) -> String {
        format!("{:.3} (cpu {:.2})", self.0.elapsed().as_secs_f64(), cpu() - self.1)
    }
}

fn main() {
    let side: usize = std::env::args().nth(1).and_then(|a| a.parse().ok()).unwrap_or(316);
    let plate = Plate::new(side, std::env::var("REACH").map_or(3.0, |r| r.parse().unwrap()));
    if let Some(path) = std::env::args().nth(2) {
        write(&plate.matrix, std::path::Path::new(&path)).unwrap();
    }
    for _ in 0..5 {
        let t = Instant::now();
        let graph = PointGraph::from_matrix(&plate.matrix, 2);
        println!("graph {}", t.elapsed());
        let t = Instant::now();
        let d = nested_dissection(&plate.positions, &graph);
        println!("order {} {:?}", t.elapsed(), d.halves());
        if std::env::var("FILL").is_ok() {
            println!("fill {:?}", symbolic::fill(&graph, d.order(), 2));
        }
        let n = plate.matrix.rows();
        let b: Vec<f64> = (0..n).map(|i| (i as f64 * 0.7).sin()).collect();
        let report = |name: &str, z: &[f64]| {
            let mut ax = vec![0.0; n];
            for (v, (i, j)) in plate.matrix.iter() {
                ax[i] += v * z[j];
                if i != j {
                    ax[j] += v * z[i];
                }
            }
            let norm = |v: &mut dyn Iterator<Item = f64>| v.map(|x| x * x).sum::<f64>().sqrt();
            println!(
                "{name} residual {:.1e} of b, {:.1e} of A x",
                norm(&mut ax.iter().zip(&b).map(|(a, b)| a - b)) / norm(&mut b.iter().copied()),
                norm(&mut ax.iter().zip(&b).map(|(a, b)| a - b)) / norm(&mut z.iter().copied()) / 10.0
            );
        };
        let mut z = vec![0.0; n];
        {
            let t = Instant::now();
            let mut f =
                SparseCholesky::analyse(&plate.matrix, Ordering::Points { order: d.order(), components: 2 })
                    .unwrap();
            let analyse = t.elapsed();
            let t = Instant::now();
            f.refactor(&plate.matrix).unwrap();
            let factor = t.elapsed();
            let t = Instant::now();
            f.apply(&b, &mut z);
            println!(
                "1 thread analyse {analyse} factor {factor} solve {} fill {:.3e}",
                t.elapsed(),
                f.fill() as f64
            );
            report("1", &z);
        }
        {
            let t = Instant::now();
            let mut f = DissectedCholesky::analyse(&plate.matrix, &d, 2).unwrap();
            let analyse = t.elapsed();
            let t = Instant::now();
            f.refactor(&plate.matrix).unwrap();
            let factor = t.elapsed();
            let t = Instant::now();
            f.apply(&b, &mut z);
            println!(
                "2 thread analyse {analyse} factor {factor} solve {} fill {:.3e}",
                t.elapsed(),
                f.fill() as f64
            );
            report("2", &z);
        }
    }
}
