//! The page of `brt paper`: complete, and in agreement with its tables. Paper: P1–P20.
#![expect(clippy::disallowed_methods, reason = "digits of measured numbers")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use brt::{FileSet, Scene, library};
use brt_lab::paper::{Options, Summary, Watch, run};

/// Everything at a size that takes seconds.
fn tiny(scene: Option<(String, Scene)>) -> Options {
    Options { sizes: vec![16, 32, 48], repeat: 1, quick: true, scene }
}

fn written(options: &Options) -> (tempfile::TempDir, Summary) {
    let folder = tempfile::tempdir().unwrap();
    let watch = Watch { doing: &|_| {}, cancel: None };
    let summary = run(options, folder.path(), &FileSet::new(), watch).unwrap();
    (folder, summary)
}

/// The parts of a text between two marks.
fn between<'a>(text: &'a str, start: &'a str, end: &'a str) -> impl Iterator<Item = &'a str> {
    text.split(start).skip(1).map(move |rest| rest.split(end).next().unwrap_or_default())
}

/// Rows of a file whose first fields hold no commas.
fn rows(folder: &Path, table: &str) -> Vec<Vec<String>> {
    let text = fs::read_to_string(folder.join(format!("{table}.csv"))).unwrap();
    text.lines().skip(1).map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

fn numbers(folder: &Path) -> BTreeMap<String, (String, String)> {
    let rows = rows(folder, "numbers");
    let count = rows.len();
    let numbers: BTreeMap<_, _> =
        rows.into_iter().map(|row| (row[0].clone(), (row[1].clone(), row[2].clone()))).collect();
    assert_eq!(numbers.len(), count, "a number has two values");
    numbers
}

/// Every number on the page is in `numbers.csv` with this very value, which names a table that is there.
fn check_numbers(folder: &Path, page: &str) {
    let numbers = numbers(folder);
    let mut shown = 0;
    for element in between(page, "<data data-number=\"", "</data>") {
        let (name, rest) = element.split_once("\" value=\"").unwrap();
        let (value, text) = rest.split_once("\">").unwrap();
        let known = numbers.get(name).unwrap_or_else(|| panic!("the page names `{name}`, no table does"));
        assert_eq!(known.0, value, "{name}");
        let decimals = text.split_once('.').map_or(0, |(_, digits)| digits.len());
        let rounded = 0.5 * 10_f64.powi(-(decimals as i32)) + 1e-5 * value.parse::<f64>().unwrap().abs();
        let difference = value.parse::<f64>().unwrap() - text.parse::<f64>().unwrap();
        assert!(difference.abs() <= rounded, "{name} is {value}, shown as {text}");
        shown += 1;
    }
    assert!(shown > 50, "only {shown} numbers are shown");
    for (name, (_, table)) in &numbers {
        assert!(folder.join(format!("{table}.csv")).exists(), "{name} is said to be in {table}.csv");
    }
}

/// Every figure has its file, every link its target, and nothing comes from outside.
fn check_links(folder: &Path, page: &str) {
    let anchors: BTreeSet<&str> = between(page, " id=\"", "\"").collect();
    for link in between(page, "href=\"", "\"") {
        match link.strip_prefix('#') {
            Some(anchor) => assert!(anchors.contains(anchor), "nothing is at {link}"),
            None => assert!(folder.join(link).exists(), "no file {link}"),
        }
    }
    assert!(!page.contains("<script") && !page.contains("http://") && !page.contains("https://"));
    assert!(between(page, " src=\"", "\"").all(|source| source.starts_with("data:image/png;base64,")));
    assert!(!page.contains("NaN") && page.contains("prefers-color-scheme: dark"));
}

/// A verdict rests on numbers that exist.
fn check_verdicts(folder: &Path, summary: &Summary) {
    let numbers = numbers(folder);
    let rows = rows(folder, "verdicts");
    for (claim, verdict) in &summary.verdicts {
        let own: Vec<_> = rows.iter().filter(|row| row[0] == *claim).collect();
        assert!(own.iter().all(|row| row[1] == *verdict), "{claim}");
        if *verdict == "not measured in this run" {
            continue;
        }
        let known = own.iter().filter(|row| !row[4].is_empty());
        let mut count = 0;
        for row in known {
            assert_eq!(numbers[&row[3]].0, row[4], "{claim}: {}", row[3]);
            count += 1;
        }
        assert!(count > 0, "{claim} {verdict}, but on what ground?");
    }
    let claims: Vec<&str> = summary.verdicts.iter().map(|v| v.0.as_str()).collect();
    assert_eq!(claims, (1..=20).map(|i| format!("P{i}")).collect::<Vec<_>>());
}

#[test]
fn the_page_has_all_figures_and_agrees_with_its_tables() {
    let (folder, summary) = written(&tiny(None));
    let page = fs::read_to_string(&summary.page).unwrap();
    let headings = ["table1", "fig1", "fig2", "fig3", "fig4", "fig5", "fig6", "fig7", "picture1"];
    let places: Vec<usize> =
        headings.iter().map(|id| page.find(&format!("<h2 id=\"{id}\"")).expect(id)).collect();
    assert!(places.is_sorted(), "figures are not in the paper's order");
    for table in headings {
        assert!(!rows(folder.path(), table).is_empty(), "{table}.csv is empty");
    }
    // Figs. 1, 2, 4 under two conditions, Fig. 3 of four scenes, two charts of Fig. 5 for each of three, and more.
    assert!(page.matches("<svg class=\"chart\"").count() > 6 + 4 + 6);
    assert!(page.matches("<img").count() >= 24 + 7);
    check_numbers(folder.path(), &page);
    check_links(folder.path(), &page);
    check_verdicts(folder.path(), &summary);
    check_claims(&page, folder.path());
}

#[test]
fn an_own_scene_takes_the_place_of_the_papers_three() {
    let scene = library::find("balls").unwrap().build(Some(1)).unwrap();
    let (folder, summary) = written(&tiny(Some(("my <balls>".to_owned(), scene))));
    let page = fs::read_to_string(&summary.page).unwrap();
    assert!(page.contains("my _balls_"));
    assert_eq!(summary.verdicts[6], ("P7".to_owned(), "not measured in this run"));
    assert!(rows(folder.path(), "fig1").iter().all(|row| row[0] == "my _balls_"));
    check_links(folder.path(), &page);
}

#[test]
fn nothing_is_written_when_it_is_cancelled() {
    let folder = tempfile::tempdir().unwrap();
    let cancel = true.into();
    let watch = Watch { doing: &|_| {}, cancel: Some(&cancel) };
    let target = folder.path().join("out");
    assert!(run(&tiny(None), &target, &FileSet::new(), watch).is_err());
    assert!(!target.exists());
}

/// Each claim names code and a test that exist, and the figure that its verdict names.
fn check_claims(page: &str, folder: &Path) {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..");
    let text = fs::read_to_string(root.join("docs/paper/claims.md")).unwrap();
    let verdicts = rows(folder, "verdicts");
    let claims: Vec<Vec<&str>> = text
        .lines()
        .filter(|line| line.starts_with("| P"))
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect();
    let names: Vec<&str> = claims.iter().map(|c| c[0]).collect();
    assert_eq!(names, (1..=20).map(|i| format!("P{i}")).collect::<Vec<_>>());
    for claim in &claims {
        let [name, _, code, test, experiment] = claim[..] else { panic!("{claim:?}") };
        let own = verdicts.iter().find(|row| row[0] == name).unwrap();
        for path in [code, test].into_iter().flat_map(quoted) {
            assert!(root.join(path).exists(), "{name}: there is no {path}");
        }
        assert!(quoted(code).next().is_some() && quoted(test).next().is_some(), "{name} names no file");
        let holds_tests =
            |path: &str| fs::read_to_string(root.join(path)).is_ok_and(|t| t.contains("#[test]"));
        assert!(quoted(test).all(holds_tests), "{name}: no test in {test}");
        for path in [code, test].into_iter().flat_map(quoted) {
            let named = claims_in(&root.join(path));
            assert!(named.contains(name), "{path} does not say \"Paper: {name}\" but {named:?}");
        }
        let anchor = quoted(experiment).next().and_then(|e| e.strip_prefix('#')).expect(name);
        assert!(page.contains(&format!("<h2 id=\"{anchor}\"")), "{name}: no figure {anchor}");
        assert_eq!(own[2], anchor, "{name}: claims.md and the verdict name different figures");
    }
}

/// The claims that a file, or the files of a folder, name after "Paper:"; `P3–P6` are four of them.
fn claims_in(path: &Path) -> BTreeSet<String> {
    if path.is_dir() {
        return fs::read_dir(path).unwrap().flat_map(|entry| claims_in(&entry.unwrap().path())).collect();
    }
    let text = fs::read_to_string(path).unwrap();
    let lists = text.split("Paper: ").skip(1).filter_map(|rest| rest.lines().next());
    let words = lists.flat_map(|list| list.split([',', ' ', '.']).filter(|word| word.starts_with('P')));
    let number = |name: &str| name.trim_start_matches('P').parse::<u32>().ok();
    let range = |word: &str| {
        let (first, last) = word.split_once('–').unwrap_or((word, word));
        Some(number(first)?..=number(last)?)
    };
    words.filter_map(range).flatten().map(|number| format!("P{number}")).collect()
}

/// Texts in backquotes.
fn quoted(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}
