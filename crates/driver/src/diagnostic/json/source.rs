//! From tokens to what `serde` asks for. What depends on no type is distinguished from what does: every type has its own copy
//! of the latter.

use super::super::data::VARIANT;
use super::Fault;
use super::access::{Elements, Entries, Name, Variant};
use super::lex::{Source, Token};
use serde::Deserializer;
use serde::de::{Error, Expected, Visitor};

fn misfit(token: &Token, expected: &dyn Expected) -> Fault {
    Fault::invalid_type(token.unexpected(), expected)
}

/// Visits a token that is no list and no object.
fn simple<'de, V: Visitor<'de>>(token: Token<'de>, visitor: V) -> Result<V::Value, Fault> {
    match token {
        Token::Null => visitor.visit_unit(),
        Token::Bool(value) => visitor.visit_bool(value),
        Token::Unsigned(value) => visitor.visit_u64(value),
        Token::Signed(value) => visitor.visit_i64(value),
        Token::Float(value) => visitor.visit_f64(value),
        Token::Text(text) => visitor.visit_str(&text),
        Token::List | Token::Object => Err(misfit(&token, &visitor)),
    }
}

impl<'de> Source<'de> {
    /// Visits the elements of a list whose bracket is read.
    fn list<V: Visitor<'de>>(&mut self, visitor: V) -> Result<V::Value, Fault> {
        let mut elements = Elements::new(self);
        let value = visitor.visit_seq(&mut elements)?;
        elements.finish().map(|()| value)
    }

    /// Visits the entries of an object whose bracket is read.
    fn object<V: Visitor<'de>>(&mut self, visitor: V) -> Result<V::Value, Fault> {
        let mut entries = Entries::new(self);
        let value = visitor.visit_map(&mut entries)?;
        entries.finish().map(|()| value)
    }

    fn only_simple<V: Visitor<'de>>(&mut self, visitor: V) -> Result<V::Value, Fault> {
        simple(self.token()?, visitor)
    }

    pub(super) fn only_list<V: Visitor<'de>>(&mut self, visitor: V) -> Result<V::Value, Fault> {
        match self.token()? {
            Token::List => self.list(visitor),
            other => Err(misfit(&other, &visitor)),
        }
    }

    /// An object; the order of what a type holds is nobody's business, so that a list is none.
    pub(super) fn structure<V: Visitor<'de>>(&mut self, visitor: V) -> Result<V::Value, Fault> {
        match self.token()? {
            Token::Object => self.object(visitor),
            other => Err(misfit(&other, &visitor)),
        }
    }
}

/// Methods that ask for one kind of value.
macro_rules! ask {
    ($($method:ident)* => $kind:ident) => {
        $(fn $method<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
            self.$kind(visitor)
        })*
    };
}

impl<'de> Deserializer<'de> for &mut Source<'de> {
    type Error = Fault;

    ask! {
        deserialize_bool deserialize_i8 deserialize_i16 deserialize_i32 deserialize_i64 deserialize_u8 deserialize_u16
        deserialize_u32 deserialize_u64 deserialize_f32 deserialize_f64 deserialize_char deserialize_str
        deserialize_string deserialize_unit deserialize_identifier => only_simple
    }

    ask! { deserialize_seq deserialize_bytes deserialize_byte_buf => only_list }

    ask! { deserialize_map => structure }

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.token()? {
            Token::Object => self.object(visitor),
            Token::List => self.list(visitor),
            other => simple(other, visitor),
        }
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        self.deserialize_any(visitor)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        if self.peek() == Some(b'n') { self.only_simple(visitor) } else { visitor.visit_some(self) }
    }

    fn deserialize_unit_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        self.only_simple(visitor)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, _: usize, visitor: V) -> Result<V::Value, Fault> {
        self.only_list(visitor)
    }

    fn deserialize_tuple_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: usize,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        self.only_list(visitor)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        self.structure(visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        match self.token()? {
            Token::Text(name) => visitor.visit_enum(Name(name)),
            Token::Object => {
                let name = Variant::name(self)?;
                let value = visitor.visit_enum(Variant { source: self, name })?;
                self.end_variant().map(|()| value)
            }
            other => Err(misfit(&other, &format!("{VARIANT}{}", variants.join(" ")).as_str())),
        }
    }
}
