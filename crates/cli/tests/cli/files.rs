use std::process::Stdio;

use crate::sandbox::{SCENE, Sandbox};

/// What is there stays, unless `--force` is given; nothing is written beside it either.
#[test]
fn nothing_is_overwritten() {
    let sandbox = Sandbox::new("files-force");
    sandbox.write("kept", b"precious");
    for option in ["--record", "--save", "--hashes"] {
        let other = if option == "--save" { "--record" } else { "--save" };
        let args = ["run", "a.ron", option, "kept", other, "new"];
        sandbox.run(&args).expect(2).says("kept: exists");
        assert_eq!(sandbox.read("kept"), b"precious");
        assert!(!sandbox.path("new").exists());
    }
    sandbox.run(&["run", "a.ron", "--record", "kept", "--force"]).expect(0);
    sandbox.run(&["verify", "kept"]).expect(0);
    let twice = ["run", "a.ron", "--record", "one", "--save", "one", "--force"];
    sandbox.run(&twice).expect(2).says("the same file");
    let nowhere = ["run", "a.ron", "--record", "new", "--save", "no/where"];
    sandbox.run(&nowhere).expect(2).says("no/where: there is no folder no");
    assert!(!sandbox.path("new").exists());
    let scene = sandbox.read("a.ron");
    for record in ["a.ron", "./a.ron"] {
        let same = ["run", "a.ron", "--record", record, "--force"];
        sandbox.run(&same).expect(2).says("a.ron: the scene itself would be overwritten");
    }
    assert_eq!(sandbox.read("a.ron"), scene);
}

/// `-` is stdin and stdout; a file on stdout is not mixed with the report.
#[test]
fn dashes_are_streams() {
    let sandbox = Sandbox::recorded("files-dash");
    let recorded =
        sandbox.run_with(&["run", "-", "--record", "-", "--keyframes", "2"], SCENE.as_bytes());
    let recorded = recorded.expect(0);
    assert_eq!(recorded.stdout, sandbox.read("a.replay"));
    assert!(recorded.stderr.starts_with("tick 6\n"), "{}", recorded.stderr);
    sandbox.run_with(&["verify", "-"], &recorded.stdout).expect(0);
    sandbox.run_with(&["info", "-"], SCENE.as_bytes()).expect(0);
    let saved = sandbox.run(&["run", "a.ron", "--save", "-"]).expect(0);
    assert_eq!(saved.stdout, sandbox.read("a.snap"));
    let dump = sandbox.run(&["dump", "a.snap"]).expect(0);
    assert_eq!(sandbox.run_with(&["dump", "-"], &saved.stdout).expect(0).stdout, dump.stdout);
}

/// Files and streams over the limit prove nothing; at the limit they do.
#[test]
fn long_files_are_refused() {
    let sandbox = Sandbox::recorded("files-limit");
    let replay = sandbox.read("a.replay");
    let (enough, little) = (replay.len().to_string(), (replay.len() - 1).to_string());
    sandbox.run(&["verify", "a.replay", "--limit", &enough]).expect(0);
    sandbox.run(&["verify", "a.replay", "--limit", &little]).expect(3).says("longer than --limit");
    sandbox.run_with(&["info", "-", "--limit", &enough], &replay).expect(0);
    sandbox.run_with(&["info", "-", "--limit", &little], &replay).expect(3).says("longer than");
}

/// A reader that leaves early changes neither the result nor causes a message.
#[test]
fn reader_may_leave() {
    let sandbox = Sandbox::recorded("files-pipe");
    for (args, code) in
        [(["dump", "a.snap"], 0), (["verify", "a.replay"], 0), (["verify", "a.snap"], 3)]
    {
        let mut command = sandbox.command(&args);
        let mut child =
            command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("a start");
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("an end");
        assert_eq!(output.status.code(), Some(code), "{args:?}");
        assert_eq!(output.stderr.is_empty(), code == 0, "{args:?}");
    }
}

/// Data that cannot be written is an error.
#[test]
#[cfg(target_os = "linux")]
fn full_disk_is_told() {
    let sandbox = Sandbox::recorded("files-full");
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("a device");
    let output = sandbox.command(&["dump", "a.snap"]).stdout(full).output().expect("an end");
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stderr.starts_with(b"verlock: stdout: "));
    sandbox.run(&["run", "a.ron", "--record", "/dev/full", "--force"]).expect(2).says("/dev/full");
}

/// Wrong usage is 2, help and version are 0, and messages in a pipe have no colours.
#[test]
fn usage() {
    let sandbox = Sandbox::new("files-usage");
    for args in [&[][..], &["lift"], &["run"], &["verify"], &["run", "a.ron", "--ticks", "x"]] {
        let outcome = sandbox.run(args).expect(2);
        assert!(
            outcome.stdout.is_empty()
                && outcome.stderr.contains("Usage") | outcome.stderr.contains("help")
        );
    }
    sandbox.run(&["--help"]).expect(0);
    assert!(sandbox.run(&["--version"]).expect(0).text().contains("SIM_VERSION"));
    assert!(!sandbox.run(&["info", "none"]).expect(2).says("none: ").stderr.contains('\u{1b}'));
}
