//! Speed of what a cycle over cubes is made of, per point of the finest level. One thread.
#![allow(clippy::print_stdout)]

use peristat_assembly::body::SquareLattice;
use peristat_assembly::cubic::{CubicFaces, CubicLevels, CubicSolid, Stencil};
use peristat_assembly::model::plane::Mirrors;
use std::hint::black_box;
use std::time::Instant;

/// Bonds to all cells within some cells, the stiffer the shorter.
fn stencil(horizon: i32) -> Stencil {
    let all = || -horizon..=horizon;
    let steps = all().flat_map(|c| all().flat_map(move |b| all().map(move |a| [a, b, c])));
    let half = steps.filter(|[a, b, c]| [c, b, a] > [&0; 3] && a * a + b * b + c * c <= horizon * horizon);
    Stencil::new(half.map(|step| (step, 1.0 / f64::from(step.iter().map(|k| k * k).sum::<i32>()))))
}

fn report(side: i32, horizon: i32) {
    let lattice = SquareLattice::cuboid(1.0, [0.0; 3], [side; 3]);
    let n = lattice.points();
    let solid = CubicSolid {
        lattice: &lattice,
        mirrors: &Mirrors::NONE,
        stencil: stencil(horizon),
        held: (0..(side * side) as usize).flat_map(|k| (0..3).map(move |c| (k * side as usize, c))).collect(),
        springs: Vec::new(),
        followers: Vec::new(),
        cuts: Vec::new(),
        faces: CubicFaces::Other,
    };
    let begin = Instant::now();
    let levels = CubicLevels::new(&solid, &|sides, _| sides[0] < 10).expect("a coarser level");
    print!(
        "{side}^3, horizon {horizon}, ns per point: built {:.0};",
        begin.elapsed().as_secs_f64() / n as f64 * 1e9
    );
    let [fine, coarse] = [&levels.levels()[0], &levels.levels()[1]];
    let forces: Vec<f64> = (0..3 * n).map(|i| ((i * 31 % 101) as f64) / 101.0).collect();
    let mut u = vec![0.0; forces.len()];
    let [mut b, mut v, mut w] = [0; 3].map(|_| vec![0.0; fine.size()]);
    let mut correction = vec![0.0; coarse.size()];
    let norm = levels.enter(&forces, &mut b);
    fine.smooth(0.5, &b, &mut v);
    let time = |name: &str, work: &mut dyn FnMut()| {
        let run = || {
            let begin = Instant::now();
            work();
            begin.elapsed().as_secs_f64()
        };
        let best = std::iter::repeat_with(run).take(7).fold(f64::INFINITY, f64::min);
        print!(" {name} {:.1};", best / n as f64 * 1e9);
    };
    time("apply", &mut || fine.apply(black_box(&v), &mut w));
    time("residual", &mut || fine.residual(&b, black_box(&v), &mut w));
    time("relax", &mut || fine.relax([0.2, 0.5], &b, black_box(&v), &mut w));
    time("smooth", &mut || fine.smooth(0.1, black_box(&b), &mut w));
    time("restrict", &mut || levels.restrict(0, black_box(&b), &mut correction));
    time("prolong", &mut || levels.prolong_add(0, black_box(&correction), &mut w));
    time("enter", &mut || _ = levels.enter(black_box(&forces), &mut b));
    time("leave", &mut || levels.leave(black_box(&v), norm, &mut u));
    println!();
}

fn main() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread starts");
    pool.install(|| [(64, 2), (64, 3), (100, 2), (100, 3)].into_iter().for_each(|(side, m)| report(side, m)));
}
