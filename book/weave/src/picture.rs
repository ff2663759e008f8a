//! The picture of a chapter, under a question that is answered by breaking it.

/// The question, and the image in Markdown.
pub(crate) fn picture(text: &str) -> Result<String, String> {
    let at = text.find("![");
    let (question, image) = at
        .map(|at| text.split_at(at))
        .ok_or_else(|| format!("{text} has no image in Markdown"))?;
    Ok(format!(
        "<figure id=\"picture\">\n\n**{}**\n\n{image}\n\n\
         *Break it*, above a listing, makes a mistake in its line, and shows what that draws.\n\n</figure>",
        question.trim()
    ))
}
