/// A square of `width` × `width` pixels, black at the upper left and yellow at
/// the lower right.
pub fn picture(width: u32) -> Picture {
    todo!()
}
