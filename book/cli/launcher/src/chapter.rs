//! Names on a command line. That of a chapter may be its number, or its folder as a shell
//! completes it.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Arg, Command, Error};
use course::chapter::Chapter;

/// A parser of a command-line argument that names one of the listed chapters: by its name, its
/// number from 0, or a path whose last part is its name or its folder, such as `normals`, `3` or
/// `chapters/3_normals/`.
#[derive(Clone)]
pub struct ChapterParser(pub &'static [Chapter]);

impl TypedValueParser for ChapterParser {
    type Value = Chapter;

    fn parse_ref(&self, cmd: &Command, arg: Option<&Arg>, typed: &OsStr) -> Result<Chapter, Error> {
        if let Some(&chapter) = self.0.iter().find(|&&chapter| is_meant(typed, chapter)) {
            return Ok(chapter);
        }
        // It refuses in clap's words, with the name that is most alike.
        let name = PossibleValuesParser::new(self.names()).parse_ref(cmd, arg, typed)?;
        Ok(Chapter::find(&name).expect("only names of chapters are accepted"))
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(self.names().map(PossibleValue::new)))
    }
}

/// The first argument of `cargo rtrace check`: a chapter, or a picture whose chapter is to be
/// guessed.
#[derive(Clone)]
pub enum ChapterOrPicture {
    /// A chapter whose picture is in *Ray Tracing in One Weekend*.
    Chapter(Chapter),
    /// The path of a picture file, which may be missing, or `-` for standard input.
    Picture(PathBuf),
}

/// A parser of an argument that names one of [`Chapter::OF_THE_BOOK`] as [`ChapterParser`] does, or
/// else a picture: an existing file, a name with an extension, or `-`. Any other word is an error
/// that lists the chapters.
#[derive(Clone)]
pub struct ChapterOrPictureParser;

impl TypedValueParser for ChapterOrPictureParser {
    type Value = ChapterOrPicture;

    fn parse_ref(
        &self,
        cmd: &Command,
        arg: Option<&Arg>,
        typed: &OsStr,
    ) -> Result<ChapterOrPicture, Error> {
        let path = Path::new(typed);
        match ChapterParser(&Chapter::OF_THE_BOOK).parse_ref(cmd, arg, typed) {
            Ok(chapter) => Ok(ChapterOrPicture::Chapter(chapter)),
            Err(_) if typed == "-" || path.extension().is_some() || path.is_file() => {
                Ok(ChapterOrPicture::Picture(path.to_owned()))
            }
            Err(error) => Err(error),
        }
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(
            ChapterParser(&Chapter::OF_THE_BOOK)
                .names()
                .map(PossibleValue::new),
        ))
    }
}

impl ChapterParser {
    fn names(&self) -> impl Iterator<Item = &'static str> + use<> {
        self.0.iter().map(|chapter| chapter.name())
    }
}

/// Returns true if `typed` means the chapter, as `normals`, `3`, `chapters/3_normals/` and
/// `mine/normals` mean [`Chapter::Normals`].
fn is_meant(typed: &OsStr, chapter: Chapter) -> bool {
    let (number, name) = (chapter as usize, chapter.name());
    let last = Path::new(typed).file_name().unwrap_or_default();
    [name, &format!("{number}"), &format!("{number}_{name}")]
        .map(OsStr::new)
        .contains(&last)
}

/// Makes a parser of an argument that turns a name into the thing beside it in `things`; any other
/// word is an error that lists the names. Of neighbors in `things` that share a name, the first
/// counts.
pub fn parser_of_names<T>(
    things: impl IntoIterator<Item = (&'static str, T)>,
) -> impl TypedValueParser<Value = T>
where
    T: Clone + Send + Sync + 'static,
{
    let mut things: Vec<(&str, T)> = things.into_iter().collect();
    things.dedup_by_key(|(name, _)| *name);
    let names: Vec<&str> = things.iter().map(|(name, _)| *name).collect();
    PossibleValuesParser::new(names).try_map(move |typed| {
        let found = things.iter().find(|(name, _)| typed == *name);
        found
            .map(|(_, thing)| thing.clone())
            .ok_or("it is none of these names")
    })
}
