//! What the command says of a model.

/// A model as lists and starting cases have it.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Its key in cases.
    pub name: &'static str,
    /// What it is, in a sentence.
    pub about: &'static str,
    /// Bodies that it is for, each with the page of the guide that describes it.
    pub bodies: &'static [(&'static str, &'static str)],
    /// What can be chosen, and what that is.
    pub options: fn() -> Vec<(String, &'static str)>,
    /// Cases to begin with.
    pub starts: &'static [Start],
    /// How what a run costs grows with the points, which says on which coarser grid its error is estimated.
    pub growth: Growth,
}

/// A case to begin with.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    /// Name.
    pub name: &'static str,
    /// What it is, in a few words.
    pub about: &'static str,
    /// The case.
    pub case: &'static str,
}

/// What a coarser grid costs beside that of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Growth {
    /// In proportion to the points, along lines.
    Lines,
    /// Less than half at 3/2 times the spacing, a quarter at twice.
    Plane,
    /// As much as the run where no lattice is coarser still, at 3/2 times the spacing, by the couplings of whole families.
    Families,
}

/// Options as they are written.
pub(super) fn plain(options: &[(&str, &'static str)]) -> Vec<(String, &'static str)> {
    options.iter().map(|(name, about)| ((*name).to_string(), *about)).collect()
}
