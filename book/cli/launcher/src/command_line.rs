//! A command line that is read by the table which its help is printed from.
//!
//! Both programs share it: the launcher refuses a word that nobody understands before anything is
//! built.

use std::error::Error;
use std::ffi::{OsStr, OsString};
use std::path::PathBuf;

use course::names::{companion_command, escaped_name};
use lexopt::Arg;

use crate::commands::{COMMANDS, Command};
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

/// The words of a command line after the command's name. Each option is known, and has a value if
/// it needs one; what the values mean is not yet asked.
pub struct Words {
    /// The command that the words are for.
    pub command: &'static Command,
    values: Vec<OsString>,
    options: Vec<(&'static str, OsString)>,
    /// The words after `--`: a reader's program and its arguments. Empty if there are none.
    pub program: Vec<OsString>,
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
            (_, second) => Words::read(Command::find(&first)?, second.into_iter().chain(words)),
        }
    }
}

impl Words {
    fn read(
        command: &'static Command,
        words: impl Iterator<Item = OsString>,
    ) -> Result<Request, Box<dyn Error>> {
        let (values, options, program) = Default::default();
        let mut read = Self {
            command,
            values,
            options,
            program,
        };
        let odd = |problem: lexopt::Error| command.misuse(&problem.to_string());
        let mut words = lexopt::Parser::from_args(words);
        while !read.takes_the_rest(&mut words) {
            let Some(word) = words.next().map_err(odd)? else {
                break;
            };
            let typed = match word {
                Arg::Short('h') | Arg::Long("help") => return Ok(Request::Help(command.help())),
                Arg::Value(value) if read.values.len() < command.arguments.len() => {
                    read.values.push(value);
                    continue;
                }
                Arg::Value(value) => {
                    let said = format!("{:?} is one word too many", escaped_name(value));
                    return Err(command.misuse(&said));
                }
                Arg::Short(letter) => format!("-{letter}"),
                Arg::Long(name) => format!("--{name}"),
            };
            let head = command.option(&typed)?;
            if read.find(head).is_some() {
                return Err(command.misuse(&format!("{} is there twice", name(head))));
            }
            let value = match head.contains('<') {
                true => words.value().map_err(odd)?,
                false => OsString::new(),
            };
            read.options.push((head, value));
        }
        Ok(Request::Run(read))
    }

    /// Takes all words that are left if they are a program after `--`, or a text of any words.
    /// Returns true if it has taken them.
    fn takes_the_rest(&mut self, words: &mut lexopt::Parser) -> bool {
        let Some(rest) = words.try_raw_args() else {
            return false;
        };
        let Some(next) = rest.peek() else {
            return false;
        };
        if next == "--" && self.command.usage.contains("PROGRAM") {
            self.program.extend(rest.skip(1));
        } else if self.command.usage.contains("TEXT") && !self.command.has_option(next) {
            self.values.extend(rest);
        } else {
            return false;
        }
        true
    }

    /// Returns the words that are no options, in their order.
    pub fn values(&self) -> &[OsString] {
        &self.values
    }

    /// Returns true if the option is there; `head` is its spelling in the command's table.
    pub fn has(&self, head: &str) -> bool {
        self.find(head).is_some()
    }

    /// Returns the value of an option as a path; `head` is its spelling in the command's table.
    pub fn path(&self, head: &str) -> Option<PathBuf> {
        self.find(head).map(PathBuf::from)
    }

    /// Parses the value of an option, if it is there; `head` is its spelling in the command's
    /// table.
    ///
    /// # Errors
    /// If `parse` refuses the value; the message has its reason.
    pub fn option<T>(
        &self,
        head: &str,
        parse: impl Fn(&str) -> Result<T, String>,
    ) -> Result<Option<T>, Box<dyn Error>> {
        let value = self.find(head).map(OsStr::to_string_lossy);
        let parsed =
            value.map(|value| parse(&value).map_err(|why| self.refused(head, &value, &why)));
        parsed.transpose()
    }

    /// Parses the value of an option that must be there, as all of the command must that its usage
    /// does not put in brackets.
    ///
    /// # Errors
    /// If it is not, or if `parse` refuses the value.
    pub fn required<T>(
        &self,
        head: &str,
        parse: impl Fn(&str) -> Result<T, String>,
    ) -> Result<T, Box<dyn Error>> {
        let value = self.option(head, parse)?;
        value.ok_or_else(|| {
            let is_optional = |head: &str| self.command.usage.contains(&format!("[{head}]"));
            let heads = self.command.options.iter().map(|option| option.0);
            let missing = heads.filter(|head| !self.has(head) && !is_optional(head));
            let missing: Vec<&str> = missing.collect();
            self.command
                .misuse(&format!("missing: {}", missing.join(", ")))
        })
    }

    /// Makes the error for a value that is refused; `head` is the option or the argument that it
    /// was given for, and `why` the reason.
    pub fn refused(&self, head: &str, value: &str, why: &str) -> Box<dyn Error> {
        self.command
            .misuse(&format!("{} {value:?}: {why}", name(head)))
    }

    fn find(&self, head: &str) -> Option<&OsStr> {
        debug_assert!(self.command.options.iter().any(|it| it.0 == head), "{head}");
        let mut options = self.options.iter();
        options.find_map(|(own, value)| (*own == head).then_some(value.as_os_str()))
    }
}

impl Command {
    fn find(typed: &OsStr) -> Result<&'static Self, Box<dyn Error>> {
        let found = COMMANDS.iter().find(|command| typed == command.name);
        found.ok_or_else(|| {
            let names = COMMANDS.iter().map(|command| command.name);
            let rtrace = companion_command();
            misuse(&format!(
                "there is no command {:?}{}\n`{rtrace} help` lists the commands.",
                escaped_name(typed),
                suggestion(&typed.to_string_lossy(), names)
            ))
        })
    }

    /// Finds the spelling of an option in the table, such as `-o, --output <FILE>` for `-o`.
    fn option(&self, typed: &str) -> Result<&'static str, Box<dyn Error>> {
        let mut heads = self.options.iter().map(|option| option.0);
        heads
            .find(|head| head.split([',', ' ']).any(|word| word == typed))
            .ok_or_else(|| {
                let names = self.options.iter().map(|option| name(option.0));
                let suggested = suggestion(typed, names);
                self.misuse(&format!("there is no option {typed:?}{suggested}"))
            })
    }

    fn has_option(&self, word: &OsStr) -> bool {
        let word = word.to_string_lossy();
        let typed = word.split('=').next().unwrap_or_default();
        ["-h", "--help"].contains(&typed) || self.option(typed).is_ok()
    }

    /// Makes the error for a wrong command line, which leads to the command's help.
    pub fn misuse(&self, what: &str) -> Box<dyn Error> {
        let (rtrace, name) = (companion_command(), self.name);
        misuse(&format!(
            "{what}\n`{rtrace} {name} --help` explains each word."
        ))
    }

    /// Lays out the help of the command.
    pub fn help(&self) -> String {
        let mut help = format!(
            "{}\n\nUsage: {} {} {}\n",
            self.about,
            companion_command(),
            self.name,
            self.usage
        );
        if !self.arguments.is_empty() {
            help += &format!("\nArguments:\n{}", table(self.arguments.iter().copied()));
        }
        let last = ("-h, --help", "Print this help");
        let options = self.options.iter().copied().chain([last]);
        help += &format!("\nOptions:\n{}", table(options));
        if !self.notes.is_empty() {
            help += &format!("\n{}\n", self.notes);
        }
        let names: Vec<&str> = self.chapters.iter().map(|it| it.name()).collect();
        help.replace("{chapters}", &names.join(", "))
    }
}

/// Lays out the help of the program.
fn overview() -> String {
    let commands = COMMANDS.iter().map(|command| (command.name, command.about));
    format!(
        "The pictures of Ray Tracing in One Weekend, chapter by chapter.\n\n\
         Without a command: draws all of them into target/pictures, as PNG and as PPM files,\n\
         and weaves the book into target/book.\n\n\
         Usage: {rtrace} [COMMAND]\n\nCommands:\n{}\n\
         `{rtrace} help COMMAND` explains a command.\n",
        table(commands),
        rtrace = companion_command()
    )
}

/// Lays out lines of two columns; an explanation may have several lines.
fn table(rows: impl Iterator<Item = (&'static str, &'static str)> + Clone) -> String {
    // Options without a short name stand below the long names of the others.
    let indented = |head: &str| if head.starts_with("--") { 4 } else { 0 };
    let width = |head: &str| indented(head) + head.len();
    let widest = rows.clone().map(|(head, _)| width(head)).max().unwrap_or(0);
    let row = |(head, said): (&str, &str)| {
        let begin = " ".repeat(2 + indented(head));
        let gap = " ".repeat(widest - width(head) + 2);
        let below = format!("\n{}", " ".repeat(widest + 4));
        format!("{begin}{head}{gap}{}\n", said.replace('\n', &below))
    };
    rows.map(row).collect()
}

/// Returns the long name of an option, such as `--output`.
fn name(head: &str) -> &str {
    let mut words = head.split(' ');
    words.find(|word| word.starts_with("--")).unwrap_or(head)
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
