//! Any text is a scene or is not.

use verlock::scene::{Scene, SceneError};

use super::world::{is_small, is_sound};

/// Ticks for which a scene is played.
const TICKS: u64 = 3;

/// A scene gives the same world and the same commands each time, and plays; what is none says
/// where. True if the text is a scene whose world could be built.
pub fn scene(bytes: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(bytes) else { return false };
    let made = Scene::parse(text).and_then(|scene| scene.build().map(|world| (scene, world)));
    let (scene, mut world) = match made {
        Ok(made) => made,
        Err(error) => {
            is_somewhere(&error, text);
            return false;
        }
    };
    is_sound(&world);
    if !is_small(&world) {
        return true;
    }
    let again = scene.build().map(|again| again.hash());
    assert_eq!(again, Ok(world.hash()), "built twice");
    for _ in 0..TICKS {
        let commands = scene.commands(&world);
        assert!(scene.commands(&world) == commands, "asked twice");
        world.step(&commands);
        if !is_small(&world) {
            break;
        }
    }
    is_sound(&world);
    true
}

/// An error says what is wrong, and a wrong text where.
fn is_somewhere(error: &SceneError, text: &str) {
    assert_ne!(error.to_string(), "");
    if let SceneError::Syntax { line, column, message } = error {
        let lines = text.split('\n').count();
        assert!((1..=lines).contains(&(*line as usize)), "line of {error}");
        assert!(*column >= 1 && *column as usize <= text.len() + 1, "column of {error}");
        assert_ne!(message, "");
    }
}
