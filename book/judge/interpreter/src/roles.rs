//! Roles: which of a text's functions and structs are those of a chapter.

use crate::names::{Names, Signature};
use crate::types::{Head, Type};

/// The functions of a chapter, by their numbers, and its types.
#[derive(Clone, Debug, Default)]
pub(crate) struct Roles {
    pub(crate) picture: Option<usize>,
    pub(crate) ray_color: Option<usize>,
    pub(crate) hit_sphere: Option<usize>,
    pub(crate) world: Option<usize>,
    pub(crate) sphere: Option<(usize, usize)>,
    pub(crate) list: Option<List>,
    /// Where `t`, `point`, `normal` and `front_face` are in a record.
    pub(crate) record: Option<[usize; 4]>,
    /// The reader's own kinds of these, if they are not ours.
    pub(crate) own_ray: Option<u32>,
    pub(crate) own_vec3: Option<u32>,
}

#[derive(Clone, Debug)]
pub(crate) struct List {
    pub(crate) ty: Type,
    pub(crate) new: Option<usize>,
    pub(crate) add: usize,
    pub(crate) hit: usize,
}

impl Roles {
    pub(crate) fn of(names: &Names) -> Self {
        let function = |name: &str, parameters| {
            let is_it = |it: &Signature| {
                it.name == name
                    && it.of.is_none()
                    && it.parameters.len() == parameters
                    && !it.is_constant
            };
            names.functions.iter().position(is_it)
        };
        let kind = |name: &str| {
            let kind = names.kinds.iter().position(|it| it.name == name);
            kind.map(|it| Type::from(Head::Own(it as u32)))
        };
        let method = |ty: &Type, name| names.method(ty.0, name);
        let ray_color = function("ray_color", 1).or_else(|| function("ray_color", 2));
        // Vectors are what a ray is made of.
        let ray = ray_color.and_then(|it| names.functions[it].parameters.first());
        let own_ray = ray.and_then(own_kind);
        let vec3 = own_ray.map(|it| &names.kinds[it as usize].fields);
        let own_vec3 = vec3.and_then(|it| own_kind(&it.first()?.ty));
        Self {
            picture: function("picture", 1),
            ray_color,
            hit_sphere: function("hit_sphere", 3),
            world: function("world", 0),
            sphere: kind("Sphere").and_then(|it| Some((method(&it, "new")?, method(&it, "hit")?))),
            list: kind("HittableList").and_then(|it| {
                Some(List {
                    new: method(&it, "default").or_else(|| method(&it, "new")),
                    add: method(&it, "add")?,
                    hit: method(&it, "hit")?,
                    ty: it,
                })
            }),
            record: kind("HitRecord").and_then(|it| {
                let Head::Own(kind) = it.0 else { return None };
                let place = |name| names.kinds[kind as usize].field(name);
                Some([
                    place("t")?,
                    place("point").or_else(|| place("p"))?,
                    place("normal")?,
                    place("front_face")?,
                ])
            }),
            own_ray,
            own_vec3,
        }
    }
}

fn own_kind(ty: &Type) -> Option<u32> {
    match ty.stripped().0 {
        Head::Own(kind) => Some(kind),
        _ => None,
    }
}
