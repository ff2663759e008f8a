//! The steps of each chapter: a few lines to type at a time, and a picture to see after each.

use crate::chapter::Chapter;
use crate::edit::Edit;
use crate::program::ChapterProgram;

/// A step of a chapter: a few lines that a reader types, after which the program draws a new
/// picture.
pub struct ChapterStep {
    /// A sentence or two, in plain text with code in backticks, that tell what to type, and what
    /// the picture will show.
    pub instruction: &'static str,
    /// A description of the picture, for those who can't see it.
    pub description: &'static str,
    /// The edits, `right→wrong`, that turn the whole chapter into the step; none for the last step.
    edits: &'static [&'static str],
}

impl ChapterStep {
    /// Returns the program of a chapter as it is after this step; `program` is the whole one. If
    /// the code of later steps is not found in it, the whole program is returned.
    pub fn applied_to(&self, program: &ChapterProgram) -> ChapterProgram {
        let edits: Vec<Edit> = self.edits.iter().map(|it| Edit::parse(it)).collect();
        program.with_any(&edits).unwrap_or_else(|| program.clone())
    }
}

/// Returns the steps of a chapter, first to last. The last one draws the chapter's picture. Empty
/// for chapter 6.
pub fn of_chapter(chapter: Chapter) -> &'static [ChapterStep] {
    STEPS.get(chapter as usize).copied().unwrap_or_default()
}

/// The last step of a chapter, but for its words: the program is whole.
const LAST: ChapterStep = ChapterStep {
    instruction: "",
    description: "",
    edits: &[],
};

/// The steps of each chapter of the book.
const STEPS: [&[ChapterStep]; 6] = [
    &[ChapterStep {
        instruction: "Red grows to the right and green grows downwards, from 0 to 1.",
        description: Chapter::BuildTest.shows(),
        ..LAST
    }],
    &[
        ChapterStep {
            instruction: "Every ray is white: `ray_color` returns (1, 1, 1).",
            description: "A white rectangle, 16 wide for every 9 high",
            edits: &["(1.0 - a) * white + a * blue→white"],
        },
        ChapterStep {
            instruction: "Where does each ray go? Red is the x of its direction and green is the y.",
            description: "Black in the lower left quarter, red growing to the right, green growing upwards",
            edits: &[
                "(1.0 - a) * white + a * blue→Color::new(ray.direction.x, ray.direction.y, 0.0)",
            ],
        },
        ChapterStep {
            instruction: "How steeply does it climb? Gray of a = ½(y + 1), with the y of the unit direction.",
            description: "Gray: dark at the bottom, light at the top, and lightest above the middle",
            edits: &["(1.0 - a) * white + a * blue→a * white"],
        },
        ChapterStep {
            instruction: "Blend white and the blue (0.5, 0.7, 1) by the weight a.",
            description: Chapter::Gradient.shows(),
            ..LAST
        },
    ],
    &[
        ChapterStep {
            instruction: "Nothing is hit yet: `hit_sphere` says false, and the sky of chapter 1 is there.",
            description: Chapter::Gradient.shows(),
            edits: &["discriminant >= 0.0→false"],
        },
        ChapterStep {
            instruction: "oc, a, b, c and the discriminant: `hit_sphere` says whether there is a root.",
            description: Chapter::RedSphere.shows(),
            ..LAST
        },
    ],
    &[
        ChapterStep {
            instruction: "`hit_sphere` says where: the nearer root. The disc stays red where there is one.",
            description: Chapter::RedSphere.shows(),
            edits: &["0.5 * (normal + Vec3::ONE)→Color::new(1.0, 0.0, 0.0)"],
        },
        ChapterStep {
            instruction: "How far is that? Gray of t where t > 0: the nearer, the darker.",
            description: "A gray disc in front of the sky, darker in its middle than at its rim",
            edits: &["0.5 * (normal + Vec3::ONE)→t * Vec3::ONE"],
        },
        ChapterStep {
            instruction: "Where t > 0, the unit normal at `ray.at(t)` becomes the color: ½(n + 1).",
            description: Chapter::Normals.shows(),
            ..LAST
        },
    ],
    &[ChapterStep {
        instruction: "With h = −b/2 in place of b, every 2 and 4 goes. Not one bit changes.",
        description: Chapter::HalfBSphere.shows(),
        ..LAST
    }],
    &[
        ChapterStep {
            instruction: "A `Sphere` says where it is hit and from which side, and a list of one finds it: the ball of chapter 4 is back.",
            description: Chapter::HalfBSphere.shows(),
            edits: &["world.add(Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0));→"],
        },
        ChapterStep {
            instruction: "`world` gets the ground, at (0, −100.5, −1) with radius 100, and the list finds the nearest. Then comes a trait, and no pixel changes.",
            description: Chapter::HittableList.shows(),
            ..LAST
        },
    ],
];
