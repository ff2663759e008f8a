//! Mutation of source text: a chapter's whole program, which the interpreter draws, and edits
//! of it.

use std::fmt;
use std::sync::LazyLock;

use common::rtweekend::*;
use interpreter::{Canvas, SourceFile, TracedValue};

use crate::chapter::Chapter;
use crate::edit::Edit;

/// A chapter's program, right or with edits, that draws without being compiled.
#[derive(Clone, Debug)]
pub struct ChapterProgram {
    /// Which chapter it is meant to be.
    pub chapter: Chapter,
    code: interpreter::Program,
    /// This code in double precision, if only that makes levels.
    levels: Option<Box<interpreter::Program>>,
}

/// The output of a [`ChapterProgram`]: the numbers of a P3 file, traced when asked for.
#[derive(Clone, Debug)]
pub struct Output {
    program: ChapterProgram,
    canvas: Option<Canvas>,
    size: (u32, u32),
    /// True if the loop and the levels are the right ones, which are done here without the text.
    is_right_around: bool,
}

/// What else a program of rays has in its text: common's own sources.
const CAMERA: &str = include_str!("../../../../common/src/camera.rs");
const RENDER: &str = include_str!("../../../../common/src/engine/render.rs");
const COLOR: &str = include_str!("../../../../common/src/color.rs");
/// And what stands here for what no text can show.
const FILE: &str = include_str!("text/file.rs");
const VECTORS: &str = include_str!("text/vectors.rs");
const DOT: &str = include_str!("text/dot.rs");

/// The functions by which a color becomes a pixel of the file.
const AROUND: [&str; 3] = ["place", "print", "level"];

/// The functions of these vectors.
const OF_VECTORS: [&str; 5] = ["dot", "length_squared", "length", "normalize", "at"];

static RIGHT: [LazyLock<ChapterProgram>; 6] = [
    LazyLock::new(|| ChapterProgram::read(Chapter::BuildTest)),
    LazyLock::new(|| ChapterProgram::read(Chapter::Gradient)),
    LazyLock::new(|| ChapterProgram::read(Chapter::RedSphere)),
    LazyLock::new(|| ChapterProgram::read(Chapter::Normals)),
    LazyLock::new(|| ChapterProgram::read(Chapter::HalfBSphere)),
    LazyLock::new(|| ChapterProgram::read(Chapter::HittableList)),
];

/// Returns the files that a reader of the chapter types, as they should be.
pub fn typed_files(chapter: Chapter) -> Vec<SourceFile> {
    let files = chapter.files().iter();
    files
        .map(|&(name, text)| SourceFile::new(name, text))
        .collect()
}

/// Returns the files of the chapter's program, the root first: what the chapter has, and what of
/// `common` it uses.
pub fn files(chapter: Chapter) -> Vec<SourceFile> {
    let mut files = typed_files(chapter);
    files.sort_by_key(|it| !it.name.ends_with("lib.rs"));
    let mut add = |name: &str, text: &str, imported: &str| {
        files[0].text += &format!("\nmod {name};\n{imported}");
        let own = text.lines().filter(|line| !line.starts_with("use "));
        let own = own.fold(String::new(), |text, line| text + line + "\n");
        let import = match name {
            "render" => "use crate::camera::Camera;\n",
            _ => "",
        };
        let own = format!("use common::rtweekend::*;\n{import}{own}");
        files.push(SourceFile::new(format!("src/{name}.rs"), own));
    };
    add("file", FILE, "");
    if chapter > Chapter::BuildTest {
        add("camera", CAMERA, "");
        add("render", RENDER, "use crate::render::render;\n");
        add("vectors", VECTORS, "");
    }
    // The first chapter with rays writes its sky out.
    if chapter > Chapter::Gradient {
        let sky = COLOR.split("\n/// Stores").next().unwrap_or_default();
        add("color", sky, "use crate::color::sky;\n");
        add("dot", DOT, "");
    }
    files
}

/// Where a file of the chapter's program stands in this workspace.
pub(crate) fn source(chapter: Chapter, name: &str) -> String {
    match name {
        "src/camera.rs" | "src/color.rs" => format!("common/{name}"),
        "src/render.rs" => "common/src/engine/render.rs".to_owned(),
        "src/vectors.rs" | "src/dot.rs" => "common/src/vec3.rs".to_owned(),
        "src/file.rs" => "book/judge/slips/src/text/file.rs".to_owned(),
        name => format!("chapters/{}_{}/{name}", chapter as usize, chapter.name()),
    }
}

impl ChapterProgram {
    /// The chapter as it should be, from its own text.
    ///
    /// # Panics
    /// If it is not one of [`Chapter::OF_THE_BOOK`].
    pub fn right(chapter: Chapter) -> Self {
        let right = RIGHT.get(chapter as usize);
        Self::clone(right.expect("chapter 6 is no program of the book"))
    }

    /// The program of a reader of that chapter.
    pub fn typed(chapter: Chapter, code: interpreter::Program) -> Self {
        Self {
            chapter,
            code,
            levels: None,
        }
    }

    fn read(chapter: Chapter) -> Self {
        let code = interpreter::read(&files(chapter))
            .unwrap_or_else(|faults| panic!("the text of {chapter:?} is read: {}", faults[0]));
        Self {
            chapter,
            code,
            levels: None,
        }
    }

    /// Returns this program with these edits, one after the other, or `None` if one of them
    /// stands nowhere in it, or they make it no program.
    pub fn with(&self, edits: &[Edit]) -> Option<Self> {
        let mut changed = Vec::new();
        let mut program = self.clone();
        for edit in edits {
            if edit.is_precision() && self.chapter != Chapter::BuildTest {
                program = program.in_single_precision(edit);
            } else if !self.change(edit, &mut changed) {
                return None;
            }
        }
        let mut all = changed.into_iter();
        all.try_fold(program, |program, (name, text)| {
            program.with_function(&name, &text)
        })
    }

    /// Returns this program with those of these edits that stand in it, if that is one.
    pub(crate) fn with_any(&self, edits: &[Edit]) -> Option<Self> {
        let edits = edits.iter().filter(|edit| self.has(edit)).cloned();
        self.with(&edits.collect::<Vec<_>>())
    }

    /// Changes the texts of all functions in which the edit stands; whether it does somewhere.
    fn change(&self, edit: &Edit, changed: &mut Vec<(String, String)>) -> bool {
        let mut stands = false;
        for (name, text) in self.functions() {
            let place = changed.iter().position(|it| it.0 == name);
            let text = place.map_or(text, |place| &changed[place].1);
            let Some(new) = edit.applied_to(text) else {
                continue;
            };
            stands = true;
            match place {
                Some(place) => changed[place].1 = new,
                None => changed.push((name.to_owned(), new)),
            }
        }
        stands
    }

    /// Returns true if the edit can be made in it.
    pub(crate) fn has(&self, edit: &Edit) -> bool {
        match edit.is_precision() {
            true => self.chapter != Chapter::BuildTest,
            false => self.functions().any(|it| edit.stands_in(it.1)),
        }
    }

    /// Finds the first statement in which one of these edits stands, right and with all of them.
    pub(crate) fn statement_with(&self, edits: &[Edit]) -> Option<Edit> {
        let mut standing = edits.iter().filter(|edit| self.has(edit));
        let first = standing.next()?;
        if first.is_precision() {
            return Some(first.clone());
        }
        self.functions()
            .find_map(|(_, text)| first.statement(text, edits))
    }

    /// Returns this program with another text of one function, or `None` if that is none.
    pub fn with_function(&self, function: &str, text: &str) -> Option<Self> {
        let mut code = self.code.patched(function, text).ok()?;
        if OF_VECTORS.contains(&function) {
            code = code.instead_of_the_library(&OF_VECTORS);
        }
        let levels = self.levels.as_ref();
        let levels = levels.map(|it| it.patched(function, text).ok().map(Box::new));
        Some(Self {
            code,
            levels: levels.flatten(),
            ..*self
        })
    }

    /// Returns this program with every number and result rounded to 24 bits.
    fn in_single_precision(&self, edit: &Edit) -> Self {
        let code = self.code.instead_of_the_library(&OF_VECTORS);
        Self {
            chapter: self.chapter,
            code: code.in_single_precision(),
            levels: edit.is_as_in_cpp().then(|| Box::new(code)),
        }
    }

    /// Returns this program with what another one has changed, where both were made from a
    /// third; `None` if both have changed the same function.
    pub fn joined(&self, other: &Self, from: &Self) -> Option<Self> {
        let code = self.code.merged_with(&other.code, &from.code)?;
        Some(Self {
            code,
            ..self.clone()
        })
    }

    /// The functions by their names, `hit_sphere` or `Sphere::hit`, with their texts.
    pub fn functions(&self) -> impl Iterator<Item = (&str, &str)> {
        self.code.functions()
    }

    /// Returns the interpreter's program that is run, without the chapter.
    pub fn code(&self) -> &interpreter::Program {
        &self.code
    }

    /// Returns what the program prints when it is asked for a picture `width` pixels wide. Nothing
    /// is traced before a pixel is asked for.
    pub fn run(&self, width: u32) -> Output {
        let canvas = self.code.canvas(width).ok();
        let (columns, rows) = canvas.as_ref().map_or((0, 0), Canvas::size);
        let header = self.code.call_with_integers("header", &[columns, rows]);
        let size = match header.as_deref() {
            Some([columns, rows]) => (*columns as u32, *rows as u32),
            _ => (0, 0),
        };
        Output {
            program: self.clone(),
            canvas,
            size,
            is_right_around: self.is_right_around(),
        }
    }

    /// Returns true if its loop and its levels are as they stand in the text for the file.
    fn is_right_around(&self) -> bool {
        let mut functions = self.functions();
        functions.all(|(name, text)| !AROUND.contains(&name) || FILE.contains(text))
    }

    /// The `n`th pixel of a picture that wide, as red, green and blue.
    pub fn pixel(&self, width: u32, n: u32) -> [i32; 3] {
        self.run(width).pixel(n)
    }

    /// The ray that is cast for the pixel in a column and row of a picture that wide.
    pub fn ray(&self, width: u32, i: u32, j: u32) -> Option<Ray> {
        self.code.camera_ray(width, i, j)
    }

    /// The chapter's `ray_color`.
    pub fn ray_color(&self, ray: &Ray) -> Color {
        self.code.ray_color(ray)
    }

    /// The `hit_sphere` of chapters 2 to 4, which knows no interval: the nearer root `t`, in
    /// lengths of `ray.direction`. Chapter 2 only tells whether there is one.
    pub fn hit_sphere(&self, center: Point3, radius: f64, ray: &Ray) -> Option<f64> {
        self.code.hit_sphere(center, radius, ray)
    }
}

impl Output {
    /// Width and height as the header tells them.
    pub fn size(&self) -> (u32, u32) {
        self.size
    }

    /// The `n`th printed pixel as red, green and blue.
    ///
    /// The right program prints 0 to 255, a wrong one may print what no picture
    /// can hold. C++ converts to `int` in the same way, except that numbers
    /// beyond ±2³¹ and NaN become −2³¹ on some processors.
    pub fn pixel(&self, n: u32) -> [i32; 3] {
        self.printed(n).unwrap_or_default()
    }

    /// Returns the levels that are printed at the `n`th pixel, or `None` where the program stops.
    pub fn printed(&self, n: u32) -> Option<[i32; 3]> {
        let color = self.color(n)?;
        if self.is_right_around {
            return Some(
                color
                    .to_array()
                    .map(|component| (255.999 * component) as i32),
            );
        }
        let program = &self.program;
        let code = program.levels.as_deref().unwrap_or(&program.code);
        let levels = code.call_with_color("print", color)?;
        levels.try_into().ok()
    }

    /// The color of the `n`th printed pixel, unless the program stops there.
    pub(crate) fn color(&self, n: u32) -> Option<Color> {
        let (i, j) = self.place(n)?;
        self.canvas.as_ref()?.color(i, j).ok()
    }

    /// The ray of the `n`th printed pixel.
    pub(crate) fn ray(&self, n: u32) -> Option<Ray> {
        let (i, j) = self.place(n)?;
        let (width, _) = self.canvas.as_ref()?.size();
        self.program.ray(width, i, j)
    }

    /// The column and the row of the `n`th printed pixel.
    fn place(&self, n: u32) -> Option<(u32, u32)> {
        let (columns, rows) = self.canvas.as_ref()?.size();
        if self.is_right_around {
            return Some((n.checked_rem(columns)?, n / columns));
        }
        let place = self
            .program
            .code
            .call_with_integers("place", &[n, columns, rows])?;
        Some((place[0] as u32, place[1] as u32))
    }

    /// All pixels in the order in which they are printed.
    pub fn pixels(&self) -> impl Iterator<Item = [i32; 3]> + '_ {
        (0..self.size.0 * self.size.1).map(|n| self.pixel(n))
    }

    /// Returns what each `let` comes to on the way to the `n`th pixel.
    pub fn traced_values(&self, n: u32) -> Vec<TracedValue> {
        match (&self.canvas, self.place(n)) {
            (Some(canvas), Some((i, j))) => canvas.trace(i, j),
            _ => Vec::new(),
        }
    }

    /// Returns true if the ray of the `n`th pixel hits something: `ray_color` returns before its
    /// end.
    pub fn hits(&self, n: u32) -> bool {
        match (&self.canvas, self.place(n)) {
            (Some(canvas), Some((i, j))) => canvas.returns_early("ray_color", i, j),
            _ => false,
        }
    }

    /// All pixels as the same program stores them in Rust, where a conversion to a byte
    /// stops at 0 and 255.
    pub fn rgb(&self) -> impl Iterator<Item = [u8; 3]> + '_ {
        let stored = |level: i32| level.clamp(0, 255) as u8;
        self.pixels().map(move |pixel| pixel.map(stored))
    }

    /// Returns the picture that the program draws in Rust.
    ///
    /// # Panics
    /// If a header changes the number of pixels, and not only swaps width and height.
    pub fn picture(&self) -> Picture {
        let (width, height) = self.size;
        let rgb = self.rgb().flatten().collect();
        Picture::from_rgb(width, height, rgb)
            .expect("a header may swap width and height, but not change their product")
    }
}

/// The P3 file of the book's C++, which prints what it gets, 256 and −127 too.
impl fmt::Display for Output {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (width, height) = self.size;
        write!(f, "P3\n{width} {height}\n255\n")?;
        for [red, green, blue] in self.pixels() {
            writeln!(f, "{red} {green} {blue}")?;
        }
        Ok(())
    }
}
