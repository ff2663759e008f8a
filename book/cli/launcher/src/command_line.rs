//! A command line that is read by its own help: what the text explains is what is understood.
//!
//! Both programs share it, so the launcher refuses a word that nobody understands before anything
//! is built. The idea is docopt's.

use std::error::Error;
use std::ffi::{OsStr, OsString};
use std::path::PathBuf;

use course::chapter::Chapter;
use course::names::{companion_command, escaped_name};
use lexopt::Arg;

use crate::misuse::misuse;

/// The request of a command line.
pub enum Request {
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
    /// The spelling of each option in the help, and its value.
    options: Vec<(&'static str, OsString)>,
}

impl Request {
    /// Reads the words of a command line, without the name of the program.
    ///
    /// # Errors
    /// If there is no such command, or a word that it does not understand; the message names what
    /// is most alike.
    pub fn read(words: impl IntoIterator<Item = OsString>) -> Result<Self, Box<dyn Error>> {
        let mut words = words.into_iter();
        let Some(first) = words.next() else {
            return Ok(Self::Nothing);
        };
        match (first.to_str(), words.next()) {
            (Some("-h" | "--help"), _) | (Some("help"), None) => Ok(Self::Help(overview())),
            (Some("help"), Some(name)) => Ok(Self::Help(Command::find(&name)?.help())),
            (_, second) => Command::find(&first)?.read(second.into_iter().chain(words)),
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

    /// Returns the help of the command.
    pub fn help(self) -> String {
        let names: Vec<&str> = self.chapters().iter().map(|it| it.name()).collect();
        let help = self.help.replace("CHAPTERS", &names.join(", "));
        help.replace("RTRACE", companion_command())
    }

    /// Returns the chapters that its `CHAPTER` may be.
    pub fn chapters(self) -> &'static [Chapter] {
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

    fn read(self, words: impl Iterator<Item = OsString>) -> Result<Request, Box<dyn Error>> {
        let odd = |problem: lexopt::Error| self.misuse(&problem.to_string());
        let (values, program, options) = Default::default();
        let mut read = Words {
            command: self,
            values,
            program,
            options,
        };
        let mut words = lexopt::Parser::from_args(words);
        while !read.takes_the_rest(&mut words) {
            let typed = match words.next().map_err(odd)? {
                None => break,
                Some(Arg::Short('h') | Arg::Long("help")) => {
                    return Ok(Request::Help(self.help()));
                }
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
            let option = self.option(&typed)?;
            if read.find(option).is_some() {
                return Err(self.misuse(&format!("{} is there twice", name(option))));
            }
            let has_value = option.contains('<');
            let value = has_value.then(|| words.value().map_err(odd)).transpose()?;
            read.options.push((option, value.unwrap_or_default()));
        }
        Ok(Request::Run(read))
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

    /// Lists the options as the help spells them, such as `-o, --output <FILE>`.
    fn options(self) -> impl Iterator<Item = &'static str> + Clone {
        let lines = self.help.lines().map(str::trim_start);
        let lines = lines.filter(|line| line.starts_with('-'));
        lines.map(|line| line.split("  ").next().unwrap_or(line))
    }

    fn option(self, typed: &str) -> Result<&'static str, Box<dyn Error>> {
        let is_it = |option: &&str| option.split([',', ' ']).any(|word| word == typed);
        self.options().find(is_it).ok_or_else(|| {
            let suggested = suggestion(typed, self.options().map(name));
            self.misuse(&format!("there is no option {typed:?}{suggested}"))
        })
    }
}

impl Words {
    /// Takes all words that are left if they are a program after `--`, or a text of any words.
    /// Returns true if it has taken them.
    fn takes_the_rest(&mut self, words: &mut lexopt::Parser) -> bool {
        let usage = self.command.usage();
        let Some(rest) = words.try_raw_args() else {
            return false;
        };
        let Some(next) = rest.peek().map(OsStr::to_string_lossy) else {
            return false;
        };
        let option = next.split('=').next().unwrap_or_default();
        if next == "--" && usage.contains("PROGRAM") {
            self.program.extend(rest.skip(1));
        } else if usage.contains("TEXT") && self.command.option(option).is_err() {
            self.values.extend(rest);
        } else {
            return false;
        }
        true
    }

    /// Returns true if the option is there, which is spelled as in the help.
    pub fn has(&self, option: &str) -> bool {
        self.find(option).is_some()
    }

    /// Returns the value of an option, which is spelled as in the help, as a path.
    pub fn path(&self, option: &str) -> Option<PathBuf> {
        self.find(option).map(PathBuf::from)
    }

    /// Parses the value of an option, which is spelled as in the help, if it is there.
    ///
    /// # Errors
    /// If `parse` refuses the value; the message has its reason.
    pub fn option<T>(
        &self,
        option: &str,
        parse: impl Fn(&str) -> Result<T, String>,
    ) -> Result<Option<T>, Box<dyn Error>> {
        let value = self.find(option).map(OsStr::to_string_lossy);
        let parsed = value.map(|it| parse(&it).map_err(|why| self.refused(option, &it, &why)));
        parsed.transpose()
    }

    /// Parses the value of an option that must be there, as all must that the usage names.
    ///
    /// # Errors
    /// If it is not, or if `parse` refuses the value.
    pub fn required<T>(
        &self,
        option: &str,
        parse: impl Fn(&str) -> Result<T, String>,
    ) -> Result<T, Box<dyn Error>> {
        self.option(option, parse)?.ok_or_else(|| {
            let is_named = |it: &&str| self.command.usage().contains(*it);
            let named = self.command.options().filter(is_named);
            let missing: Vec<&str> = named.filter(|it| !self.has(it)).collect();
            self.command
                .misuse(&format!("missing: {}", missing.join(", ")))
        })
    }

    /// Makes the error for a value that was given for an option or an argument, and is refused.
    pub fn refused(&self, head: &str, value: &str, why: &str) -> Box<dyn Error> {
        self.command
            .misuse(&format!("{} {value:?}: {why}", name(head)))
    }

    fn find(&self, option: &str) -> Option<&OsStr> {
        debug_assert!(self.command.options().any(|it| it == option), "{option}");
        let mut options = self.options.iter();
        options.find_map(|(own, value)| (*own == option).then_some(value.as_os_str()))
    }
}

/// Lays out the help of the program.
fn overview() -> String {
    let about = |it: Command| it.help.lines().next().unwrap_or_default();
    let line = |it: Command| format!("  {:<6}  {}\n", it.name(), about(it));
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

/// Returns the long name of an option, such as `--output`.
fn name(option: &str) -> &str {
    let mut words = option.split(' ');
    words.find(|word| word.starts_with("--")).unwrap_or(option)
}

/// Asks whether the most similar of `names` is meant; empty if none is similar.
pub(crate) fn suggestion<'a>(typed: &str, names: impl Iterator<Item = &'a str>) -> String {
    // As in clap: the similarity of Jaro (1989), from 0 to 1.
    const ALIKE: f64 = 0.7;
    let similar = names.map(|name| (strsim::jaro(typed, name), name));
    let most = similar.max_by(|one, other| one.0.total_cmp(&other.0));
    match most {
        Some((likeness, name)) if likeness > ALIKE => format!("; do you mean {name}?"),
        _ => String::new(),
    }
}
