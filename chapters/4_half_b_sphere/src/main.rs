//! Prints the picture of this chapter: `cargo run -p half_b_sphere > half_b_sphere.ppm`

fn main() -> std::process::ExitCode {
    common::chapter::main(|| half_b_sphere::picture(400))
}
