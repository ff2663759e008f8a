
#[test]
fn a_sphere_obeys_the_laws() {
    let trial = Trial::of(Chapter::MyChapter);
    all_succeed([trial.record(&record)]);
}

#[test]
fn list_obeys_the_laws() {
    let trial = Trial::of(Chapter::MyChapter);
    all_succeed([trial.list(&nearest)]);
}

#[test]
fn ray_color_obeys_the_laws() {
    let trial = Trial::of(Chapter::MyChapter);
    all_succeed([trial.ray_color(&ray_color)]);
}

#[test]
fn set_face_normal_obeys_the_laws() {
    face::is_turned_against_the_ray(&set_face_normal);
}
