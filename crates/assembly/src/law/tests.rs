use super::*;

const STRETCHES: [f64; 2] = [0.1, 0.5];

fn law(unloading: Unloading, compression: Compression) -> Bilinear {
    Bilinear::new(STRETCHES, unloading, compression).unwrap()
}

fn all() -> [Bilinear; 3] {
    [
        law(Unloading::Plastic, Compression::Elastic),
        law(Unloading::Plastic, Compression::PerfectlyPlastic),
        law(Unloading::Damage, Compression::Elastic),
    ]
}

/// Numbers between −1 and 1 that look random.
fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Forces and dissipated energies of a bond of modulus 2 on a way through all branches, by hand (the law on paper):
/// theory of the bilinear bond, cases A3 and A4.
#[test]
fn a_bond_follows_its_law_through_all_branches() {
    const WAY: [f64; 11] = [0.05, 0.1, 0.2, 0.3, 0.1, 0.0, -0.05, 0.3, 0.4, 0.5, 0.6];
    let plastic = (
        [0.1, 0.2, 0.15, 0.1, -0.3, -0.5, -0.6, 0.1, 0.05, 0.0, 0.0],
        [0.0, 0.0, 0.021875, 0.0375, 0.0375, 0.0375, 0.0375, 0.0375, 0.046875, 0.05, 0.05],
    );
    let damage = (
        [0.1, 0.2, 0.15, 0.1, 0.1 / 3.0, 0.0, -0.1, 0.1, 0.05, 0.0, 0.0],
        [0.0, 0.0, 0.0125, 0.025, 0.025, 0.025, 0.025, 0.025, 0.0375, 0.05, 0.05],
    );
    for (unloading, (forces, dissipated)) in [(Unloading::Plastic, plastic), (Unloading::Damage, damage)] {
        let law = law(unloading, Compression::Elastic);
        let mut history = History::default();
        for (k, &stretch) in WAY.iter().enumerate() {
            let force = 2.0 * law.response(stretch, &history).force;
            history = law.commit(stretch, &history);
            let lost = 2.0 * law.energies(stretch, &history).dissipated;
            assert!((force - forces[k]).abs() < 1e-15, "{unloading:?} {stretch}: {force}");
            assert!((lost - dissipated[k]).abs() < 1e-15, "{unloading:?} {stretch}: {lost}");
        }
        assert!(history.broken);
    }
}

/// Stretches between two others at which the force has kinks, both ends among them: pieces of straight lines.
fn kinks(law: &Bilinear, history: &History, [from, to]: [f64; 2]) -> Vec<f64> {
    let piece = law.piece(from, history);
    let mut all = vec![from, piece.upper, piece.lower, law.failure(history), history.permanent, 0.0, to];
    all.retain(|s| s.is_finite() && *s >= from.min(to) && *s <= from.max(to));
    all.sort_unstable_by(f64::total_cmp);
    if to < from {
        all.reverse();
    }
    all
}

#[test]
fn work_is_stored_or_dissipated() {
    // 1e5 histories of five reversals each; the full energy of a bond is 0.025, the largest error found 2e-16.
    for law in all() {
        for seed in 0..100_000 {
            let (mut random, mut history, mut work) = (random(seed), History::default(), 0.0);
            let (mut last, mut at) = (BondEnergy::default(), 0.0);
            for _ in 0..5 {
                let next = 0.2 + 0.45 * random();
                let way = kinks(&law, &history, [at, next]);
                for pair in way.windows(2) {
                    let force = |s: f64| law.response(s, &history).force;
                    // Beyond the failure stretch the force is none: the mean of both ends is that of the line before it.
                    work += 0.5 * (force(pair[0]) + force(pair[1])) * (pair[1] - pair[0]);
                }
                let energy = law.response(next, &history).energy - law.response(at, &history).energy;
                history = law.commit(next, &history);
                let now = law.energies(next, &history);
                let gained = now.stored + now.dissipated - last.stored - last.dissipated;
                assert!((gained - energy).abs() < 1e-12 * 0.025, "{seed}: {gained} {energy}");
                (last, at) = (now, next);
            }
            let error = work - last.stored - last.dissipated;
            assert!(error.abs() < 1e-12 * 0.025, "{seed}: {error}");
        }
    }
}

#[test]
fn the_force_is_the_derivative_of_the_energy_and_the_tangent_that_of_the_force() {
    const STEP: f64 = 1e-6;
    for law in all() {
        for seed in 0..2000 {
            let (mut random, mut history) = (random(seed), History::default());
            for _ in 0..4 {
                let s = 0.2 + 0.45 * random();
                let [low, here, high] = [s - STEP, s, s + STEP].map(|s| law.response(s, &history));
                if low.tangent == high.tangent {
                    let force = (high.energy - low.energy) / (2.0 * STEP);
                    let tangent = (high.force - low.force) / (2.0 * STEP);
                    assert!((force - here.force).abs() < 1e-10, "{seed}");
                    assert!((tangent - here.tangent).abs() < 1e-9, "{seed}");
                }
                assert!(here.secant >= 0.0 && here.energy >= 0.0);
                history = law.commit(s, &history);
            }
        }
    }
}

#[test]
fn committing_twice_changes_nothing() {
    for law in all() {
        for seed in 0..2000 {
            let (mut random, mut history) = (random(seed), History::default());
            for _ in 0..6 {
                let s = 0.2 + 0.45 * random();
                history = law.commit(s, &history);
                let again = law.commit(s, &history);
                assert!((again.softened - history.softened).abs() < 1e-15);
                assert!((law.response(s, &again).force - law.response(s, &history).force).abs() < 1e-14);
            }
        }
    }
}

#[test]
fn a_bond_that_fails_where_it_yields_is_brittle() {
    for unloading in [Unloading::Plastic, Unloading::Damage] {
        let law = Bilinear::new([0.1, 0.1], unloading, Compression::Elastic).unwrap();
        let virgin = History::default();
        assert_eq!(law.response(0.1, &virgin).force, 0.1);
        assert_eq!(law.response(0.1 + 1e-12, &virgin).force, 0.0);
        let history = law.commit(0.11, &virgin);
        assert!(history.broken);
        assert!((law.energies(0.11, &history).dissipated - 0.005).abs() < 1e-17);
        assert_eq!(law.commit(0.1, &virgin), virgin);
    }
}

#[test]
fn laws_that_cannot_be_are_refused() {
    let new = |s| Bilinear::new(s, Unloading::Plastic, Compression::Elastic);
    assert_eq!(new([0.2, 0.1]), Err(BilinearError::FailsBeforeItYields { failure: 0.1, yielding: 0.2 }));
    assert_eq!(new([0.0, 0.1]), Err(BilinearError::NotPositive(0.0, 0.1)));
    assert!(new([f64::NAN, 0.1]).is_err());
    assert_eq!(
        Bilinear::new([0.1, 0.2], Unloading::Damage, Compression::PerfectlyPlastic),
        Err(BilinearError::PlasticDamage)
    );
}

#[test]
fn a_law_tells_its_stretches_and_its_faults() {
    for law in all() {
        assert_eq!([law.yield_stretch(), law.failure_stretch()], STRETCHES);
        assert!((law.brittleness() - 5.0).abs() < 1e-15);
    }
    let make = |stretches: [f64; 2]| Bilinear::new(stretches, Unloading::Plastic, Compression::Elastic);
    assert!(make([0.1, 0.1]).is_ok());
    assert_eq!(make([0.2, 0.1]), Err(BilinearError::FailsBeforeItYields { failure: 0.1, yielding: 0.2 }));
    assert_eq!(make([0.0, 0.1]), Err(BilinearError::NotPositive(0.0, 0.1)));
    assert_eq!(make([0.1, -0.1]), Err(BilinearError::NotPositive(0.1, -0.1)));
    let pressed = Bilinear::new(STRETCHES, Unloading::Damage, Compression::PerfectlyPlastic);
    assert_eq!(pressed, Err(BilinearError::PlasticDamage));
}
