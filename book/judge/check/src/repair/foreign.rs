//! Transplantation: a line of Python or C++, spelled in Rust, in the place of the chapter's that
//! it is most like. It is named if the chapter with it draws the reader's picture.

use slips::Chapter;

use super::edit::{Role, roots};
use super::functions::{Files, Function, functions, with};
use super::goal::{DRAWN, LOOKED, draws, program};
use super::spelling::{in_rust, plain};
use super::tree::{Tree, squeezed};
use crate::reading::Reading;
use crate::scene::Scene;
use crate::sources::{Line, with_brackets};

/// So many lines are tried in one place, if they have this much in common with what is there.
const TRIED: usize = 3;
const ALIKE: f64 = 0.4;

/// A statement of a reader's.
struct Statement {
    line: Line,
    role: Role,
    value: Tree,
}

/// An expression of the chapter's.
struct Place<'a> {
    function: &'a Function,
    role: Role,
    value: &'a Tree,
    plain: Tree,
    /// The names that its function has.
    known: Vec<String>,
}

/// The reader's line with which the chapter draws the reader's picture, in the edition to which
/// the reader keeps, and the chapter's line in its place.
pub(super) fn repair(
    chapter: Chapter,
    theirs: &Files,
    yours: &[(String, String)],
    reading: &Reading,
) -> Option<(Line, String)> {
    let yours = yours.iter().flat_map(|(name, text)| statements(name, text));
    let yours: Vec<Statement> = yours.collect();
    let editions = [false, true].map(|is_older| with_a_camera(chapter, theirs, is_older));
    let functions = editions.each_ref().map(|files| functions(files));
    let places = functions
        .each_ref()
        .map(|it| it.iter().flat_map(places).collect::<Vec<_>>());
    let [newest, older] = places.each_ref().map(|places| compared(places, &yours));
    let is_older = older.0.len() < newest.0.len();
    let (missing, wrong) = if is_older { older } else { newest };
    let files = &editions[usize::from(is_older)];
    // Where no sphere is seen many a line draws the picture: only that of the same role is tried.
    let has_sphere = !is_sky(chapter, reading);
    let mut missing = missing.into_iter();
    missing.find_map(|place| {
        let is_likely = |it: &&Statement| has_sphere || it.role == place.role;
        let wrong: Vec<&Statement> = wrong.iter().copied().filter(is_likely).collect();
        place.repair(&wrong, files, reading)
    })
}

fn is_sky(chapter: Chapter, reading: &Reading) -> bool {
    let sky = Scene::new(chapter, None).map(|it| it.of_sky(reading.width, reading.height));
    sky.is_some_and(|sky| {
        let (pixels, _) = sky.rgb().as_chunks::<3>();
        let mut pairs = pixels.iter().zip(&reading.pixels);
        pairs.all(|(sky, found)| sky.map(i16::from) == *found)
    })
}

/// The chapter's expressions that the reader does not have, and the reader's that the chapter
/// does not have.
fn compared<'a>(
    places: &'a [Place<'a>],
    yours: &'a [Statement],
) -> (Vec<&'a Place<'a>>, Vec<&'a Statement>) {
    let is_right = |it: &&Statement| is_in(places, it);
    let (right, wrong): (Vec<&Statement>, Vec<&Statement>) = yours.iter().partition(is_right);
    let is_missing = |place: &&Place| !right.iter().any(|it| place.has(it));
    (places.iter().filter(is_missing).collect(), wrong)
}

/// Whether the chapter has the statement. A name that the chapter gives too is to have the
/// chapter's value.
fn is_in(places: &[Place], statement: &Statement) -> bool {
    let is_named = |it: &&Place| it.role == statement.role && matches!(it.role, Role::Let(_));
    if places.iter().any(|it| is_named(&it)) {
        let mut named = places.iter().filter(is_named);
        return named.any(|it| it.has(statement));
    }
    places.iter().any(|it| it.has(statement))
}

/// The chapter with the camera and the sky as a part of it, so that their lines have places too;
/// as older editions have it if that is wanted, with the way to the center turned round.
fn with_a_camera(chapter: Chapter, theirs: &Files, is_older: bool) -> Files {
    let text = |name: &str| {
        let mut files = theirs.iter().filter(|(it, _)| it.ends_with(name));
        files.next().map_or("", |(_, text)| text)
    };
    let sky = text("color.rs").find("pub fn sky").unwrap_or_default();
    let sky = text("color.rs")[sky..].split_inclusive("\n}\n").next();
    let sky = sky
        .filter(|_| chapter > Chapter::Gradient)
        .unwrap_or_default();
    let mut files: Files = theirs[..chapter.files().len()].to_vec();
    files[0].1 = files[0]
        .1
        .replace("render(width, ray_color)", &painted("ray_color(&ray)"))
        .replace(
            "render(width, move |ray| ray_color(ray, &world))",
            &painted("ray_color(&ray, &world)"),
        );
    files[0].1 += "mod camera;\n";
    files[0].1 += sky;
    let camera = text("camera.rs").replace("use crate::ray::Ray;", "use common::rtweekend::*;");
    let camera = camera.replace("use crate::vec3::{Point3, Vec3};", "");
    files.push(("src/camera.rs".to_owned(), camera));
    for (_, text) in files.iter_mut().filter(|_| is_older) {
        *text = text
            .replace("self.center - ray.origin", "ray.origin - self.center")
            .replace("center - ray.origin", "ray.origin - center")
            .replace("-2.0 * ray", "2.0 * ray")
            .replace("(h ", "(-h ");
    }
    files
}

/// What paints a picture by the camera of the crate.
fn painted(color: &str) -> String {
    format!(
        "{{
    let camera = camera::Camera::new(width);
    Picture::paint(camera.image_width, camera.image_height, move |i, j| {{
        let ray = camera.ray(i, j);
        {color}
    }})
}}"
    )
}

/// The expressions of a function; of what is put into `Some` only that.
fn places(function: &Function) -> Vec<Place<'_>> {
    let all = roots(&function.body).into_iter();
    let known = [names(&plain(&function.body)), function.parameters.clone()].concat();
    let all = all.map(|(role, value)| {
        let is_some = value.op == "□(□)" && value.parts[0].op == "Some";
        let value = if is_some { &value.parts[1] } else { value };
        Place {
            function,
            role,
            plain: plain(value),
            known: known.clone(),
            value,
        }
    });
    all.filter(|it| !it.value.is_block() && !it.value.parts.is_empty())
        .collect()
}

impl Place<'_> {
    /// Whether the statement says the same.
    fn has(&self, statement: &Statement) -> bool {
        self.spell(&statement.value).is_same(&self.plain)
    }

    /// Whether the statement can stand there: a condition for one, a call for one, and a value
    /// for a value.
    fn takes(&self, statement: &Statement) -> bool {
        let kind = |role: &Role| match role {
            Role::Condition | Role::Part => 0,
            Role::Called => 1,
            Role::Each => 2,
            Role::Let(_) | Role::Set(_) | Role::Result => 3,
        };
        kind(&self.role) == kind(&statement.role)
    }

    /// The reader's expression with the chapter's names for those that its function does not
    /// have, in the order in which they come.
    fn spell(&self, value: &Tree) -> Tree {
        let own = names(value);
        let theirs = names(&self.plain);
        let new = own.iter().filter(|name| !self.known.contains(name));
        let free = theirs.iter().filter(|name| !own.contains(name));
        let renames: Vec<(&String, &String)> = new.zip(free).collect();
        renamed(value, &renames)
    }

    /// Whether something of the statement stands in the place under the same name: else its
    /// names, turned into those of the place, make any sum look like any other.
    fn shares(&self, typed: &Tree, spelled: &Tree) -> bool {
        let leaves = |tree: &Tree| -> Vec<String> {
            let leaves = tree.nodes().into_iter().filter(|it| it.parts.is_empty());
            leaves.map(|it| it.op.clone()).collect()
        };
        let (typed, theirs) = (leaves(typed), leaves(&self.plain));
        let mut both = leaves(spelled).into_iter();
        both.any(|it| typed.contains(&it) && theirs.contains(&it))
    }

    fn repair(
        &self,
        wrong: &[&Statement],
        files: &Files,
        reading: &Reading,
    ) -> Option<(Line, String)> {
        let scored = wrong.iter().filter(|it| self.takes(it)).map(|it| {
            let value = self.spell(&it.value);
            let named = if it.role == self.role { 0.4 } else { 0.0 };
            (value.likeness(&self.plain) + named, value, it)
        });
        let is_let = |role: &Role| matches!(role, Role::Let(_));
        let is_like = |(score, value, it): &(f64, Tree, &&Statement)| {
            *score > ALIKE
                && (is_let(&it.role) == is_let(&self.role) || self.shares(&it.value, value))
        };
        let mut likest: Vec<_> = scored.filter(is_like).collect();
        likest.sort_by(|one, other| other.0.total_cmp(&one.0));
        let is_it = |value: &Tree| {
            let mut text = self.function.text.clone();
            text.replace_range(self.value.at.clone(), &value.within(super::tree::ATOM));
            let files = with(files, &[(self.function, &text)]);
            program(&files).is_some_and(|it| {
                [LOOKED, DRAWN]
                    .iter()
                    .all(|count| draws(&it, reading, *count))
            })
        };
        let (_, _, statement) = likest
            .into_iter()
            .take(TRIED)
            .find(|(_, value, _)| is_it(value))?;
        Some((statement.line.clone(), squeezed(&self.statement())))
    }

    /// The line of the chapter around it.
    fn statement(&self) -> String {
        let text = &self.function.text;
        let start = text[..self.value.at.start]
            .rfind('\n')
            .map_or(0, |it| it + 1);
        let end = text[self.value.at.end..].find(['\n', ';']);
        text[start..end.map_or(text.len(), |it| self.value.at.end + it)].to_owned()
    }
}

/// Names of values, and fields of an object itself, in the order in which they first stand.
fn names(tree: &Tree) -> Vec<String> {
    let is_field = tree.op.starts_with("□.") && tree.parts.len() == 1 && tree.parts[0].op == "self";
    let is_name =
        tree.parts.is_empty() && tree.op.starts_with(|c: char| c.is_alphabetic() || c == '_');
    if is_field || is_name && !tree.op.contains("::") {
        return vec![tree.text()];
    }
    let mut all: Vec<String> = Vec::new();
    for name in tree.parts.iter().flat_map(names) {
        if !all.contains(&name) {
            all.push(name);
        }
    }
    all
}

fn renamed(tree: &Tree, renames: &[(&String, &String)]) -> Tree {
    if let Some((_, new)) = renames.iter().find(|(old, _)| **old == tree.text()) {
        return Tree::new(new, Vec::new());
    }
    Tree {
        parts: tree.parts.iter().map(|it| renamed(it, renames)).collect(),
        ..tree.clone()
    }
}

/// What a file gives to names, returns, asks and calls.
fn statements(name: &str, text: &str) -> Vec<Statement> {
    let is_python = name.ends_with(".py");
    let comment = if is_python { "#" } else { "//" };
    let mut all = Vec::new();
    let (mut open, mut first, mut depth) = (String::new(), 0, 0);
    let typed: Vec<&str> = text.lines().collect();
    for (n, line) in with_brackets(name, text).lines().enumerate() {
        let code = line.split(comment).next().unwrap_or_default().trim();
        if open.is_empty() {
            first = n;
        }
        if !open.is_empty() {
            open.push(' ');
        }
        open += code;
        let brackets = |signs: [char; 2]| code.matches(signs).count() as i32;
        depth += brackets(['(', '[']) - brackets([')', ']']);
        if depth > 0 || !is_python && !code.ends_with([';', '{', '}']) && !code.is_empty() {
            continue;
        }
        let line = Line {
            file: name.to_owned(),
            number: first + 1,
            text: squeezed(&typed[first..=n].join(" ")),
        };
        let values = values(&open, is_python).into_iter();
        all.extend(values.filter_map(|(role, value)| {
            let (line, value) = (line.clone(), in_rust(value.trim(), is_python)?);
            Some(Statement { line, role, value })
        }));
        (open, depth) = (String::new(), 0);
    }
    all
}

/// The expressions of a statement, each with its role.
fn values(statement: &str, is_python: bool) -> Vec<(Role, &str)> {
    let mut all = Vec::new();
    let mut statement = bare(statement);
    while let Some(rest) = condition_of(statement) {
        // A statement may stand behind the condition.
        let end = if is_python {
            rest.find(": ")
        } else {
            closing(rest)
        };
        let (condition, rest) = rest.split_at(end.map_or(rest.len(), |at| at + 1));
        all.push((Role::Condition, condition.trim_end_matches(':')));
        statement = bare(rest);
    }
    if let Some(value) = statement.strip_prefix("return ") {
        all.push((Role::Result, value));
    } else if let Some((name, value)) = statement.split_once(" = ") {
        let name = name.rsplit([' ', '.', '>', '&']).next().unwrap_or(name);
        all.push((Role::Let(name.to_owned()), value));
    } else if statement.contains(['.', '>']) && statement.ends_with(')') {
        all.push((Role::Called, statement));
    }
    all
}

fn bare(statement: &str) -> &str {
    let statement = statement.trim_matches([' ', ';', '{', '}', ':']);
    statement.strip_prefix("else ").unwrap_or(statement)
}

/// What stands behind `if` or `elif`.
fn condition_of(statement: &str) -> Option<&str> {
    let rest = statement.strip_prefix("el").unwrap_or(statement);
    rest.strip_prefix("if")
        .filter(|it| it.starts_with([' ', '(']))
}

/// Where the first bracket is closed.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 0;
    let closed = text.char_indices().find(|(_, letter)| {
        depth += i32::from(*letter == '(') - i32::from(*letter == ')');
        depth == 0 && *letter == ')'
    });
    closed.map(|(at, _)| at)
}
