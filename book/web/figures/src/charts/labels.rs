//! Label placement by backtracking: names beside their marks, over no other name and no line.

use crate::prelude::*;
use crate::text::{SMALL, width};

/// A rectangle of the sheet, by its upper left and lower right corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds(pub(super) DVec2, pub(super) DVec2);

impl Bounds {
    /// Makes the bounds of a horizontal or upright stretch, or a point, with a margin around it.
    pub(super) fn around(one: DVec2, other: DVec2, margin: f64) -> Self {
        Self(one.min(other) - margin, one.max(other) + margin)
    }

    fn meets(&self, other: &Self) -> bool {
        self.0.cmplt(other.1).all() && other.0.cmplt(self.1).all()
    }

    fn holds(&self, other: &Self) -> bool {
        self.0.cmple(other.0).all() && other.1.cmple(self.1).all()
    }
}

/// A name to be placed: the mark that it belongs to, the color, and the words.
pub(super) struct Name<'a> {
    pub(super) mark: DVec2,
    pub(super) idea: &'a str,
    pub(super) words: String,
}

/// A place for a name: where the text starts, its bounds, and the stretches of its leader.
#[derive(Clone)]
struct Place {
    text: DVec2,
    taken: Vec<Bounds>,
    leader: Option<[DVec2; 3]>,
}

/// Writes the names inside `sheet` so that none touches another, nor one of `obstacles`: each
/// beside its mark, or farther away on a leader, which may cross a line but no name.
///
/// # Errors
/// If there is no room for all of them.
pub(super) fn write(
    svg: &mut Svg,
    names: &[Name<'_>],
    obstacles: &[Bounds],
    sheet: &Bounds,
) -> Result<(), String> {
    let is_free = |place: &Place| {
        let text = &place.taken[0];
        sheet.holds(text) && !obstacles.iter().any(|obstacle| text.meets(obstacle))
    };
    let choices = names.iter().map(|name| {
        let mut places = places(name);
        places.retain(is_free);
        places
    });
    let choices: Vec<Vec<Place>> = choices.collect();
    // Those with the least room choose first.
    let mut order: Vec<usize> = (0..names.len()).collect();
    order.sort_by_key(|&n| choices[n].len());
    let mut budget = 100_000;
    let mut placed = Vec::new();
    if !fits(&choices, &order, &mut placed, &mut budget) {
        let words: Vec<&str> = names.iter().map(|name| &name.words[..]).collect();
        return Err(format!("no room for the names {}", words.join(", ")));
    }
    for (n, place) in order.into_iter().zip(placed) {
        if let Some(leader) = place.leader {
            svg.path("faint thin", &leader);
        }
        svg.small_label(names[n].idea, place.text, Start, &names[n].words);
    }
    Ok(())
}

/// Places the names of `order` one after the other; goes back where one finds no place.
fn fits(
    choices: &[Vec<Place>],
    order: &[usize],
    placed: &mut Vec<Place>,
    budget: &mut usize,
) -> bool {
    let Some(&next) = order.get(placed.len()) else {
        return true;
    };
    for place in &choices[next] {
        *budget = budget.saturating_sub(1);
        let taken = || placed.iter().flat_map(|other: &Place| &other.taken);
        let collides = |it: &Bounds| taken().any(|other| it.meets(other));
        if *budget == 0 || place.taken.iter().any(collides) {
            continue;
        }
        placed.push(place.clone());
        if fits(choices, order, placed, budget) {
            return true;
        }
        placed.pop();
    }
    false
}

/// Lists places for a name, the nearest first: beside its mark, or on a leader that goes up or down
/// and, unless the name is right there, aside.
fn places(name: &Name<'_>) -> Vec<Place> {
    let wide = width(&name.words, SMALL);
    let mut places = Vec::new();
    for level in 0..32 {
        for up in [1.0, -1.0] {
            let y = -up * 7.0 * f64::from(level);
            for aside in [10.0, -10.0 - wide, -0.5 * wide, 30.0, -30.0 - wide] {
                let text = name.mark + spot(aside, y + 4.0);
                let from = name.mark.down(-up * 7.0);
                let turn = name.mark.down(y);
                let leader = match aside {
                    0.0.. => [from, turn, spot(text.x - 2.0, turn.y)],
                    _ if aside + wide < 0.0 => [from, turn, spot(text.x + wide + 2.0, turn.y)],
                    _ => [from, turn.down(up * 8.0), turn.down(up * 8.0)],
                };
                let mut taken = vec![Bounds(text.down(-10.0), text + spot(wide, 3.5))];
                if level > 0 {
                    let stretches = leader.windows(2);
                    taken.extend(stretches.map(|ends| Bounds::around(ends[0], ends[1], 0.0)));
                }
                let leader = (level > 0).then_some(leader);
                places.push(Place {
                    text,
                    taken,
                    leader,
                });
            }
        }
    }
    places
}
