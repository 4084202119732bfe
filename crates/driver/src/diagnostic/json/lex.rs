//! From text to tokens.

use super::{Fault, LEVELS};
use serde::de::Unexpected;
use std::borrow::Cow;

/// A text that is being read.
pub(super) struct Source<'de> {
    text: &'de str,
    at: usize,
    level: u32,
}

/// A value without what is inside lists and objects, whose opening brackets are read.
pub(super) enum Token<'de> {
    Null,
    Bool(bool),
    Unsigned(u64),
    Signed(i64),
    Float(f64),
    Text(Cow<'de, str>),
    List,
    Object,
}

impl Token<'_> {
    /// What it is where something else is expected.
    pub(super) fn unexpected(&self) -> Unexpected<'_> {
        match self {
            Token::Null => Unexpected::Unit,
            Token::Bool(value) => Unexpected::Bool(*value),
            Token::Unsigned(value) => Unexpected::Unsigned(*value),
            Token::Signed(value) => Unexpected::Signed(*value),
            Token::Float(value) => Unexpected::Float(*value),
            Token::Text(text) => Unexpected::Str(text),
            Token::List => Unexpected::Seq,
            Token::Object => Unexpected::Map,
        }
    }
}

impl<'de> Source<'de> {
    pub(super) fn new(text: &'de str) -> Self {
        Self { text, at: 0, level: 0 }
    }

    /// Byte up to which the text was read.
    pub(super) fn at(&self) -> usize {
        self.at
    }

    fn byte(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// The next byte that is no white space, not yet read.
    pub(super) fn peek(&mut self) -> Option<u8> {
        while let Some(b' ' | b'\n' | b'\r' | b'\t') = self.byte() {
            self.at += 1;
        }
        self.byte()
    }

    /// Reads a byte after white space, if it is the one that is wanted.
    pub(super) fn accept(&mut self, wanted: u8) -> bool {
        let is_there = self.peek() == Some(wanted);
        self.at += usize::from(is_there);
        is_there
    }

    /// Reads a byte after white space.
    pub(super) fn expect(&mut self, wanted: u8) -> Result<(), Fault> {
        if self.accept(wanted) { Ok(()) } else { Err(Fault::syntax()) }
    }

    /// Whether there is another element before a closing bracket, which is read; commas stand between elements.
    pub(super) fn has_another(&mut self, close: u8, is_first: bool) -> Result<bool, Fault> {
        if self.accept(close) {
            self.level -= 1;
            return Ok(false);
        }
        if !is_first {
            self.expect(b',')?;
            if self.peek() == Some(close) {
                return Err(Fault::syntax());
            }
        }
        Ok(true)
    }

    /// Nothing but white space is left.
    pub(super) fn end(&mut self) -> Result<(), Fault> {
        if self.peek().is_none() { Ok(()) } else { Err(Fault::syntax()) }
    }

    pub(super) fn token(&mut self) -> Result<Token<'de>, Fault> {
        match self.peek() {
            Some(b'"') => self.string().map(Token::Text),
            Some(b'-' | b'0'..=b'9') => self.number(),
            Some(b'[') => self.open(Token::List),
            Some(b'{') => self.open(Token::Object),
            Some(b't') => self.word("true", Token::Bool(true)),
            Some(b'f') => self.word("false", Token::Bool(false)),
            Some(b'n') => self.word("null", Token::Null),
            _ => Err(Fault::syntax()),
        }
    }

    fn open(&mut self, token: Token<'de>) -> Result<Token<'de>, Fault> {
        self.at += 1;
        self.level += 1;
        if self.level > LEVELS { Err(Fault::syntax()) } else { Ok(token) }
    }

    fn word(&mut self, word: &str, token: Token<'de>) -> Result<Token<'de>, Fault> {
        if !self.text[self.at..].starts_with(word) {
            return Err(Fault::syntax());
        }
        self.at += word.len();
        Ok(token)
    }

    /// A string, at whose opening quote the text stands.
    pub(super) fn string(&mut self) -> Result<Cow<'de, str>, Fault> {
        if self.byte() != Some(b'"') {
            return Err(Fault::syntax());
        }
        let (open, mut is_plain) = (self.at, true);
        self.at += 1;
        loop {
            match self.byte() {
                Some(b'"') => break,
                Some(b'\\') => {
                    is_plain = false;
                    self.at += 2;
                }
                Some(byte) if byte >= b' ' => self.at += 1,
                _ => return Err(Fault::syntax()),
            }
        }
        self.at += 1;
        if is_plain {
            return Ok(self.text[open + 1..self.at - 1].into());
        }
        let quoted = self.text.get(open..self.at).ok_or_else(Fault::syntax)?;
        serde_json::from_str(quoted).map(Cow::Owned).map_err(|_| Fault::syntax())
    }

    /// Reads digits, at least one.
    fn digits(&mut self) -> Result<(), Fault> {
        let start = self.at;
        while self.byte().is_some_and(|byte| byte.is_ascii_digit()) {
            self.at += 1;
        }
        if self.at > start { Ok(()) } else { Err(Fault::syntax()) }
    }

    fn number(&mut self) -> Result<Token<'de>, Fault> {
        let (start, mut is_whole) = (self.at, true);
        self.at += usize::from(self.byte() == Some(b'-'));
        match self.byte() {
            Some(b'0') => self.at += 1,
            _ => self.digits()?,
        }
        if self.byte() == Some(b'.') {
            (self.at, is_whole) = (self.at + 1, false);
            self.digits()?;
        }
        if let Some(b'e' | b'E') = self.byte() {
            (self.at, is_whole) = (self.at + 1, false);
            self.at += usize::from(matches!(self.byte(), Some(b'+' | b'-')));
            self.digits()?;
        }
        // A digit here follows a leading zero.
        if self.byte().is_some_and(|byte| byte.is_ascii_digit()) {
            return Err(Fault::syntax());
        }
        let number = &self.text[start..self.at];
        if is_whole {
            if let Ok(value) = number.parse() {
                return Ok(Token::Unsigned(value));
            }
            // -0 is a double: no integer has its sign.
            if let Some(value) = number.parse().ok().filter(|&value| value != 0) {
                return Ok(Token::Signed(value));
            }
        }
        let value: Option<f64> = number.parse().ok();
        value.filter(|value| value.is_finite()).map(Token::Float).ok_or_else(Fault::syntax)
    }
}
