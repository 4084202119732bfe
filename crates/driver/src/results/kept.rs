//! Which files of fields a run writes.

/// The files of the fields at all points; what else a run writes is small.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FieldFiles {
    /// The states that have them.
    pub states: FieldStates,
    /// Whether there is a table of each, `.csv`.
    pub tables: bool,
    /// Whether there is a grid of each, `.vtu`.
    pub grids: bool,
}

impl Default for FieldFiles {
    fn default() -> Self {
        Self { states: FieldStates::All, tables: true, grids: true }
    }
}

/// States that have files of fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FieldStates {
    /// Every one.
    All,
    /// The last one, of a run that goes on the last one so far.
    Last,
    /// None.
    Nothing,
}

impl FieldFiles {
    /// The files of one state, which may be the last one or not.
    pub(super) fn of(self, may_be_last: bool) -> Self {
        let has = match self.states {
            FieldStates::All => true,
            FieldStates::Last => may_be_last,
            FieldStates::Nothing => false,
        };
        Self { tables: has && self.tables, grids: has && self.grids, ..self }
    }

    /// Extensions of these files.
    pub(super) fn extensions(self) -> impl Iterator<Item = &'static str> {
        [("csv", self.tables), ("vtu", self.grids)].into_iter().filter_map(|(name, has)| has.then_some(name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn states_and_kinds_of_files_are_chosen_apart() {
        let of = |states, tables, grids, last| {
            FieldFiles { states, tables, grids }.of(last).extensions().collect::<Vec<_>>()
        };
        assert_eq!(of(FieldStates::All, true, true, false), ["csv", "vtu"]);
        assert_eq!(of(FieldStates::All, false, true, false), ["vtu"]);
        assert_eq!(of(FieldStates::Last, true, false, true), ["csv"]);
        assert!(of(FieldStates::Last, true, true, false).is_empty());
        assert!(of(FieldStates::Nothing, true, true, true).is_empty());
    }
}
