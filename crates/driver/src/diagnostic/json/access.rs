//! What is inside lists, objects and enums.

use super::Fault;
use super::lex::Source;
use serde::de::value::CowStrDeserializer;
use serde::de::{
    Deserialize, DeserializeSeed, EnumAccess, Error, IgnoredAny, MapAccess, SeqAccess, Unexpected,
    VariantAccess, Visitor,
};
use std::borrow::Cow;

/// The elements of a list.
pub(super) struct Elements<'a, 'de> {
    source: &'a mut Source<'de>,
    count: usize,
    is_done: bool,
}

impl<'a, 'de> Elements<'a, 'de> {
    pub(super) fn new(source: &'a mut Source<'de>) -> Self {
        Self { source, count: 0, is_done: false }
    }

    fn advance(&mut self) -> Result<bool, Fault> {
        self.is_done = self.is_done || !self.source.has_another(b']', self.count == 0)?;
        Ok(!self.is_done)
    }

    /// Refuses elements that nobody has asked for.
    pub(super) fn finish(mut self) -> Result<(), Fault> {
        let wanted = self.count;
        while self.advance()? {
            IgnoredAny::deserialize(&mut *self.source)?;
            self.count += 1;
        }
        match self.count == wanted {
            true => Ok(()),
            false => {
                let expected = format!("an array of length {wanted}");
                Err(Fault::invalid_length(self.count, &expected.as_str()))
            }
        }
    }
}

impl<'de> SeqAccess<'de> for &mut Elements<'_, 'de> {
    type Error = Fault;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Fault> {
        if !self.advance()? {
            return Ok(None);
        }
        let value = seed.deserialize(&mut *self.source).map_err(|fault| fault.at_index(self.count))?;
        self.count += 1;
        Ok(Some(value))
    }
}

/// The entries of an object.
pub(super) struct Entries<'a, 'de> {
    source: &'a mut Source<'de>,
    key: Option<Cow<'de, str>>,
    is_done: bool,
}

impl<'a, 'de> Entries<'a, 'de> {
    pub(super) fn new(source: &'a mut Source<'de>) -> Self {
        Self { source, key: None, is_done: false }
    }

    fn advance(&mut self) -> Result<Option<Cow<'de, str>>, Fault> {
        self.is_done = self.is_done || !self.source.has_another(b'}', self.key.is_none())?;
        if self.is_done {
            return Ok(None);
        }
        self.source.peek();
        let key = self.source.string()?;
        self.key = Some(key.clone());
        Ok(Some(key))
    }

    /// A fault of the last key or its value.
    fn locate(&self, fault: Fault) -> Fault {
        fault.at_key(self.key.as_deref().unwrap_or_default())
    }

    /// Refuses entries that nobody has asked for.
    pub(super) fn finish(mut self) -> Result<(), Fault> {
        match self.advance()? {
            None => Ok(()),
            Some(_) => Err(Fault::custom("invalid length, expected fewer elements in map")),
        }
    }
}

impl<'de> MapAccess<'de> for &mut Entries<'_, 'de> {
    type Error = Fault;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Fault> {
        let Some(key) = self.advance()? else { return Ok(None) };
        let found = seed.deserialize(CowStrDeserializer::<Fault>::new(key));
        found.map(Some).map_err(|fault| self.locate(fault))
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Fault> {
        self.source.expect(b':')?;
        seed.deserialize(&mut *self.source).map_err(|fault| self.locate(fault))
    }
}

/// A variant as its name alone.
pub(super) struct Name<'de>(pub(super) Cow<'de, str>);

impl Name<'_> {
    fn lacks(&self, what: &'static str) -> Fault {
        Fault::invalid_type(Unexpected::UnitVariant, &what).at_key(&self.0)
    }
}

impl<'de> EnumAccess<'de> for Name<'de> {
    type Error = Fault;
    type Variant = Self;

    fn variant_seed<V: DeserializeSeed<'de>>(self, seed: V) -> Result<(V::Value, Self), Fault> {
        Ok((seed.deserialize(CowStrDeserializer::<Fault>::new(self.0.clone()))?, self))
    }
}

impl<'de> VariantAccess<'de> for Name<'de> {
    type Error = Fault;

    fn unit_variant(self) -> Result<(), Fault> {
        Ok(())
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, _: T) -> Result<T::Value, Fault> {
        Err(self.lacks("newtype variant"))
    }

    fn tuple_variant<V: Visitor<'de>>(self, _: usize, _: V) -> Result<V::Value, Fault> {
        Err(self.lacks("tuple variant"))
    }

    fn struct_variant<V: Visitor<'de>>(self, _: &'static [&'static str], _: V) -> Result<V::Value, Fault> {
        Err(self.lacks("struct variant"))
    }
}

/// A variant as an object of one key, which is read.
pub(super) struct Variant<'a, 'de> {
    pub(super) source: &'a mut Source<'de>,
    pub(super) name: Cow<'de, str>,
}

fn not_one_key() -> Fault {
    Fault::invalid_value(Unexpected::Map, &"map with a single key")
}

impl<'de> Source<'de> {
    /// The object of a variant ends.
    pub(super) fn end_variant(&mut self) -> Result<(), Fault> {
        if self.has_another(b'}', false)? { Err(not_one_key()) } else { Ok(()) }
    }
}

impl<'de> Variant<'_, 'de> {
    /// The key of an object whose bracket is read.
    pub(super) fn name(source: &mut Source<'de>) -> Result<Cow<'de, str>, Fault> {
        if !source.has_another(b'}', true)? {
            return Err(not_one_key());
        }
        source.peek();
        source.string()
    }

    fn value<T>(self, read: impl FnOnce(&mut Source<'de>) -> Result<T, Fault>) -> Result<T, Fault> {
        read(self.source).map_err(|fault| fault.at_key(&self.name))
    }
}

impl<'de> EnumAccess<'de> for Variant<'_, 'de> {
    type Error = Fault;
    type Variant = Self;

    fn variant_seed<V: DeserializeSeed<'de>>(self, seed: V) -> Result<(V::Value, Self), Fault> {
        let variant = seed.deserialize(CowStrDeserializer::<Fault>::new(self.name.clone()))?;
        self.source.expect(b':')?;
        Ok((variant, self))
    }
}

impl<'de> VariantAccess<'de> for Variant<'_, 'de> {
    type Error = Fault;

    fn unit_variant(self) -> Result<(), Fault> {
        self.value(|source| <()>::deserialize(source))
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, Fault> {
        self.value(|source| seed.deserialize(source))
    }

    fn tuple_variant<V: Visitor<'de>>(self, _: usize, visitor: V) -> Result<V::Value, Fault> {
        self.value(|source| source.only_list(visitor))
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        self.value(|source| source.structure(visitor))
    }
}
