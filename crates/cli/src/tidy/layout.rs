//! Where lines break.

use super::tree::{Comment, Group, Member, Value};

/// Longest line on which an object or a list with values inside stands whole.
const WIDTH: usize = 160;
/// What a long text counts for in that: no break makes it shorter.
const TEXT: usize = 20;
const INDENT: usize = 2;

/// The text of a value with its comments and those at its end.
pub(super) fn layout(root: &Member, last: &[Comment]) -> String {
    let mut writer = Writer { out: String::new(), indent: 0 };
    writer.before(root);
    match &root.value {
        Value::Group(group) if !group.members.is_empty() => writer.broken(group),
        value => writer.value(value, 0),
    }
    writer.after(&root.after);
    writer.last(last, false);
    writer.out.push('\n');
    writer.out
}

/// A value on one line, and its width.
struct Flat {
    text: String,
    width: usize,
}

impl Flat {
    fn add(&mut self, text: &str) {
        self.text.push_str(text);
        self.width += text.chars().count();
    }

    /// Adds comments, unless they need lines of their own.
    fn comment(&mut self, text: &str) -> Option<()> {
        (!text.starts_with("//") && !text.contains('\n')).then(|| self.add(text))
    }
}

/// A value on one line, if it may stand so.
fn flat(value: &Value) -> Option<Flat> {
    let mut out = Flat { text: String::new(), width: 0 };
    add(value, &mut out)?;
    Some(out)
}

fn add(value: &Value, out: &mut Flat) -> Option<()> {
    let group = match value {
        Value::Scalar(text) => {
            out.text.push_str(text);
            out.width += text.chars().count().min(TEXT);
            return Some(());
        }
        Value::Group(group) => group,
    };
    if group.is_broken && !is_row(group) && !group.members.is_empty() || !group.first.is_empty() {
        return None;
    }
    out.add(group.open);
    let is_spaced = !group.members.iter().all(|m| is_narrow(group, m)) || !group.last.is_empty();
    out.add(if is_spaced { " " } else { "" });
    for (k, member) in group.members.iter().enumerate() {
        out.add(if k > 0 { ", " } else { "" });
        add_member(member, out)?;
    }
    for (k, comment) in group.last.iter().enumerate() {
        // Behind a member there is none but on a line of its own.
        (comment.breaks == 0 && group.members.is_empty()).then_some(())?;
        out.add(if k > 0 { " " } else { "" });
        out.comment(comment.text)?;
    }
    out.add(if is_spaced { " " } else { "" });
    out.add(group.close);
    Some(())
}

fn add_member(member: &Member, out: &mut Flat) -> Option<()> {
    for comment in &member.before {
        (!comment.ends_line).then_some(())?;
        out.comment(comment.text)?;
        out.add(" ");
    }
    if let Some(key) = member.key {
        out.add(key);
        out.add(": ");
    }
    for comment in &member.between {
        out.comment(comment)?;
        out.add(" ");
    }
    add(&member.value, out)?;
    for comment in &member.after {
        out.add(" ");
        out.comment(comment)?;
    }
    Some(())
}

/// Whether a member stands beside the bracket of its list: a number, a text, a list.
fn is_narrow(group: &Group, member: &Member) -> bool {
    let is_object = matches!(&member.value, Value::Group(inside) if inside.open == "{");
    group.open == "[" && !is_object
}

/// Whether these are plain numbers, texts and words, which stand in a row wherever their author broke it.
fn is_row(group: &Group) -> bool {
    group.open == "[" && group.members.iter().all(|m| matches!(m.value, Value::Scalar(_)))
}

/// The members of a list that fill lines: numbers, texts and rows of them, without comments.
fn filling(group: &Group) -> Option<Vec<Flat>> {
    let has_comments = |m: &Member| !m.before.is_empty() || !m.after.is_empty();
    let is_plain = |m: &Member| match &m.value {
        Value::Scalar(_) => true,
        Value::Group(inside) => is_row(inside),
    };
    let one_by_one = !is_row(group) && group.is_broken && group.members.iter().all(|m| m.breaks > 0);
    let fills = group.open == "["
        && group.members.len() > 1
        && group.first.is_empty()
        && !one_by_one
        && group.members.iter().all(|m| is_plain(m) && !has_comments(m));
    if !fills {
        return None;
    }
    group.members.iter().map(|m| flat(&m.value)).collect()
}

struct Writer {
    out: String,
    indent: usize,
}

impl Writer {
    /// Ends the line, with an empty one if there were more breaks than one.
    fn line(&mut self, breaks: usize) {
        self.out.push_str(if breaks > 1 { "\n\n" } else { "\n" });
        self.out.extend(std::iter::repeat_n(' ', INDENT * self.indent));
    }

    fn column(&self) -> usize {
        let start = self.out.rfind('\n').map_or(0, |at| at + 1);
        self.out[start..].chars().count()
    }

    /// Writes a value where so many characters follow on its line.
    fn value(&mut self, value: &Value, behind: usize) {
        match (flat(value), value) {
            (Some(flat), Value::Group(group))
                if self.column() + flat.width + behind > WIDTH && !group.members.is_empty() =>
            {
                self.broken(group);
            }
            (Some(flat), _) => self.out.push_str(&flat.text),
            (None, Value::Group(group)) => self.broken(group),
            (None, Value::Scalar(text)) => self.out.push_str(text),
        }
    }

    /// Writes a group over several lines.
    fn broken(&mut self, group: &Group) {
        self.out.push_str(group.open);
        self.after(&group.first);
        self.indent += 1;
        match filling(group) {
            Some(members) => self.fill(&members),
            None => self.members(&group.members),
        }
        self.last(&group.last, group.members.is_empty());
        self.indent -= 1;
        self.line(1);
        self.out.push_str(group.close);
    }

    fn fill(&mut self, members: &[Flat]) {
        self.line(1);
        for (k, member) in members.iter().enumerate() {
            if k > 0 {
                self.out.push(',');
                // A comma follows it.
                match self.column() + 1 + member.width < WIDTH {
                    true => self.out.push(' '),
                    false => self.line(1),
                }
            }
            self.out.push_str(&member.text);
        }
    }

    fn members(&mut self, members: &[Member]) {
        for (k, member) in members.iter().enumerate() {
            let breaks = member.before.first().map_or(member.breaks, |comment| comment.breaks);
            self.line(if k > 0 { breaks } else { 1 });
            self.before(member);
            if let Some(key) = member.key {
                self.out.push_str(key);
                self.out.push_str(": ");
            }
            for comment in &member.between {
                self.out.push_str(comment);
                self.out.push(' ');
            }
            let is_last = k + 1 == members.len();
            self.value(&member.value, usize::from(!is_last));
            self.out.push_str(if is_last { "" } else { "," });
            self.after(&member.after);
        }
    }

    /// Comments before a member, up to where it begins.
    fn before(&mut self, member: &Member) {
        for (k, comment) in member.before.iter().enumerate() {
            self.out.push_str(comment.text);
            let breaks = member.before.get(k + 1).map_or(member.breaks, |next| next.breaks);
            match comment.ends_line {
                true => self.line(breaks),
                false => self.out.push(' '),
            }
        }
    }

    /// Comments at the end of a group or of the text, on lines of their own.
    fn last(&mut self, comments: &[Comment], is_first: bool) {
        for (k, comment) in comments.iter().enumerate() {
            self.line(if is_first && k == 0 { 1 } else { comment.breaks });
            self.out.push_str(comment.text);
        }
    }

    /// Comments behind what is on the line.
    fn after(&mut self, comments: &[&str]) {
        for comment in comments {
            self.out.push(' ');
            self.out.push_str(comment);
        }
    }
}
