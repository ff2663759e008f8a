//! The steps of each chapter: a few lines to type, and one thing to see.

use common::rtweekend::*;

use crate::chapter::Chapter;
use crate::program::Program;

/// A few lines to type, after which there is something new to see.
pub struct Step {
    /// What to type, and what it will show.
    pub says: &'static str,
    /// Whether all that the laws ask for is written by then.
    pub has_laws: bool,
    shows: Shows,
}

/// What a picture shows when a step is done.
enum Shows {
    /// The picture of a chapter.
    Chapter(Chapter),
    /// What each ray sees, in the shape of the book's pictures; and that in words.
    Rays(fn(&Ray) -> Color, &'static str),
}

impl Step {
    /// The picture that there is to see, in the size of the reader's.
    pub fn picture(&self, width: u32, height: u32) -> Picture {
        let camera = Camera::with_size(width, height);
        match self.shows {
            Shows::Chapter(chapter) => {
                let program = Program::right(chapter);
                Picture::paint(width, height, move |i, j| {
                    (program.color)(&program, &camera, i, j)
                })
            }
            Shows::Rays(ray_color, _) => {
                Picture::paint(width, height, move |i, j| ray_color(&camera.ray(i, j)))
            }
        }
    }

    /// What there is to see, for whoever can't.
    pub fn seen(&self) -> &'static str {
        match self.shows {
            Shows::Chapter(chapter) => chapter.shows(),
            Shows::Rays(_, seen) => seen,
        }
    }
}

/// The steps that lead to the picture of `chapter`, which the last of them shows.
pub fn of(chapter: Chapter) -> &'static [Step] {
    match chapter {
        Chapter::BuildTest => &[Step {
            says: "Red grows to the right and green grows downwards, from 0 to 1.",
            has_laws: false,
            shows: Shows::Chapter(Chapter::BuildTest),
        }],
        Chapter::Gradient => &[
            Step {
                says: "Every ray is white: `ray_color` returns (1, 1, 1).",
                has_laws: false,
                shows: Shows::Rays(
                    |_| Color::ONE,
                    "A white rectangle, 16 wide for every 9 high",
                ),
            },
            Step {
                says: "Where does each ray go? Red is the x of its direction and green is the y.",
                has_laws: false,
                shows: Shows::Rays(
                    |ray| Color::new(ray.direction.x, ray.direction.y, 0.0),
                    "Black in the lower left quarter, red growing to the right, green growing upwards",
                ),
            },
            Step {
                says: "How steeply does it climb? Gray of a = ½(y + 1), with the y of the unit direction.",
                has_laws: false,
                shows: Shows::Rays(
                    |ray| 0.5 * (ray.direction.normalize().y + 1.0) * Color::ONE,
                    "Gray: dark at the bottom, light at the top, and lightest above the middle",
                ),
            },
            Step {
                says: "Blend white and the blue (0.5, 0.7, 1) by the weight a.",
                has_laws: false,
                shows: Shows::Chapter(Chapter::Gradient),
            },
        ],
        Chapter::RedSphere => &[
            Step {
                says: "Nothing is hit yet: `hit_sphere` says false, and the sky of chapter 1 is there.",
                has_laws: false,
                shows: Shows::Chapter(Chapter::Gradient),
            },
            Step {
                says: "oc, a, b, c and the discriminant: `hit_sphere` says whether there is a root.",
                has_laws: false,
                shows: Shows::Chapter(Chapter::RedSphere),
            },
        ],
        Chapter::Normals => &[
            Step {
                says: "`hit_sphere` says where: the nearer root. The disc stays red where there is one.",
                has_laws: true,
                shows: Shows::Chapter(Chapter::RedSphere),
            },
            Step {
                says: "How far is that? Gray of t where t > 0: the nearer, the darker.",
                has_laws: true,
                shows: Shows::Rays(
                    gray_of_t,
                    "A gray disc in front of the sky, darker in its middle than at its rim",
                ),
            },
            Step {
                says: "Where t > 0, the unit normal at `ray.at(t)` becomes the color: ½(n + 1).",
                has_laws: false,
                shows: Shows::Chapter(Chapter::Normals),
            },
        ],
        Chapter::HalfBSphere => &[Step {
            says: "With h = −b/2 in place of b, every 2 and 4 goes. Not one bit changes.",
            has_laws: false,
            shows: Shows::Chapter(Chapter::HalfBSphere),
        }],
        Chapter::HittableList => &[
            Step {
                says: "A `Sphere` is `Hittable`, and a list of one finds it: the ball of chapter 4 is back.",
                has_laws: false,
                shows: Shows::Chapter(Chapter::HalfBSphere),
            },
            Step {
                says: "`world` gets the ground, at (0, −100.5, −1) with radius 100, and the list finds the nearest.",
                has_laws: false,
                shows: Shows::Chapter(Chapter::HittableList),
            },
        ],
        Chapter::SpeedVsAccuracy => &[],
    }
}

/// The sphere of chapter 3, each point in the gray of its t.
fn gray_of_t(ray: &Ray) -> Color {
    match normals::hit_sphere(Point3::new(0.0, 0.0, -1.0), 0.5, ray) {
        Some(t) if t > 0.0 => t * Color::ONE,
        _ => sky(ray),
    }
}
