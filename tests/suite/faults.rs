//! The real programs on bad days: interrupted, in company, and refused by the system.

use std::fs::{self, Permissions};
use std::os::unix::fs::PermissionsExt;
use std::os::unix::process::CommandExt;
use std::process::{Command, Stdio};
use std::thread;

use rustix::process::geteuid;
use tempfile::TempDir;

use crate::command_line::{assert_success, p3, path_of, run};
use crate::left_out::left_out;

#[test]
fn without_more_threads_the_picture_is_drawn_by_one() {
    // A limit that holds for root too: on what a process may do who is nobody.
    let copy = TempDir::new().expect("a folder");
    let program = copy.path().join("gradient");
    fs::copy(path_of("gradient"), &program).expect("a copy that anyone can reach");
    fs::set_permissions(copy.path(), Permissions::from_mode(0o755)).expect("the mode is set");
    let limited = |script: &str| {
        // dash and bash call the limit by different letters.
        let mut shell = shell(&format!("ulimit -p 0 2>/dev/null || ulimit -u 0; {script}"));
        if geteuid().is_root() {
            shell.uid(65534).gid(65534);
        }
        shell
    };
    let a_process_is_refused = !can(&mut limited("(true)"));
    if !a_process_is_refused || thread::available_parallelism().map_or(1, usize::from) == 1 {
        left_out("no limit on threads holds here, or none would be started");
        return;
    }
    let output = run(limited("exec \"$0\" --width 2000").arg(program));
    assert_success(&output);
    assert!(output.stdout == p3(&gradient::picture(2000)));
}

fn shell(script: &str) -> Command {
    let mut shell = Command::new("sh");
    shell.args(["-c", script]);
    shell
}

fn can(command: &mut Command) -> bool {
    let output = command.stdin(Stdio::null()).output();
    output.is_ok_and(|output| output.status.success())
}
