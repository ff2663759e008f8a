//! Prints the picture of this chapter: `cargo run -p normals > normals.ppm`

fn main() -> std::process::ExitCode {
    common::engine::main(400, normals::picture)
}
