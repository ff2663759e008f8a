
#[test]
fn a_sphere_obeys_the_laws() {
    holds(Trial::default().record(&record));
}

#[test]
fn list_obeys_the_laws() {
    holds(Trial::default().list(&record, &nearest));
}

#[test]
fn ray_color_obeys_the_laws() {
    holds(Trial::default().ray_color(ChapterScene::MyScene, &ray_color));
}

#[test]
fn set_face_normal_obeys_the_laws() {
    holds(Trial::default().set_face_normal(&set_face_normal));
}
