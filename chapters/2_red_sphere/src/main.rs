//! Prints the picture of this chapter: `cargo run -p red_sphere > red_sphere.ppm`

fn main() -> std::process::ExitCode {
    common::engine::main(400, red_sphere::picture)
}
