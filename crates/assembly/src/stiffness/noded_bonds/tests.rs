use super::*;

/// Two rows of points with nodes between them, and bonds of three kinds: along rows, across them, and here and there.
fn bonds(points: usize) -> NodedBonds<3, 1> {
    let half = points / 2;
    let mut builder = NodedBondsBuilder::new(points);
    let node = |k: usize| vec![(k as u32, 1.5), ((half + k) as u32, -0.5)];
    let nodes: Vec<u32> = (0..half).rev().map(|k| builder.add_node(node(k))).rev().collect();
    let kind = |shares: [Vec<f64>; 2], row: [f64; 3], modulus: f64| NodedKind {
        shares,
        rows: [row],
        moduli: [modulus],
    };
    let along = builder.add_kind(kind([vec![], vec![0.25, 0.75]], [0.6, 0.8, 0.0], 3.0));
    let across = builder.add_kind(kind([vec![0.5, 0.5], vec![]], [0.0, 0.6, -0.8], 2.0));
    let between = builder.add_kind(kind([vec![1.0], vec![1.0]], [1.0, 0.0, 0.0], 0.5));
    for k in 1..half - 1 {
        builder.push(along, [k as u32, nodes[k], nodes[k + 1]]);
        if k % 3 != 0 {
            builder.push(across, [nodes[k - 1], nodes[k], (half + k) as u32]);
        }
    }
    (0..4).for_each(|k| builder.push(between, [nodes[7 * k], nodes[31 - 5 * k]]));
    builder.build()
}

fn arbitrary(size: usize) -> Vec<f64> {
    (0..size).map(|i| ((i * 7919) % 1013) as f64 / 1013.0 - 0.5).collect()
}

/// Bonds of which every one lists its points are the reference.
#[test]
fn forces_and_energies_are_those_of_bonds_one_by_one() {
    let points = 180;
    let (bonds, u) = (bonds(points), arbitrary(540));
    let [mut found, mut expected] = [0; 2].map(|_| vec![0.0; 3 * points]);
    bonds.add_force(&u, &mut found);
    let (mut count, mut energy) = (0, 0.0);
    bonds.written_out(|placed| {
        placed.add_force(&u, &mut expected);
        count += placed.count();
        energy += placed.survey(&u).energy;
    });
    assert_eq!((count, bonds.count()), (88 + 59 + 4, 88 + 59 + 4));
    found.iter().zip(&expected).for_each(|(a, b)| assert!((a - b).abs() < 1e-14, "{a} {b}"));
    assert!((bonds.survey(&u).energy - energy).abs() < 1e-13);
    // 131 measured; 151 bonds and 90 nodes, one by one, are more than 500.
    assert!(bonds.stored_factors() < 160, "{}", bonds.stored_factors());
}
