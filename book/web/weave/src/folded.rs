//! What a listing keeps folded: cost and errors of a method, which a reader looks up.

/// Takes from a listing what doc comments say of a method's cost and errors, from a line that begins
/// with `Cost:` or `Error:` to the end of the comment. Returns the code without it, and it as
/// Markdown that a reader unfolds; nothing if there is none.
pub(crate) fn folded(code: &str) -> (String, String) {
    let [mut shown, mut hidden] = [const { Vec::<&str>::new() }; 2];
    let mut is_hidden = false;
    for line in code.lines() {
        let comment = line.trim_start().strip_prefix("///");
        let words = comment.unwrap_or_default().trim_start();
        let begins = words.starts_with("Cost: ") || words.starts_with("Error: ");
        is_hidden = comment.is_some() && (is_hidden || begins);
        if begins {
            // The empty line before it.
            shown.pop_if(|last| last.trim() == "///");
        }
        if is_hidden { &mut hidden } else { &mut shown }.push(line);
    }
    if hidden.is_empty() {
        return (code.to_owned(), String::new());
    }
    let hidden = format!(
        "<details class=\"source\"><summary>Cost, errors, and where it fails</summary>\n\n\
         <div class=\"listing\">\n\n````rust\n{}\n````\n\n</div>\n\n</details>\n",
        hidden.join("\n")
    );
    (shown.join("\n"), hidden)
}
