//! Times the direct path on a plate: order, analysis, factor and solve with one and with two
//! threads.
//!
//! Run with `cargo run --release -p peristat-solve --example plate -- [points] [options]`:
//!
//! * `--reach R`: points are coupled up to R spacings (default 3);
//! * `--rounds N`: how often (default 1); `--threads 1` or `--threads 2`: only this one;
//! * `--write FILE`: write the matrix, see `lattice.rs` for the format, and time nothing;
//! * `--order FILE`: count the fill of the order of points in FILE (u32, little endian), and time
//!   nothing;
//! * `--fill`: count the fill of the own order, and time nothing;
//! * `--changes`: time, in one thread, the factors of a definite and of an indefinite matrix, solves, and those with
//!   a few bonds softer; medians of the rounds.
//!
//! Prints one JSON object per line.
#![allow(clippy::print_stdout)] // the purpose of the program

mod changes;
mod lattice;
mod symbolic;

use lattice::{Plate, write};
use peristat_solve::{
    DissectedCholesky, FactorError, Ordering, PointGraph, Preconditioner, SparseCholesky, nested_dissection,
};
use std::time::Instant;

const COMPONENTS: usize = 2;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let option = |name: &str| {
        let at = arguments.iter().position(|a| a == name)?;
        arguments.get(at + 1)
    };
    let points = arguments.first().and_then(|a| a.parse::<f64>().ok()).unwrap_or(1.0e5);
    let reach = option("--reach").map_or(Ok(3.0), |a| a.parse())?;
    let plate = Plate::new(points.sqrt().round() as usize, reach);
    if let Some(path) = option("--write") {
        write(&plate.matrix, path.as_ref())?;
        return Ok(());
    }
    if arguments.iter().any(|a| a == "--fill") || option("--order").is_some() {
        let graph = PointGraph::from_matrix(&plate.matrix, COMPONENTS);
        let order = match option("--order") {
            Some(path) => read_order(&std::fs::read(path)?),
            None => nested_dissection(&plate.positions, &graph).order().to_vec(),
        };
        let (entries, work) = symbolic::fill(&graph, &order, COMPONENTS);
        println!("{{\"points\": {}, \"fill\": {entries}, \"work\": {work}}}", plate.positions.len());
        return Ok(());
    }
    let rounds = option("--rounds").map_or(Ok(1), |a| a.parse())?;
    if arguments.iter().any(|a| a == "--changes") {
        changes::time(&plate, rounds)?;
        return Ok(());
    }
    let threads: Option<usize> = option("--threads").map(|a| a.parse()).transpose()?;
    for _ in 0..rounds {
        for threads in [1, 2].into_iter().filter(|t| threads.is_none_or(|only| only == *t)) {
            time(&plate, threads)?;
        }
    }
    Ok(())
}

fn read_order(bytes: &[u8]) -> Vec<usize> {
    bytes.as_chunks().0.iter().map(|number| u32::from_le_bytes(*number) as usize).collect()
}

/// What both factors do after their analysis.
trait Factor: Preconditioner {
    fn refactor(&mut self, plate: &Plate) -> Result<(), FactorError>;
    fn stored(&self) -> usize;
}

impl Factor for SparseCholesky {
    fn refactor(&mut self, plate: &Plate) -> Result<(), FactorError> {
        self.refactor(&plate.matrix)
    }

    fn stored(&self) -> usize {
        self.fill()
    }
}

impl Factor for DissectedCholesky {
    fn refactor(&mut self, plate: &Plate) -> Result<(), FactorError> {
        self.refactor(&plate.matrix)
    }

    fn stored(&self) -> usize {
        self.fill()
    }
}

fn time(plate: &Plate, threads: usize) -> Result<(), FactorError> {
    let matrix = &plate.matrix;
    let b: Vec<f64> = (0..matrix.rows()).map(|i| f64::from(!plate.clamped(i))).collect();
    let mut x = vec![0.0; b.len()];
    let begin = Instant::now();
    let graph = PointGraph::from_matrix(matrix, COMPONENTS);
    let dissection = nested_dissection(&plate.positions, &graph);
    let order = begin.elapsed().as_secs_f64();
    let mut factor: Box<dyn Factor> = if threads == 1 {
        let ordering = Ordering::Points { order: dissection.order(), components: COMPONENTS };
        Box::new(SparseCholesky::analyse(matrix, ordering)?)
    } else {
        Box::new(DissectedCholesky::analyse(matrix, &dissection, COMPONENTS)?)
    };
    let analyse = begin.elapsed().as_secs_f64() - order;
    factor.refactor(plate)?;
    let factored = begin.elapsed().as_secs_f64() - order - analyse;
    factor.apply(&b, &mut x);
    let total = begin.elapsed().as_secs_f64();
    let solve = total - order - analyse - factored;
    let residual = plate.residual(&x, &b);
    println!(
        "{{\"threads\": {threads}, \"order\": {order:.4}, \"analyse\": {analyse:.4}, \"factor\": {factored:.4}, \
         \"solve\": {solve:.4}, \"total\": {total:.4}, \"stored\": {}, \"residual\": {residual:.2e}}}",
        factor.stored()
    );
    Ok(())
}
