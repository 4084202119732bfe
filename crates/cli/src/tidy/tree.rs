//! Values with the comments that belong to them.

use super::tokens::{Kind, Token, tokens};

/// A value of a list, of an object with its key, or the whole text.
#[derive(Debug, Default)]
pub(super) struct Member<'a> {
    /// Comments before it.
    pub(super) before: Vec<Comment<'a>>,
    /// Line breaks before it.
    pub(super) breaks: usize,
    /// Its key, quotes included.
    pub(super) key: Option<&'a str>,
    /// Comments between key and value.
    pub(super) between: Vec<&'a str>,
    /// Its value.
    pub(super) value: Value<'a>,
    /// Comments behind it, on its line.
    pub(super) after: Vec<&'a str>,
}

/// A comment before a member or at the end of a group.
#[derive(Debug)]
pub(super) struct Comment<'a> {
    pub(super) text: &'a str,
    /// Line breaks before it.
    pub(super) breaks: usize,
    /// Whether a line ends with it.
    pub(super) ends_line: bool,
}

/// A value.
#[derive(Debug)]
pub(super) enum Value<'a> {
    /// As it is written.
    Scalar(&'a str),
    /// An object or a list.
    Group(Group<'a>),
}

impl Default for Value<'_> {
    fn default() -> Self {
        Self::Scalar("")
    }
}

/// An object or a list.
#[derive(Debug)]
pub(super) struct Group<'a> {
    pub(super) open: &'a str,
    pub(super) close: &'a str,
    /// Comments behind the bracket that opens it, on its line.
    pub(super) first: Vec<&'a str>,
    pub(super) members: Vec<Member<'a>>,
    /// Comments before the bracket that closes it.
    pub(super) last: Vec<Comment<'a>>,
    /// Whether its author began a line behind its first bracket.
    pub(super) is_broken: bool,
}

/// The value of a text with the comments around it, and those at its end; nothing if the text is no JSON.
pub(super) fn tree(text: &str) -> Option<(Member<'_>, Vec<Comment<'_>>)> {
    let mut reader = Reader { tokens: tokens(text), at: 0 };
    let before = reader.comments();
    let mut root = reader.member(before)?;
    let behind = reader.comments();
    let last = split(behind, &mut root.after);
    reader.next().is_none().then_some((root, last))
}

struct Reader<'a> {
    tokens: Vec<Token<'a>>,
    at: usize,
}

impl<'a> Reader<'a> {
    fn next(&mut self) -> Option<Token<'a>> {
        let token = self.tokens.get(self.at).copied();
        self.at += 1;
        token
    }

    fn next_is(&self, kind: Kind) -> bool {
        self.tokens.get(self.at).is_some_and(|token| token.kind == kind)
    }

    /// The next token, if it is of this kind.
    fn take(&mut self, kind: Kind) -> Option<Token<'a>> {
        if self.next_is(kind) { self.next() } else { None }
    }

    /// Line breaks before the next token.
    fn breaks(&self) -> usize {
        self.tokens.get(self.at).map_or(1, |token| token.breaks)
    }

    /// The comments that come next.
    fn comments(&mut self) -> Vec<Comment<'a>> {
        let mut comments = Vec::new();
        while let Some(Token { text, breaks, .. }) = self.take(Kind::Comment) {
            comments.push(Comment { text, breaks, ends_line: self.breaks() > 0 });
        }
        comments
    }

    fn member(&mut self, before: Vec<Comment<'a>>) -> Option<Member<'a>> {
        let mut member = Member { before, breaks: self.breaks(), ..Member::default() };
        let mut token = self.next()?;
        let mut inside = self.comments_after_key(&token);
        if self.take(Kind::Colon).is_some() {
            member.key = Some(token.text);
            inside.extend(self.comments());
            token = self.next()?;
        }
        for comment in inside {
            // Behind it the line would end, and the value with it.
            match comment.text.starts_with("//") {
                true => member.before.push(Comment { ends_line: true, ..comment }),
                false => member.between.push(comment.text),
            }
        }
        member.value = match token.kind {
            Kind::Open => Value::Group(self.group(token.text)?),
            Kind::Scalar => Value::Scalar(token.text),
            _ => return None,
        };
        Some(member)
    }

    /// The comments between a key and its colon; those behind a value are left.
    fn comments_after_key(&mut self, token: &Token<'a>) -> Vec<Comment<'a>> {
        let ahead = self.tokens[self.at.min(self.tokens.len())..].iter().find(|t| t.kind != Kind::Comment);
        let is_key = token.kind == Kind::Scalar && ahead.is_some_and(|token| token.kind == Kind::Colon);
        if is_key { self.comments() } else { Vec::new() }
    }

    fn group(&mut self, open: &'a str) -> Option<Group<'a>> {
        let close = if open == "{" { "}" } else { "]" };
        let mut group =
            Group { open, close, first: vec![], members: vec![], last: vec![], is_broken: self.breaks() > 0 };
        let mut comments = self.comments();
        if comments.iter().take_while(|c| c.breaks == 0).last().is_some_and(|c| c.ends_line) {
            comments = split(comments, &mut group.first);
            group.is_broken = true;
        }
        while !self.next_is(Kind::Close) {
            let mut member = self.member(comments)?;
            comments = self.behind(&mut member);
            group.members.push(member);
        }
        self.next()?;
        group.last = comments;
        Some(group)
    }

    /// Takes the comma and the comments behind a member, and returns those of the next one.
    fn behind(&mut self, member: &mut Member<'a>) -> Vec<Comment<'a>> {
        let mut comments = self.comments();
        if self.take(Kind::Comma).is_none() {
            return split(comments, &mut member.after);
        }
        let of_next =
            comments.iter().position(|c| c.text.starts_with("//")).map_or(comments.len(), |k| k + 1);
        let mut rest = comments.split_off(of_next);
        let is_full = comments.last().is_some_and(|c| c.text.starts_with("//"));
        member.after.extend(comments.iter().map(|c| c.text));
        let behind_comma = self.comments();
        let end = behind_comma.iter().take_while(|c| c.breaks == 0).last().is_some_and(|c| c.ends_line);
        if is_full || !(end || self.next_is(Kind::Close)) {
            rest.extend(behind_comma);
            return rest;
        }
        rest.extend(split(behind_comma, &mut member.after));
        rest
    }
}

/// Moves the comments that stand on the line of what is before them; the others are left.
fn split<'a>(mut comments: Vec<Comment<'a>>, line: &mut Vec<&'a str>) -> Vec<Comment<'a>> {
    let end = comments.iter().position(|comment| comment.breaks > 0).unwrap_or(comments.len());
    let rest = comments.split_off(end);
    line.extend(comments.into_iter().map(|comment| comment.text));
    rest
}
