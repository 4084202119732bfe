//! Random plane frames, and their exact answer: a dense matrix calculation with one exact Timoshenko element per member.
//!
//! Nothing of the program is used: unknowns are joint displacements in the axes of the plane, hinged ends have rotations
//! of their own, and supports are Lagrange multipliers.

use super::noise::Noise;
use nalgebra::{DMatrix, DVector, Matrix6, Vector6};
use serde_json::{Value, json};

/// A member with uniform loads across and along it.
#[derive(Clone, Debug)]
pub(crate) struct Member {
    pub(crate) joints: [usize; 2],
    pub(crate) hinges: [bool; 2],
    /// EI, κGA, EA.
    pub(crate) stiffness: [f64; 3],
    /// Force per length across the member, to its left, and along it.
    pub(crate) load: [f64; 2],
    pub(crate) cells: usize,
}

/// A joint support: direction in degrees, or `None` for rotation, and the prescribed value.
#[derive(Clone, Debug)]
pub(crate) struct Support {
    pub(crate) joint: usize,
    pub(crate) degrees: Option<f64>,
    pub(crate) value: f64,
}

/// A frame with loads on its joints.
#[derive(Clone, Debug)]
pub(crate) struct Frame {
    pub(crate) joints: Vec<[f64; 2]>,
    pub(crate) members: Vec<Member>,
    pub(crate) supports: Vec<Support>,
    /// Springs along x, y and against rotation.
    pub(crate) springs: Vec<(usize, [f64; 3])>,
    /// Forces along x, y and moments on joints.
    pub(crate) loads: Vec<[f64; 3]>,
}

/// The answer: displacements and rotations of joints, forces of supports, section forces at the ends of members.
pub(crate) struct Answer {
    pub(crate) displacements: Vec<[f64; 2]>,
    pub(crate) reactions: Vec<f64>,
    /// N, V, M at `from` and `to` of every member.
    pub(crate) sections: Vec<[[f64; 3]; 2]>,
}

impl Frame {
    /// Joint 0 is clamped; members that close loops may have hinges, so that nothing is a mechanism.
    pub(crate) fn random(seed: u64) -> Self {
        let mut noise = Noise(seed.wrapping_mul(977).wrapping_add(12345));
        let count = 3 + noise.index(5);
        let joints: Vec<[f64; 2]> =
            (0..count).map(|k| [1.7 * k as f64 + noise.next(), 3.0 * noise.next()]).collect();
        let mut pairs: Vec<([usize; 2], bool)> = (1..count).map(|k| ([noise.index(k), k], false)).collect();
        for _ in 0..1 + noise.index(count) {
            let (a, b) = (noise.index(count), noise.index(count));
            if a != b {
                pairs.push(([a, b], true));
            }
        }
        let member = |(joints, loop_): ([usize; 2], bool)| Member {
            joints,
            hinges: [loop_ && noise.next() > 0.0, loop_ && noise.next() > 0.0],
            stiffness: [
                noise.between(0.5, 3.0),
                10.0_f64.powf(noise.between(1.0, 3.0)),
                10.0_f64.powf(noise.between(1.0, 4.0)),
            ],
            // Some members stretch as bars, the others carry axial loads.
            load: if noise.next() > 0.0 { [noise.next(), noise.next()] } else { [noise.next(), 0.0] },
            cells: 1 + noise.index(25),
        };
        let members = pairs.into_iter().map(member).collect();
        let mut supports: Vec<Support> =
            [Some(0.0), Some(90.0), None].map(|degrees| Support { joint: 0, degrees, value: 0.0 }).into();
        let degrees = Some(noise.between(-170.0, 170.0));
        supports.push(Support { joint: count - 1, degrees, value: 0.05 * noise.next() });
        let springs = vec![(1, [noise.between(0.1, 3.0), noise.between(0.1, 3.0), noise.between(0.1, 3.0)])];
        let loads = (0..count).map(|_| [noise.next(), noise.next(), noise.next()]).collect();
        Self { joints, members, supports, springs, loads }
    }

    /// The frame turned about the origin, with its supports and loads.
    pub(crate) fn turned(&self, degrees: f64) -> Self {
        let (s, c) = degrees.to_radians().sin_cos();
        let turn = |x: f64, y: f64| [c * x - s * y, s * x + c * y];
        let mut frame = self.clone();
        frame.joints.iter_mut().for_each(|p| *p = turn(p[0], p[1]));
        for load in &mut frame.loads {
            let [x, y] = turn(load[0], load[1]);
            *load = [x, y, load[2]];
        }
        frame.supports.iter_mut().for_each(|s| s.degrees = s.degrees.map(|d| d + degrees));
        frame
    }

    /// Length and direction of a member.
    pub(crate) fn line(&self, member: &Member) -> (f64, [f64; 2]) {
        let [a, b] = member.joints.map(|j| self.joints[j]);
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = dx.hypot(dy);
        (length, [dx / length, dy / length])
    }

    /// The case file.
    pub(crate) fn case(&self) -> Value {
        let uniform = |v: f64| json!({ "uniform": v });
        let stiffness = |s: &[f64; 3]| json!({ "bending": uniform(s[0]), "shear": uniform(s[1]), "axial": uniform(s[2]) });
        let joints: Vec<Value> = (self.joints.iter().enumerate())
            .map(|(k, [x, y])| json!({ "name": format!("{k}"), "x": x, "y": y }))
            .collect();
        let member = |(k, m): (usize, &Member)| {
            let [from, to] = m.joints.map(|j| j.to_string());
            let hinges: Vec<&str> =
                ["from", "to"].into_iter().zip(m.hinges).filter(|h| h.1).map(|h| h.0).collect();
            json!({ "name": format!("m{k}"), "from": from, "to": to, "cells": m.cells, "hinges": hinges,
                    "stiffness": stiffness(&m.stiffness) })
        };
        let members: Vec<Value> = self.members.iter().enumerate().map(member).collect();
        let mut supports: Vec<Value> = Vec::new();
        for s in &self.supports {
            let at = json!({ "joint": s.joint.to_string() });
            supports.push(match s.degrees {
                None => json!({ "at": at, "phi": s.value }),
                Some(0.0) => json!({ "at": at, "ux": s.value }),
                Some(90.0) => json!({ "at": at, "uy": s.value }),
                Some(degrees) => {
                    json!({ "at": at, "inclined": { "degrees": degrees, "displacement": s.value } })
                }
            });
        }
        supports.extend(self.springs.iter().map(|(joint, [x, y, turn])| {
            json!({ "at": { "joint": joint.to_string() }, "ux_spring": x, "uy_spring": y, "phi_spring": turn })
        }));
        let mut loads: Vec<Value> = Vec::new();
        for (k, [x, y, moment]) in self.loads.iter().enumerate() {
            let at = json!({ "joint": k.to_string() });
            loads.push(json!({ "point": { "at": at, "force_x": x, "force_y": y, "moment": moment } }));
        }
        for (k, m) in self.members.iter().enumerate() {
            let mut load = json!({ "member": format!("m{k}"), "force": uniform(m.load[0]) });
            if m.load[1] != 0.0 {
                load["axial"] = uniform(m.load[1]);
            }
            loads.push(json!({ "distributed": load }));
        }
        json!({
            "title": "test", "model": { "timoshenko_beam": { "stiffness": stiffness(&[1.0, 1.0, 1.0]), "bond_law": "exact" } },
            "body": { "frame": { "joints": joints, "members": members } }, "supports": supports, "loads": loads
        })
    }

    /// Numbers of the unknowns of the two ends of a member.
    fn unknowns(&self, member: usize) -> [usize; 6] {
        let m = &self.members[member];
        let mut numbers = [0; 6];
        for side in 0..2 {
            let own = 3 * self.joints.len() + 2 * member + side;
            let turn = if m.hinges[side] { own } else { 3 * m.joints[side] + 2 };
            let at = [3 * m.joints[side], 3 * m.joints[side] + 1, turn];
            numbers[3 * side..3 * side + 3].copy_from_slice(&at);
        }
        numbers
    }

    /// Stiffness in the axes of a member, its rotation into them, and the fixed-end forces of its loads.
    fn element(&self, m: &Member) -> (Matrix6<f64>, Matrix6<f64>, Vector6<f64>) {
        let (l, [c, s]) = self.line(m);
        let [bending, shear, axial] = m.stiffness;
        let phi = 12.0 * bending / (shear * l * l);
        let a = bending / (l * l * l * (1.0 + phi));
        let mut k = Matrix6::zeros();
        k[(0, 0)] = axial / l;
        k[(3, 3)] = axial / l;
        k[(0, 3)] = -axial / l;
        k[(3, 0)] = -axial / l;
        let b = [
            [12.0, 6.0 * l, -12.0, 6.0 * l],
            [6.0 * l, (4.0 + phi) * l * l, -6.0 * l, (2.0 - phi) * l * l],
            [-12.0, -6.0 * l, 12.0, -6.0 * l],
            [6.0 * l, (2.0 - phi) * l * l, -6.0 * l, (4.0 + phi) * l * l],
        ];
        for (i, &p) in [1, 2, 4, 5].iter().enumerate() {
            for (j, &q) in [1, 2, 4, 5].iter().enumerate() {
                k[(p, q)] = a * b[i][j];
            }
        }
        let mut turn = Matrix6::zeros();
        for o in [0, 3] {
            (turn[(o, o)], turn[(o, o + 1)], turn[(o + 1, o)]) = (c, s, -s);
            (turn[(o + 1, o + 1)], turn[(o + 2, o + 2)]) = (c, 1.0);
        }
        let [q, p] = m.load;
        let (half, end) = (0.5 * l, q * l * l / 12.0);
        (k, turn, Vector6::new(p * half, q * half, end, p * half, q * half, -end))
    }

    /// Solves the frame.
    pub(crate) fn answer(&self) -> Answer {
        let n = 3 * self.joints.len() + 2 * self.members.len();
        let size = n + self.supports.len();
        let (mut a, mut f) = (DMatrix::<f64>::zeros(size, size), DVector::<f64>::zeros(size));
        for (number, member) in self.members.iter().enumerate() {
            let (k, turn, load) = self.element(member);
            let (k, load) = (turn.transpose() * k * turn, turn.transpose() * load);
            let at = self.unknowns(number);
            for i in 0..6 {
                f[at[i]] += load[i];
                (0..6).for_each(|j| a[(at[i], at[j])] += k[(i, j)]);
            }
        }
        // Rotations of ends without hinges, and of joints all of whose ends are hinged, are nobody's.
        for i in 0..n {
            if (0..n).all(|j| a[(i, j)] == 0.0) {
                a[(i, i)] = 1.0;
            }
        }
        for (k, load) in self.loads.iter().enumerate() {
            (0..3).for_each(|c| f[3 * k + c] += load[c]);
        }
        for (k, stiffness) in &self.springs {
            (0..3).for_each(|c| a[(3 * k + c, 3 * k + c)] += stiffness[c]);
        }
        for (number, s) in self.supports.iter().enumerate() {
            let shares = s.degrees.map_or([0.0, 0.0, 1.0], |d| {
                let (sin, cos) = d.to_radians().sin_cos();
                [cos, sin, 0.0]
            });
            for c in 0..3 {
                a[(n + number, 3 * s.joint + c)] = shares[c];
                // The multiplier is the force of the support on the frame.
                a[(3 * s.joint + c, n + number)] = -shares[c];
            }
            f[n + number] = s.value;
        }
        let lu = a.clone().full_piv_lu();
        let mut u = lu.solve(&f).expect("no mechanism");
        u += lu.solve(&(&f - &a * &u)).expect("no mechanism");
        let sections = (0..self.members.len()).map(|number| {
            let (k, turn, load) = self.element(&self.members[number]);
            let ends = Vector6::from_iterator(self.unknowns(number).into_iter().map(|i| u[i]));
            let q = k * (turn * ends) - load;
            [[-q[0], -q[1], -q[2]], [q[3], q[4], q[5]]]
        });
        Answer {
            displacements: (0..self.joints.len()).map(|k| [u[3 * k], u[3 * k + 1]]).collect(),
            reactions: (0..self.supports.len()).map(|k| u[n + k]).collect(),
            sections: sections.collect(),
        }
    }
}
