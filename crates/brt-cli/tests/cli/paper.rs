//! `brt paper`.

use crate::bench::Bench;

#[test]
fn the_papers_page_of_an_own_scene_is_written_with_its_tables() {
    let bench = Bench::new();
    let ended = bench.done("paper --quick --sizes 16,32 --repeat 1 --scene ball.toml -o out");
    assert!(ended.text().contains("P19  holds") && ended.text().contains("paper.html"));
    assert!(ended.errors.is_empty(), "no progress in a pipe: {}", ended.errors);
    for file in ["paper.html", "fig1.csv", "verdicts.csv", "numbers.csv"] {
        assert!(bench.path("out").join(file).exists(), "{file}");
    }
}

#[test]
fn powers_of_a_single_size_are_not_told() {
    let bench = Bench::new();
    bench.done("paper --quick --sizes 16 --repeat 1 --scene ball.toml -o out");
    let page = String::from_utf8(bench.read("out/paper.html")).unwrap();
    assert!(!page.contains("to the power –"), "{page}");
}

#[test]
fn sizes_and_repetitions_are_checked() {
    let bench = Bench::new();
    for wrong in ["--sizes 4", "--sizes 128,x", "--repeat 0", "--scene none.toml"] {
        assert_ne!(bench.run(&format!("paper {wrong} -o out")).code, Some(0), "{wrong}");
    }
    assert!(!bench.path("out").exists());
}
