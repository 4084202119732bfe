//! How much a material stretches by heat.

use crate::case::{Case, Expansion};
use crate::diagnostic::{Faults, JsonPath, root};

/// The expansion that a case gives, with a fault at the load that needs it where there is none, or where it is another material's.
pub(super) fn of(case: &Case, has_fibres: bool, path: &JsonPath, faults: &mut Faults) -> Option<Expansion> {
    let given = case.thermal_expansion;
    if given.is_none() {
        faults
            .error(
                path.clone(),
                "`temperature` needs the `thermal_expansion` of the material, beside `model`",
            )
            .hint("strain per kelvin: steel has `\"thermal_expansion\": 1.2e-5`, aluminium 2.3e-5");
    }
    given.filter(|given| has_fibres || is_one(*given, &root("thermal_expansion"), faults))
}

/// Whether a material without fibres has one expansion; a fault where it has two.
pub(super) fn is_one(given: Expansion, path: &JsonPath, faults: &mut Faults) -> bool {
    let is_one = matches!(given, Expansion::Alike(_));
    if !is_one {
        faults
            .error(path.clone(), "a material without fibres has one `thermal_expansion`")
            .hint("give one number");
    }
    is_one
}
