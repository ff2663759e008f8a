//! A command line that is read by its own help: what the text explains is what is understood.
//!
//! Both programs share it, so the launcher refuses a word that nobody understands before anything
//! is built. The idea is docopt's.

use std::error::Error;
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

use course::chapter::Chapter;
use course::names::{companion_command, escaped_name};
use lexopt::{Arg, Parser};

use crate::misuse::misuse;

/// The request of a command line.
pub(crate) enum Request {
    /// There is no word at all.
    Nothing,
    /// Print this text: the help that was asked for.
    Help(String),
    /// Run a command.
    Run(Words),
}

/// A command of `cargo rtrace`: its help, as it stands in `commands.txt`.
#[derive(Clone, Copy)]
pub struct Command {
    help: &'static str,
}

/// The words of a command line after the command's name. Each option is known, and has a value if
/// it needs one; what the values mean is not yet asked.
pub struct Words {
    /// The command that the words are for.
    pub command: Command,
    /// The words that are no options, in their order.
    pub values: Vec<OsString>,
    /// The words after `--`: a reader's program and its arguments. Empty if there are none.
    pub program: Vec<OsString>,
    /// The long name of each option, such as `--output`, and its value.
    options: Vec<(&'static str, OsString)>,
}

impl Request {
    /// Reads the words of a command line, without the name of the program.
    pub(crate) fn read(words: impl Iterator<Item = OsString>) -> Result<Self, Box<dyn Error>> {
        let words: Vec<OsString> = words.collect();
        let Some((first, rest)) = words.split_first() else {
            return Ok(Self::Nothing);
        };
        match (first.to_str(), rest.first()) {
            (Some("-h" | "--help"), _) | (Some("help"), None) => Ok(Self::Help(overview())),
            (Some("help"), Some(name)) => Ok(Self::Help(Command::find(name)?.help())),
            _ => Command::find(first)?.read(rest.to_vec()),
        }
    }
}

impl Command {
    /// Lists all commands, in the order of the help.
    fn all() -> impl Iterator<Item = Self> {
        let helps = include_str!("commands.txt").split("====\n");
        helps.map(|help| Self { help })
    }

    fn find(typed: &OsStr) -> Result<Self, Box<dyn Error>> {
        let found = Self::all().find(|command| typed == command.name());
        found.ok_or_else(|| {
            let suggested = suggestion(&typed.to_string_lossy(), Self::all().map(Self::name));
            let (typed, rtrace) = (escaped_name(typed), companion_command());
            misuse(&format!(
                "there is no command {typed:?}{suggested}\n`{rtrace} help` lists the commands."
            ))
        })
    }

    /// Returns the word that the command is called by.
    pub fn name(self) -> &'static str {
        self.usage().split(' ').next().unwrap_or_default()
    }

    fn help(self) -> String {
        let names = self.chapters().iter().map(|chapter| chapter.name());
        let names = names.collect::<Vec<_>>().join(", ");
        let help = self.help.replace("CHAPTERS", &names);
        help.replace("RTRACE", companion_command())
    }

    /// Returns the chapters that its `CHAPTER` may be.
    fn chapters(self) -> &'static [Chapter] {
        match self.name() {
            "show" => &Chapter::ALL,
            "start" => &Chapter::TYPED,
            "laws" => &Chapter::WITH_SPHERES,
            _ => &Chapter::OF_THE_BOOK,
        }
    }

    /// Makes the error for a wrong command line, which leads to the command's help.
    pub fn misuse(self, what: &str) -> Box<dyn Error> {
        let (rtrace, name) = (companion_command(), self.name());
        misuse(&format!(
            "{what}\n`{rtrace} {name} --help` explains each word."
        ))
    }

    fn read(self, mut words: Vec<OsString>) -> Result<Request, Box<dyn Error>> {
        let mut read = Words {
            command: self,
            program: self.take_program(&mut words),
            values: Vec::new(),
            options: Vec::new(),
        };
        let odd = |problem: lexopt::Error| self.misuse(&problem.to_string());
        let mut words = Parser::from_args(words);
        loop {
            if self.usage().contains("TEXT") {
                read.values.extend(self.text(&mut words));
            }
            let typed = match words.next().map_err(odd)? {
                None => return Ok(Request::Run(read)),
                Some(Arg::Short('h') | Arg::Long("help")) => return Ok(Request::Help(self.help())),
                Some(Arg::Value(value)) if read.values.len() < self.most_values() => {
                    read.values.push(value);
                    continue;
                }
                Some(Arg::Value(value)) => {
                    let said = format!("{:?} is one word too many", escaped_name(value));
                    return Err(self.misuse(&said));
                }
                Some(Arg::Short(letter)) => format!("-{letter}"),
                Some(Arg::Long(name)) => format!("--{name}"),
            };
            let (name, has_value) = self.option(&typed)?;
            if read.has(name) {
                return Err(self.misuse(&format!("{name} is there twice")));
            }
            let value = has_value.then(|| words.value().map_err(odd)).transpose()?;
            read.options.push((name, value.unwrap_or_default()));
        }
    }

    /// Takes the words from `--` on, if a program may follow it, and returns those after it.
    fn take_program(self, words: &mut Vec<OsString>) -> Vec<OsString> {
        let takes_program = self.usage().contains("PROGRAM");
        let border = words.iter().position(|word| takes_program && word == "--");
        let program = words.drain(border.unwrap_or(words.len())..);
        program.skip(1).collect()
    }

    /// Takes all words that are left if the next one is no option: they are a text of any words.
    fn text(self, words: &mut Parser) -> Vec<OsString> {
        let is_option = |word: &OsStr| {
            let word = word.to_string_lossy();
            self.option(word.split('=').next().unwrap_or_default())
                .is_ok()
        };
        let rest = words.try_raw_args();
        let rest = rest.filter(|rest| !rest.peek().is_some_and(is_option));
        rest.into_iter().flatten().collect()
    }

    /// Returns the line of the help that shows all words in their order, from the name on.
    fn usage(self) -> &'static str {
        let usage = self.help.split("RTRACE ").nth(1).unwrap_or_default();
        usage.lines().next().unwrap_or_default()
    }

    /// Returns how many words may be no options: as many as the help explains, but for a program.
    fn most_values(self) -> usize {
        let is_value = |line: &&str| line.starts_with("  <") || line.starts_with("  [");
        let values = self.help.lines().filter(is_value);
        values.filter(|line| !line.contains("PROGRAM")).count()
    }

    /// Lists the words of each option in the help, such as `-o`, `--output` and `<FILE>`.
    fn options(self) -> impl Iterator<Item = Vec<&'static str>> {
        let lines = self.help.lines().map(str::trim_start);
        let lines = lines.filter(|line| line.starts_with('-'));
        let spelled = lines.map(|line| line.split("  ").next().unwrap_or(line));
        let words = |option: &'static str| option.split(' ').map(|word| word.trim_end_matches(','));
        spelled.map(move |option| words(option).collect())
    }

    /// Returns the long name of the option that was typed, and true if a value follows it.
    fn option(self, typed: &str) -> Result<(&'static str, bool), Box<dyn Error>> {
        let name = |option: &Vec<&'static str>| {
            let mut words = option.iter().copied();
            words
                .find(|word| word.starts_with("--"))
                .unwrap_or_default()
        };
        let found = self.options().find(|option| option.contains(&typed));
        let found = found.map(|option| {
            (
                name(&option),
                option.last().is_some_and(|it| it.starts_with('<')),
            )
        });
        found.ok_or_else(|| {
            let names: Vec<&str> = self.options().map(|option| name(&option)).collect();
            let suggested = suggestion(typed, names.into_iter());
            self.misuse(&format!("there is no option {typed:?}{suggested}"))
        })
    }
}

impl Words {
    /// Returns true if the option is there, which is named as `--output`.
    pub fn has(&self, name: &str) -> bool {
        self.find(name).is_some()
    }

    /// Returns the value of an option as a path.
    pub fn path(&self, name: &str) -> Option<PathBuf> {
        self.find(name).map(PathBuf::from)
    }

    /// Parses the value of an option, if it is there.
    ///
    /// # Errors
    /// If `parse` refuses the value; the message has its reason.
    pub fn option<T>(
        &self,
        name: &str,
        parse: impl Fn(&str) -> Result<T, String>,
    ) -> Result<Option<T>, Box<dyn Error>> {
        let value = self.find(name).map(OsStr::to_string_lossy);
        let parsed = value.map(|it| parse(&it).map_err(|why| self.refused(name, &it, &why)));
        parsed.transpose()
    }

    /// Returns the chapter that the first word names, one of those of the command: by its name, its
    /// number from 0, or a path whose last part is its name or its folder, such as `normals`, `3`
    /// or `chapters/3_normals/`. Returns `None` if there is no word.
    ///
    /// # Errors
    /// If the word means no chapter of the command; the message lists them, and names the one that
    /// is most alike.
    pub fn chapter(&self) -> Result<Option<Chapter>, Box<dyn Error>> {
        let Some(typed) = self.values.first() else {
            return Ok(None);
        };
        let chapters = self.command.chapters().iter();
        let found = chapters.clone().find(|&&chapter| is_meant(typed, chapter));
        found.copied().map(Some).ok_or_else(|| {
            let typed = typed.to_string_lossy();
            let why = choose_one_of(&typed, chapters.map(|chapter| chapter.name()));
            self.refused("CHAPTER", &typed, &why)
        })
    }

    /// Returns the chapter of [`chapter`](Self::chapter), which must be there.
    ///
    /// # Errors
    /// If it is not, or the word means no chapter of the command.
    pub fn required_chapter(&self) -> Result<Chapter, Box<dyn Error>> {
        let missing = || self.command.misuse("CHAPTER is missing");
        self.chapter()?.ok_or_else(missing)
    }

    /// Makes the error for a value that was given for an option or an argument, and is refused.
    pub(crate) fn refused(&self, name: &str, value: &str, why: &str) -> Box<dyn Error> {
        self.command.misuse(&format!("{name} {value:?}: {why}"))
    }

    fn find(&self, name: &str) -> Option<&OsStr> {
        debug_assert!(self.command.option(name).is_ok(), "{name}");
        let mut options = self.options.iter();
        options.find_map(|(own, value)| (*own == name).then_some(value.as_os_str()))
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

/// Lays out the help of the program.
fn overview() -> String {
    let about = |it: Command| it.help.lines().next().unwrap_or_default();
    let line = |it: Command| format!("  {:<5}  {}\n", it.name(), about(it));
    format!(
        "The pictures of Ray Tracing in One Weekend, chapter by chapter.\n\n\
         Without a command: draws all of them into target/pictures, as PNG and as PPM files,\n\
         and weaves the book into target/book.\n\n\
         Usage: {rtrace} [COMMAND]\n\nCommands:\n{}\n\
         `{rtrace} help COMMAND` explains a command.\n",
        Command::all().map(line).collect::<String>(),
        rtrace = companion_command()
    )
}

/// Lists the names that a word should be one of, and asks for the one that is most alike.
pub fn choose_one_of<'a>(typed: &str, names: impl Iterator<Item = &'a str> + Clone) -> String {
    let suggested = suggestion(typed, names.clone());
    let names: Vec<&str> = names.collect();
    format!("choose one of {}{suggested}", names.join(", "))
}

/// Asks whether the most similar of `names` is meant; empty if none is similar.
fn suggestion<'a>(typed: &str, names: impl Iterator<Item = &'a str>) -> String {
    // As in clap: the similarity of Jaro (1989), from 0 to 1.
    const ALIKE: f64 = 0.7;
    let similar = names.map(|name| (strsim::jaro(typed, name), name));
    let most = similar.max_by(|one, other| one.0.total_cmp(&other.0));
    match most {
        Some((likeness, name)) if likeness > ALIKE => format!("; do you mean {name}?"),
        _ => String::new(),
    }
}
