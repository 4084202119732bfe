//! Shell membranes pass the checks of every model: kinematics, calibrations, bending, lines of symmetry and joined sides.

use super::consistency::check;
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::plane::{Calibration, Mirrors};
use peristat_assembly::model::shell_membrane::{ShellEnds, ShellKinematics, ShellMembrane, ShellParameters};
use proptest::prelude::*;
use std::sync::Arc;

proptest! {
    #![proptest_config(super::cases(12))]

    #[test]
    fn a_shell_is_consistent_in_any_form(
        columns in 1_i32..30, rows in 1_i32..10, choice in 0_usize..16, m in 2.0_f64..4.0,
        sides in prop::array::uniform2(0_usize..5), seed in any::<u64>()
    ) {
        let parameters = ShellParameters {
            youngs_modulus: 3.0,
            thickness: 0.2,
            radius: 4.0,
            horizon_ratio: m,
            kinematics: [ShellKinematics::Chord, ShellKinematics::Published][choice % 2],
            calibration: [Calibration::Matched, Calibration::Published][choice / 2 % 2],
            ends: [ShellEnds::Border, ShellEnds::Weights][choice / 8],
            bending: choice / 4 % 2 == 1,
        };
        let size = [columns, rows];
        let mut mirrors = Mirrors::NONE;
        for axis in 0..2 {
            // No line, one on either side, both, or joined sides.
            let lines = [[false; 2], [true, false], [false, true], [true; 2], [true; 2]][sides[axis]];
            mirrors.joined[axis] = sides[axis] == 4;
            for side in (0..2).filter(|&side| lines[side]) {
                mirrors.set_line(2 * axis + side, if side == 0 { 0 } else { size[axis] });
            }
        }
        let real = SquareLattice::rectangle(0.5, [1.0, 0.0], size);
        let lattice = mirrors.extended(&real, ShellMembrane::depth(&parameters).expect("two spacings are enough"));
        let shell = ShellMembrane::on_lattice(Arc::new(lattice), mirrors, parameters).expect("bonds are positive");
        check::<3, _>(&shell, &Vec::new, seed);
    }
}
