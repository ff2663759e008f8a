//! Prints the picture of this chapter: `cargo run -p red_sphere > red_sphere.ppm`

fn main() -> std::process::ExitCode {
    common::chapter::main(|| red_sphere::picture(400))
}
