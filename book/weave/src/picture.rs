//! The picture of a chapter, under a question about it.

/// The question, and the image in Markdown.
pub(crate) fn picture(text: &str) -> Result<String, String> {
    let at = text.find("![");
    let (question, image) = at
        .map(|at| text.split_at(at))
        .ok_or_else(|| format!("{text} has no image in Markdown"))?;
    Ok(format!(
        "<figure id=\"picture\">\n\n**{}**\n\n{image}\n\n</figure>",
        question.trim()
    ))
}
