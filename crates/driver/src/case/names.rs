//! Names as cases write them: one, or a list of several that are meant together.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserializer, Error, SeqAccess, Visitor};
use serde::{Deserialize, Serialize, Serializer};
use std::borrow::Cow;
use std::fmt;
use std::ops::Deref;

/// One name or several; what they name together is called by all of them, with commas between.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Names {
    text: String,
    list: Option<Vec<String>>,
}

impl Names {
    /// Every name.
    pub fn each(&self) -> &[String] {
        self.list.as_deref().unwrap_or(std::slice::from_ref(&self.text))
    }

    /// Whether they are written as a list.
    pub fn is_list(&self) -> bool {
        self.list.is_some()
    }
}

impl Deref for Names {
    type Target = str;

    fn deref(&self) -> &str {
        &self.text
    }
}

impl From<&str> for Names {
    fn from(name: &str) -> Self {
        Self { text: name.into(), list: None }
    }
}

impl From<Vec<String>> for Names {
    fn from(list: Vec<String>) -> Self {
        Self { text: list.join(", "), list: Some(list) }
    }
}

impl Serialize for Names {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match &self.list {
            Some(list) => list.serialize(serializer),
            None => self.text.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for Names {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct OneOrMore;

        impl<'de> Visitor<'de> for OneOrMore {
            type Value = Names;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a name, or a list of names")
            }

            fn visit_str<E: Error>(self, name: &str) -> Result<Names, E> {
                Ok(name.into())
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Names, A::Error> {
                let mut list: Vec<String> = Vec::new();
                while let Some(name) = seq.next_element()? {
                    list.push(name);
                }
                match list.is_empty() {
                    true => Err(A::Error::custom("this list of names is empty")),
                    false => Ok(list.into()),
                }
            }
        }

        deserializer.deserialize_any(OneOrMore)
    }
}

impl JsonSchema for Names {
    fn schema_name() -> Cow<'static, str> {
        "Names".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": ["string", "array"], "items": { "type": "string" }, "minItems": 1 })
    }
}

#[cfg(test)]
mod tests {
    use super::Names;

    #[test]
    fn one_name_and_several_are_read_and_written_alike() {
        for text in [r#""top""#, r#"["top"]"#, r#"["top","arc"]"#] {
            let names: Names = serde_json::from_str(text).unwrap();
            assert_eq!(serde_json::to_string(&names).unwrap(), text);
        }
        let names: Names = serde_json::from_str(r#"["top","arc"]"#).unwrap();
        assert_eq!((&*names, names.each().len(), names.is_list()), ("top, arc", 2, true));
        assert!(serde_json::from_str::<Names>("[]").is_err() && serde_json::from_str::<Names>("1").is_err());
    }
}
