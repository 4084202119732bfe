//! Comments and trailing commas, which cases may have and JSON has not.

use std::borrow::Cow;

/// The text with a blank in place of every byte of a comment and of every trailing comma, so that each byte that is left
/// stands where it stood; line breaks stay. A comment without an end is left for the reader to refuse.
pub(crate) fn without_comments(text: &str) -> Cow<'_, str> {
    let blanks = blanks(text.as_bytes());
    if blanks.is_empty() {
        return Cow::Borrowed(text);
    }
    let mut plain = String::with_capacity(text.len());
    let mut done = 0;
    for (start, end) in blanks {
        plain.push_str(&text[done..start]);
        plain
            .extend(text[start..end].bytes().map(|b| if b == b'\n' || b == b'\r' { b as char } else { ' ' }));
        done = end;
    }
    plain.push_str(&text[done..]);
    Cow::Owned(plain)
}

/// Where comments and trailing commas stand, in order.
fn blanks(bytes: &[u8]) -> Vec<(usize, usize)> {
    let mut blanks = Vec::new();
    // The comma before which a value ended, while only blanks and comments have followed it.
    let mut comma: Option<(usize, usize)> = None;
    let mut after_value = false;
    let mut at = 0;
    while at < bytes.len() {
        let end = match bytes[at] {
            b'/' => match end_of_comment(bytes, at) {
                Some(end) => {
                    blanks.push((at, end));
                    at = end;
                    continue;
                }
                None => break,
            },
            b' ' | b'\t' | b'\n' | b'\r' => {
                at += 1;
                continue;
            }
            b'"' => end_of_string(bytes, at),
            _ => at + 1,
        };
        match bytes[at] {
            b'}' | b']' => {
                if let Some((place, index)) = comma {
                    blanks.insert(index, (place, place + 1));
                }
                (comma, after_value) = (None, true);
            }
            b',' => {
                comma = after_value.then_some((at, blanks.len()));
                after_value = false;
            }
            sign => (comma, after_value) = (None, !matches!(sign, b'{' | b'[' | b':')),
        }
        at = end;
    }
    blanks
}

/// The byte behind a comment that begins here.
fn end_of_comment(bytes: &[u8], at: usize) -> Option<usize> {
    let inside = bytes.get(at + 2..).unwrap_or_default();
    match bytes.get(at + 1)? {
        b'/' => Some(at + 2 + inside.iter().position(|&b| b == b'\n').unwrap_or(inside.len())),
        b'*' => inside.windows(2).position(|pair| pair == b"*/").map(|end| at + 2 + end + 2),
        _ => None,
    }
}

/// The byte behind a string that begins here, or the end of the text.
fn end_of_string(bytes: &[u8], start: usize) -> usize {
    let mut at = start + 1;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'"' => return at + 1,
            b'\\' => at += 2,
            _ => at += 1,
        }
    }
    bytes.len()
}

#[cfg(test)]
mod tests {
    use super::without_comments;
    use std::borrow::Cow;

    #[test]
    fn comments_and_trailing_commas_become_blanks() {
        for (text, plain) in [
            ("[1, // é\n 2]", "[1,      \n 2]"),
            ("[1 /* a\r\n, */ ]", "[1     \r\n     ]"),
            ("{\"a\": [1,], }", "{\"a\": [1 ]  }"),
            ("[1, /* last */ ] // end", "[1             ]       "),
            ("[1,\n // a\n // b,\n]", "[1 \n     \n      \n]"),
            ("[\"a\", {}, ]", "[\"a\", {}  ]"),
        ] {
            assert_eq!(without_comments(text), plain, "{text}");
        }
    }

    #[test]
    fn strings_and_faults_stay_as_they_are() {
        for text in [
            "{\"a\": \"http://b, ] /* */\"}",
            "{\"a\\\"//\": 1}",
            "[,]",
            "[1,,]",
            "{\"a\":,}",
            "[1 /* no end ]",
            "[1 / 2]",
            "[1] /",
            "\"\\",
        ] {
            assert!(matches!(without_comments(text), Cow::Borrowed(same) if same == text), "{text}");
        }
    }
}
