use crate::sandbox::Sandbox;

/// Every shell gets a script that knows the commands.
#[test]
fn completions_know_the_commands() {
    let sandbox = Sandbox::new("completions");
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = sandbox.run(&["completions", shell]).expect(0);
        assert!(script.text().contains("verify"), "{shell}");
    }
    sandbox.run(&["completions", "abacus"]).expect(2);
}

/// A page on stdout, or a page for each command in a folder, never over another file.
#[test]
fn manual_pages() {
    let sandbox = Sandbox::new("man");
    let page = sandbox.run(&["man"]).expect(0);
    assert!(page.text().contains(".TH verlock 1"), "{}", page.text());
    sandbox.write("pages/verlock-run.1", b"mine");
    sandbox.run(&["man", "pages"]).expect(2).says("verlock-run.1: exists");
    assert!(!sandbox.path("pages/verlock.1").exists());
    sandbox.run(&["man", "pages", "--force"]).expect(0);
    sandbox.run(&["man", "new/pages"]).expect(0);
    assert_eq!(sandbox.read("new/pages/verlock.1"), sandbox.read("pages/verlock.1"));
    for name in ["verlock", "verlock-run", "verlock-verify", "verlock-diff", "verlock-man"] {
        let page = String::from_utf8(sandbox.read(&format!("pages/{name}.1"))).expect("UTF-8");
        assert!(page.contains(&format!(".TH {name} 1")), "{page}");
    }
}
