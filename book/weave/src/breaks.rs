//! Where a formula on a line of its own, or in a table, may go on in the next line.
//!
//! No browser breaks MathML everywhere where a person would, and some break it
//! where nobody would. So a formula becomes several that stand in one line. Where it
//! is too short, the statements of a list part first, then the sides of a relation
//! (= ≤ <), and the terms of a sum only if a side alone is still too wide.

/// The MathML of a formula, cut into such parts. They stand in a line, so what is
/// drawn as large as on a line of its own says so.
pub(crate) fn with_breaks(mathml: &str) -> String {
    let (start, content) = mathml
        .strip_suffix("</math>")
        .and_then(|rest| rest.split_once('>'))
        .expect("a formula is one element");
    let start = start.replace(" display=\"block\"", " displaystyle=\"true\"");
    let breaks: [Break; 3] = [between_statements, between_sides, between_terms];
    parts(&start, &children(content), &breaks)
}

/// Says whether a line may break between two neighboring elements.
type Break = fn(&str, &str) -> bool;

/// The parts between the first of `breaks`, each parted by the others in turn.
fn parts(start: &str, elements: &[&str], breaks: &[Break]) -> String {
    let Some((first, finer)) = breaks.split_first() else {
        return formula(start, elements);
    };
    let parts: Vec<String> = cut(elements, *first)
        .map(|part| parts(start, part, finer))
        .collect();
    match &parts[..] {
        [whole] => whole.clone(),
        parts => parts
            .iter()
            .map(|part| format!("<span class=\"part\">{part}</span>"))
            .collect::<Vec<_>>()
            .join("<wbr>"),
    }
}

/// The stretches between breaks. What stands between brackets stays together.
fn cut<'a>(elements: &'a [&'a str], is_break: Break) -> impl Iterator<Item = &'a [&'a str]> {
    let mut open = 0;
    elements.chunk_by(move |before, next| {
        match sign(before) {
            Some("(" | "[") => open += 1,
            Some(")" | "]") => open -= 1,
            _ => {}
        }
        open > 0 || !is_break(before, next)
    })
}

/// Elements as a formula. A sign at the beginning is between two parts all the same,
/// not the sign of a number.
fn formula(start: &str, elements: &[&str]) -> String {
    let mathml = elements.concat();
    let mathml = match is_relation(elements[0]) || is_sum(elements[0]) {
        true => mathml.replacen("<mo", "<mo form=\"infix\"", 1),
        false => mathml,
    };
    format!("{start}>{mathml}</math>")
}

/// After a `\quad`, or a wider one.
fn between_statements(before: &str, _: &str) -> bool {
    [r#"<mspace width="1em""#, r#"<mspace width="2em""#]
        .iter()
        .any(|gap| before.starts_with(gap))
}

fn between_sides(_: &str, next: &str) -> bool {
    is_relation(next)
}

/// Before a plus or a minus that is no sign of a number.
fn between_terms(before: &str, next: &str) -> bool {
    let ends_term = sign(before).is_none_or(|sign| [")", "]", "|"].contains(&sign));
    is_sum(next) && ends_term
}

/// The elements of MathML on its outermost level.
fn children(content: &str) -> Vec<&str> {
    let mut children = Vec::new();
    let (mut depth, mut start) = (0, 0);
    for (at, _) in content.match_indices('<') {
        let end = at + content[at..].find('>').map_or(0, |length| length + 1);
        let tag = &content[at..end];
        if tag.starts_with("</") {
            depth -= 1;
        } else if !tag.ends_with("/>") {
            depth += 1;
        }
        if depth == 0 {
            children.push(content[start..end].trim());
            start = end;
        }
    }
    children
}

fn is_relation(element: &str) -> bool {
    let relations = ["=", "≤", "≥", "&lt;", "&gt;", "≈", "≠"];
    sign(element).is_some_and(|sign| relations.contains(&sign))
}

fn is_sum(element: &str) -> bool {
    matches!(sign(element), Some("+" | "−" | "±"))
}

/// What an operator shows.
fn sign(element: &str) -> Option<&str> {
    let (_, shown) = element.strip_prefix("<mo")?.split_once('>')?;
    shown.strip_suffix("</mo>")
}
