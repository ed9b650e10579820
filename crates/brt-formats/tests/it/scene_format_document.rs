//! Every example of the format's description is a scene.

use crate::common::{good, project_file};
use brt_formats::Format;

#[test]
fn every_example_is_a_scene() {
    let document = std::fs::read_to_string(project_file("docs/scene-format.md")).unwrap();
    let mut kinds = Vec::new();
    for block in document.split("```toml\n").skip(1) {
        let (text, _) = block.split_once("```").expect("the block ends");
        let (scene, report) = good(Format::Toml, text);
        assert!(report.diagnostics.is_empty());
        kinds.extend(scene.objects.iter().map(|object| object.shape.kind()));
    }
    for kind in ["sphere", "plane", "polygon", "disc", "cylinder", "cone", "mesh"] {
        assert!(kinds.contains(&kind), "there is no example of a {kind}");
    }
}
