//! Prints the picture of this chapter: `cargo run -p half_b_sphere > half_b_sphere.ppm`

fn main() -> std::process::ExitCode {
    common::engine::main(400, half_b_sphere::picture)
}
