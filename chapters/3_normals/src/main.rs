//! Prints the picture of this chapter: `cargo run -p normals > normals.ppm`

fn main() -> std::process::ExitCode {
    common::chapter::main(|| normals::picture(400))
}
