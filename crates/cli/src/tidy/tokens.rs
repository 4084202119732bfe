//! The words of a JSON text with comments, and where its lines break.

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// `{` or `[`.
    Open,
    /// `}` or `]`.
    Close,
    /// `,`.
    Comma,
    /// `:`.
    Colon,
    /// A string, number or word, or a key.
    Scalar,
    /// `// …` or `/* … */`.
    Comment,
}

/// A piece of the text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Token<'a> {
    pub(super) kind: Kind,
    pub(super) text: &'a str,
    /// Line breaks between it and the one before.
    pub(super) breaks: usize,
}

/// The tokens of a text that is JSON but for comments and trailing commas.
pub(super) fn tokens(text: &str) -> Vec<Token<'_>> {
    let mut tokens = Vec::new();
    let mut rest = text;
    loop {
        let next = rest.trim_start_matches([' ', '\t', '\n', '\r']);
        let blank = &rest[..rest.len() - next.len()];
        let breaks = blank.matches('\n').count();
        let Some(sign) = next.chars().next() else { return tokens };
        let (kind, length) = match sign {
            '{' | '[' => (Kind::Open, 1),
            '}' | ']' => (Kind::Close, 1),
            ',' => (Kind::Comma, 1),
            ':' => (Kind::Colon, 1),
            '"' => (Kind::Scalar, string(next)),
            '/' => (Kind::Comment, comment(next)),
            _ => (Kind::Scalar, word(next)),
        };
        let (token, after) = next.split_at(length);
        tokens.push(Token { kind, text: token.trim_end(), breaks });
        rest = after;
    }
}

/// The length of the string that begins here.
fn string(text: &str) -> usize {
    let mut escaped = true;
    let end = text.find(|c| {
        let ends = c == '"' && !escaped;
        // The first quote opens.
        escaped = c == '\\' && !escaped;
        ends
    });
    end.map_or(text.len(), |end| end + 1)
}

fn comment(text: &str) -> usize {
    match text.starts_with("/*") {
        true => text.get(2..).and_then(|inside| inside.find("*/")).map_or(text.len(), |end| end + 4),
        false => text.find('\n').unwrap_or(text.len()),
    }
}

fn word(text: &str) -> usize {
    text.find([' ', '\t', '\n', '\r', '{', '}', '[', ']', ',', ':', '"', '/']).unwrap_or(text.len())
}

#[cfg(test)]
mod tests {
    use super::tokens;

    #[test]
    fn texts_and_comments_are_one_token_each() {
        let words = |text: &'static str| tokens(text).iter().map(|t| (t.text, t.breaks)).collect::<Vec<_>>();
        assert_eq!(
            words("{\"a\\\"//\": -1e5/**/, // b, \n\n[\"\"]"),
            [
                ("{", 0),
                ("\"a\\\"//\"", 0),
                (":", 0),
                ("-1e5", 0),
                ("/**/", 0),
                (",", 0),
                ("// b,", 0),
                ("[", 2),
                ("\"\"", 0),
                ("]", 0)
            ]
        );
        assert_eq!(words("\"\\\\\" /* é\n */ 1 /"), [("\"\\\\\"", 0), ("/* é\n */", 0), ("1", 0), ("/", 0)]);
    }
}
