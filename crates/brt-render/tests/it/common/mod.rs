//! What tests of single scenes share.

use brt_render::{HistoryKind, Layer, Method, Run, Settings};
use brt_scene::Scene;
use brt_testkit::{Rendered, render_at_levels};

/// A scene by a method, with its ray histories.
pub(crate) fn rendered(scene: &Scene, method: Method, size: [u32; 2]) -> Rendered {
    assert_eq!(scene.check(), []);
    let layers = vec![Layer::History];
    let settings = Settings { method, layers, history: HistoryKind::Lit, ..Settings::new(size) };
    render_at_levels(scene, &settings, &Run { threads: 1, ..Run::default() })
}

/// Number of pixels of different colour.
pub(crate) fn differing(a: &Rendered, b: &Rendered) -> usize {
    a.colors.iter().zip(&b.colors).filter(|(a, b)| a != b).count()
}
