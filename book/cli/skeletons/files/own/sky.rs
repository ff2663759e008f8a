/// The sky of chapter 1.
pub fn sky(ray: &Ray) -> Color {
    todo!()
}
