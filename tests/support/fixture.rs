//! The files under `fixtures/`, and how they are accepted anew.

use std::fs;
use std::path::{Path, PathBuf};

use verlock::scene::Scene;

/// Whether the processor is emulated (`.ci/targets.sh` says so when it builds): what it computes is
/// then compared on every tick, but what is done to the worlds in between only on some.
pub const EMULATED: bool = option_env!("VERLOCK_EMULATED").is_some();

/// A scene of `fixtures/scenes`.
pub struct Fixture {
    pub name: String,
    pub scene: Scene,
}

/// Scenes of thousands of particles.
const LARGE: [&str; 3] = ["cloud", "cloth100", "net"];

impl Fixture {
    /// Whether it has thousands of particles: the others have no work for threads.
    pub fn is_large(&self) -> bool {
        LARGE.contains(&&*self.name)
    }

    /// All of them, by name.
    pub fn all() -> Vec<Self> {
        let files = fs::read_dir(path("scenes")).expect("the folder of scenes");
        let names = files.map(|file| file.expect("a file").file_name().into_string());
        let mut names: Vec<String> = names.map(|name| name.expect("a name in UTF-8")).collect();
        names.sort_unstable();
        assert!(names.len() > 5, "only {} scenes", names.len());
        let named = |file: String| {
            let name = file.strip_suffix(".scene.ron").expect("only scenes are there");
            Self::read(name)
        };
        names.into_iter().map(named).collect()
    }

    /// The one of this name.
    pub fn read(name: &str) -> Self {
        let text = fs::read_to_string(path(&format!("scenes/{name}.scene.ron")));
        let mesh = |file: &str| {
            String::from_utf8(read(&format!("scenes/{file}"))).map_err(|error| error.to_string())
        };
        let scene = Scene::parse_with(&text.expect("a text"), mesh).expect("a scene");
        Self { name: name.into(), scene }
    }
}

/// Where a fixture is.
pub fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(name)
}

/// The bytes of a fixture; nothing if there is none.
pub fn read(name: &str) -> Vec<u8> {
    fs::read(path(name)).unwrap_or_default()
}

/// Accepts new bytes of a fixture.
pub fn write(name: &str, bytes: &[u8]) {
    let path = path(name);
    fs::create_dir_all(path.parent().expect("a folder")).expect("to make the folder");
    fs::write(path, bytes).expect("to write the fixture");
}

/// Whether what is found is to be accepted: by `BLESS=1`, and never where `CI` is set.
pub fn is_blessing() -> bool {
    let [bless, ci] = ["BLESS", "CI"].map(|name| std::env::var_os(name).is_some());
    assert!(!(bless && ci), "goldens are not accepted where CI is set");
    bless
}
