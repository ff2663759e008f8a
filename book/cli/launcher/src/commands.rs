//! The commands: what each takes, and its help.

use course::chapter::Chapter;

/// A command of `cargo rtrace`.
pub struct Command {
    /// The word that it is called by.
    pub name: &'static str,
    /// A sentence without a full stop, in the list of all commands and above its help.
    pub about: &'static str,
    /// The words that follow the name, as the help shows them: optional ones in brackets.
    pub usage: &'static str,
    /// The chapters that its `CHAPTER` may be, in `{chapters}` of an explanation.
    pub chapters: &'static [Chapter],
    /// The words without a dash, in their order, each with an explanation.
    pub arguments: &'static [(&'static str, &'static str)],
    /// The options, each as the help spells it, with an explanation: in angle brackets is a value.
    pub options: &'static [(&'static str, &'static str)],
    /// The text below the help; may be empty.
    pub notes: &'static str,
}

/// All commands, in the order of the help.
pub const COMMANDS: [Command; 10] = [
    BOOK, SHOW, CHECK, START, WATCH, LAWS, DONE, HIT, NEEDS, PROBES,
];

const BOOK: Command = Command {
    name: "book",
    about: "Weave the book: the notes with the code, the pictures and the figures",
    usage: "[OPTIONS]",
    chapters: &[],
    arguments: &[],
    options: &[
        ("--open", "Open the book in the browser"),
        (
            "-o, --output <DIR>",
            "A folder for the book: new, empty, or an older book's\n[default: target/book]",
        ),
    ],
    notes: "",
};

const SHOW: Command = Command {
    name: "show",
    about: "Draw one picture: in the terminal, into a file, or into a viewer",
    usage: "[OPTIONS] <CHAPTER>",
    chapters: &Chapter::ALL,
    arguments: &[(
        "<CHAPTER>",
        "The chapter whose picture to draw:\n{chapters}",
    )],
    options: &[
        ("--width <N>", "Width in pixels [default: as in the book]"),
        (
            "-o, --output <FILE>",
            "A .png or .ppm file, or - to print the numbers (P3);\n\
             without it the terminal shows the picture",
        ),
        ("--open", "Open the picture in the system's viewer"),
    ],
    notes: "",
};

const CHECK: Command = Command {
    name: "check",
    about: "Check your own picture, and learn which mistake draws it",
    usage: "[OPTIONS] [CHAPTER] [PICTURE] [-- <PROGRAM>...]",
    chapters: &Chapter::OF_THE_BOOK,
    arguments: &[
        (
            "[CHAPTER]",
            "The chapter whose picture it should be; without one, the chapter that comes\n\
             nearest: {chapters}",
        ),
        (
            "[PICTURE]",
            "Your picture: a .ppm (P3 or P6) or .png file, or - for standard input",
        ),
    ],
    options: &[
        (
            "--probe <NAME>",
            "The picture shows the scene of this probe: `probes` lists them",
        ),
        (
            "--edition <VERSION>",
            "The picture follows this version of the book: 4, 3, 3.0 or 1; without this option,\n\
             any version will do",
        ),
        (
            "--tolerance <N>",
            "Accept components that are up to N levels off [default: 0]",
        ),
        (
            "--timeout <SECONDS>",
            "How long your program may take [default: 60]",
        ),
    ],
    notes: "PROGRAM is your own program, which prints the picture to standard output.",
};

const START: Command = Command {
    name: "start",
    about: "Make a crate of your own for a chapter, ready to be typed into",
    usage: "[OPTIONS] <CHAPTER>",
    chapters: &Chapter::TYPED,
    arguments: &[(
        "<CHAPTER>",
        "The chapter that you are about to type:\n{chapters}",
    )],
    options: &[
        (
            "--into <FOLDER>",
            "Where your crates are to be [default: mine]",
        ),
        (
            "--own-prelude",
            "Type the prelude as well: vectors, rays, camera and the text of a picture",
        ),
    ],
    notes: "",
};

const WATCH: Command = Command {
    name: "watch",
    about: "Judge your crate or program whenever you save it",
    usage: "[OPTIONS] <CHAPTER> [-- <PROGRAM>...]",
    chapters: &Chapter::OF_THE_BOOK,
    arguments: &[(
        "<CHAPTER>",
        "The chapter whose picture your crate or program should draw:\n{chapters}",
    )],
    options: &[
        ("--in <FOLDER>", "Where your crates are, if not in mine"),
        (
            "--probe <NAME>",
            "Your program draws the scene of this probe: `probes` lists them",
        ),
        (
            "--timeout <SECONDS>",
            "How long your program may take [default: 10]",
        ),
        (
            "--once",
            "Judge once, and end with 0 if the picture is right",
        ),
    ],
    notes: "\
PROGRAM is your own program, which prints the picture; the current folder is watched. Without it,
the crate that `start` made is watched.",
};

const LAWS: Command = Command {
    name: "laws",
    about: "Put a function of any program, in any language, under the laws",
    usage: "[OPTIONS] <CHAPTER> -- <PROGRAM>...",
    chapters: &Chapter::WITH_SPHERES,
    arguments: &[(
        "<CHAPTER>",
        "The chapter whose intersection of a ray and a sphere you wrote:\n{chapters}",
    )],
    options: &[(
        "--timeout <SECONDS>",
        "How long your program may take for an answer; for all of them, twenty\n\
         times as long [default: 5]",
    )],
    notes: "\
PROGRAM is your own program: it reads a line of numbers, center, radius, origin, direction (in
chapter 5 also t_min and t_max), and prints t or miss (in chapter 2: hit or miss; in chapter 5 the
normal, and front or back, may follow t), line by line.",
};

const DONE: Command = Command {
    name: "done",
    about: "Show the list of what you have done, or add a line to it",
    usage: "[OPTIONS] [TEXT]...",
    chapters: &[],
    arguments: &[(
        "[TEXT]...",
        "A thing that you have done or understood, in a few words",
    )],
    options: &[(
        "--in <FOLDER>",
        "The folder of the list\n\
         [default: mine in this workspace or where it is, or else this one]",
    )],
    notes: "",
};

const HIT: Command = Command {
    name: "hit",
    about: "Look at one ray and one sphere through every method of chapter 6",
    usage: "--origin <X,Y,Z> --direction <X,Y,Z> --center <X,Y,Z> --radius <R> [--t-min <T>]",
    chapters: &[],
    arguments: &[],
    options: &[
        ("--origin <X,Y,Z>", "Where the ray starts"),
        (
            "--direction <X,Y,Z>",
            "Where the ray points; t counts lengths of it",
        ),
        ("--center <X,Y,Z>", "The center of the sphere"),
        ("--radius <R>", "The radius of the sphere"),
        (
            "--t-min <T>",
            "A hit must have a greater t than this [default: 0]",
        ),
    ],
    notes: "",
};

const NEEDS: Command = Command {
    name: "needs",
    about: "Find the cheapest method of chapter 6 that draws a scene of your own right",
    usage: "[OPTIONS] <SCENE>",
    chapters: &[],
    arguments: &[(
        "<SCENE>",
        "The scene: a TOML file, such as those in chapters/6_speed_vs_accuracy/scenes",
    )],
    options: &[(
        "--width <N>",
        "Width in pixels [default: as the scene says, or 400]",
    )],
    notes: "\
A scene, of which only the spheres are needed:
  width = 400             # pixels; the picture is 16:9
  sun = [1, 0.25, 0.5]    # towards the sun, of any length; without a sun no shadows
  t_min = 0.001           # no hit counts before; if left out: 0, and 0.001 for shadows

  [camera]
  origin = [0, 0, 0]
  direction = [0, 0, -1]  # of any length
  zoom = 1                # or [across, up]

  [[sphere]]              # as often as there are spheres
  center = [0, 0, -1]
  radius = 0.5

The columns of the table:
  wrong pixels         more than one of 255 levels off, in a component, from the picture
                       that exact arithmetic draws of the scene as it is written, in f64
  worst, levels        how far a component is off in the worst pixel
  worst, radii         how far a hit point is at most from where it should be
  worst, t             how large a part of t is wrong at most, where the right sphere is hit
  ns                   what one ray and one sphere of this scene take, here and now: the
                       quickest of the rounds in which every method has a turn
  ÷ half_b             how many times as long as half_b in the same round: the median
Columns and rows count from 0, spheres from 1.",
};

const PROBES: Command = Command {
    name: "probes",
    about: "List the small scenes that show what the book's picture can't",
    usage: "[CHAPTER]",
    chapters: &Chapter::OF_THE_BOOK,
    arguments: &[(
        "[CHAPTER]",
        "The chapter that you are at [default: hittable_list]:\n{chapters}",
    )],
    options: &[],
    notes: "",
};
