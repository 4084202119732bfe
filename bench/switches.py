"""Many mutants in one program: every mutated place asks at run time whether its mutant is the one that is switched on.

A mutant of an operator takes the text around it that the operator can rebind: up to a bracket, a comma, a keyword or an
operator that binds less than any that may stand in its place. Of `x + a * b < c`, which has one mutant, becomes

    (if crate::switch::on(7) { x + a / b < c } else { x + a * b < c })

Lines stay where they are, so that the errors of the compiler tell which mutants cannot be held.
"""
import re

TOKEN = re.compile(
    r"(?P<blank>\s+|//[^\n]*|/\*.*?\*/)"
    r'|b?r(?P<hashes>#*)".*?"(?P=hashes)'
    r'|b?"(?:\\.|[^"\\])*"'
    r"|b?'(?:\\[^']+|[^\\'])'|'\w+"
    r"|\d\w*(?:\.\d\w*)?|\w+"
    r"|<<=|>>=|\.\.=|&&|\|\||==|!=|<=|>=|=>|->|::|\.\.|[-+*/%^&|]=|<<|>>|.",
    re.DOTALL,
)
OPEN, CLOSE = "([{", ")]}"
BOUNDS = set("; , : { | || = => .. ..=".split()) | set("if else match while for in return break let move".split())
ASSIGNMENTS = {f"{operator}=" for operator in "+ - * / % ^ & | << >>".split()}
MODULE = """
#[doc(hidden)]
#[allow(missing_docs, warnings, clippy::all)]
pub mod switch {
    use std::env::var;
    use std::io::Write;
    use std::sync::atomic::{AtomicBool, AtomicU32, Ordering::Relaxed};
    const RECORD: u32 = u32::MAX - 1;
    const UNSET: u32 = u32::MAX;
    static ACTIVE: AtomicU32 = AtomicU32::new(UNSET);
    static REACHED: [AtomicBool; COUNT] = [const { AtomicBool::new(false) }; COUNT];

    #[inline(always)]
    pub fn on(mutant: u32) -> bool {
        let active = ACTIVE.load(Relaxed);
        if active >= RECORD { reached(mutant) } else { active == mutant }
    }

    #[cold]
    fn reached(mutant: u32) -> bool {
        if REACHED[mutant as usize].load(Relaxed) {
            return false;
        }
        let Ok(file) = var("REACHED") else {
            let active = var("MUTANT").map_or(RECORD - 1, |text| text.parse().expect("a number"));
            ACTIVE.store(active, Relaxed);
            return active == mutant;
        };
        ACTIVE.store(RECORD, Relaxed);
        if !REACHED[mutant as usize].swap(true, Relaxed) {
            let mut file = std::fs::OpenOptions::new().create(true).append(true).open(file).expect("a file");
            file.write_all(format!("{mutant}\\n").as_bytes()).expect("a file to write");
        }
        false
    }
}
"""


def place(text, position):
    """The offset of a line and column, which count from one."""
    start = 0
    for _ in range(position["line"] - 1):
        start = text.index("\n", start) + 1
    return start + position["column"] - 1


def ends(text, mutant):
    """The offsets of the text that a mutant replaces."""
    return tuple(place(text, mutant["span"][end]) for end in ("start", "end"))


def mutated(text, mutant):
    """The file with the span of the mutant replaced."""
    first, last = ends(text, mutant)
    return text[:first] + mutant["replacement"] + text[last:]


def tokens(text):
    """Start, end and text of every token, and by the number of a bracket the number of its partner."""
    found = [(t.start(), t.end(), t.group()) for t in TOKEN.finditer(text) if t.group("blank") is None]
    partners, stack = {}, []
    for k, (_, _, word) in enumerate(found):
        if word in OPEN:
            stack.append(k)
        elif word in CLOSE:
            partners[k] = stack.pop()
            partners[partners[k]] = k
    return found, partners


def around(found, partners, first, last):
    """The offsets of what an operator can rebind."""
    begin = next(k for k, token in enumerate(found) if token[0] == first)
    operator = found[begin][2]
    bounds = set(BOUNDS)
    if operator not in ASSIGNMENTS:
        bounds |= ASSIGNMENTS
    if operator not in ("&&", "||"):
        bounds.add("&&")
    low = high = begin
    while low > 0 and found[low - 1][2] not in bounds | {"(", "[", "}"}:
        low = partners.get(low - 1, low - 1)
    while high + 1 < len(found) and found[high + 1][2] not in bounds | set(CLOSE):
        high = partners.get(high + 1, high + 1)
    return found[low][0], found[high][1]


def flat(text):
    """The text on one line, without comments."""
    return TOKEN.sub(lambda token: " " if token.group("blank") is not None else token.group(), text)


def switched(text, mutants):
    """The file with a switch for each of its mutants by number, and by number the lines of those that are held."""
    found, partners = tokens(text)
    heads, edits, lines = {}, {}, {}
    for number, mutant in mutants.items():
        first, last = ends(text, mutant)
        on = f"crate::switch::on({number})"
        if mutant["genre"] == "FnValue":
            heads.setdefault(first, []).append(f"if {on} {{ return {mutant['replacement']}; }} ")
            region = (first, last)
        elif mutant["genre"] in ("BinaryOperator", "UnaryOperator", "MatchArmGuard"):
            guard = mutant["genre"] == "MatchArmGuard"
            region = (first, last) if guard else around(found, partners, first, last)
            if any(low < region[0] < high < region[1] or region[0] < low < region[1] < high for low, high in edits):
                continue
            changed = text[region[0] : first] + mutant["replacement"] + text[last : region[1]]
            edits.setdefault(region, []).append(f"if {on} {{ {flat(changed)} }} else ")
        else:
            continue
        lines[number] = tuple(text.count("\n", 0, offset) + 1 for offset in region)

    def rendered(low, high, inside):
        parts = []
        while low < high:
            parts += heads.get(low, []) if not inside or low != inside[0] else []
            regions = [region for region in edits if region[0] == low and region[1] <= high and region != inside]
            if regions:
                region = max(regions)
                parts += ["(", *edits[region], "{ ", rendered(*region, region), " })"]
                low = region[1]
            else:
                parts.append(text[low])
                low += 1
        return "".join(parts)

    return rendered(0, len(text), None), lines


def module(count):
    """The module `switch` of a crate with so many mutants in all."""
    return MODULE.replace("COUNT", str(count))
