//! Critical strains of a line from the energy that it takes to break through its section.

use super::{Chain, CriticalStrain};

impl Chain {
    /// Length l_c whose strain energy the bonds across one section hold, m: `h Σ n² α_n` of the ordinary bonds, 2 δ/3 for
    /// many neighbours. `None` where neighbours differ in distance.
    ///
    /// Under a uniform strain the bonds of n cells hold `n h α_n` times the energy per length, and n of them cross a
    /// section.
    pub fn energy_length(&self) -> Option<f64> {
        let share = |class: usize| (self.weights.step(class) as f64).powi(2) * self.weights.of_class(class);
        let sum: f64 = (0..self.weights.classes()).map(share).sum();
        self.line().stations.is_none().then_some(self.spacing * sum)
    }
}

impl CriticalStrain {
    /// Strains under which the bonds that cross a section of a line hold so much energy per area of the section, J/m²:
    ///
    /// ```text
    /// ½ EI κ_c² l_c = ½ S γ_c² l_c = G_c A
    /// ```
    ///
    /// `None` where cells or sections vary.
    pub fn of_energy(energy_release_rate: f64, chain: &Chain) -> Option<Self> {
        let (bending, shear) = chain.line().stiffness.plain()?;
        let energy = 2.0 * energy_release_rate * chain.line().stiffness.area / chain.energy_length()?;
        Some(Self { curvature: (energy / bending).sqrt(), shear_strain: (energy / shear).sqrt() })
    }
}
