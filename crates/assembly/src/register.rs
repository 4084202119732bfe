//! A folder of variants and its table, from one line per variant.

/// Declares one module per name and a `TABLE` of their `ENTRY` constants, in the order written.
///
/// A new variant is then one file, which defines `ENTRY`, and one line here. `rustfmt` does not follow modules that a
/// macro declares, so the format check of `.ci/run` names every tracked file.
#[macro_export]
macro_rules! register {
    ($(#[$doc:meta])* $entry:ty: $($name:ident),+ $(,)?) => {
        $(mod $name;)+
        $(#[$doc])*
        pub const TABLE: &[$entry] = &[$($name::ENTRY),+];
    };
}
