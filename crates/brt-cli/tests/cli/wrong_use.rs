//! Wrong use ends with exit code 2, before anything is read or written.

use std::fs;

use crate::bench::Bench;

/// Runs each command line and expects wrong use, with these words on standard error.
fn refuses(cases: &[(&str, &str)]) {
    let bench = Bench::new();
    for (arguments, part) in cases {
        let ended = bench.run(arguments);
        assert_eq!(ended.code, Some(2), "brt {arguments}: {}", ended.errors);
        assert!(ended.errors.contains(part), "brt {arguments}: {}", ended.errors);
    }
    assert_eq!(bench.files(), ["ball.toml"]);
}

#[test]
fn options_that_belong_to_another_method() {
    refuses(&[
        ("render ball.toml --method full --judge variance", "`--judge` belongs to `--method border`"),
        ("render ball.toml --delta 3", "not to `certified`; use `--tolerance`"),
        ("render ball.toml --method border --tolerance 3", "`--method certified` and `--method pencil`"),
        ("render ball.toml --method full --delta 3", "`--method border` and `--method pixel-selected`"),
        ("render ball.toml --icps", "`--icps` belongs to `--method pixel-selected`"),
        ("render ball.toml --method border --icps", "not to `border`"),
        (
            "render ball.toml --method pixel-selected --regions together",
            "`--regions` belongs to `--method border`",
        ),
        ("render ball.toml --method full --block 8", "`--block` belongs to"),
        ("render ball.toml --method full --history shadower", "`--history` belongs to"),
    ]);
}

#[test]
fn values_out_of_range() {
    refuses(&[
        ("render ball.toml -s 64", "WIDTHxHEIGHT"),
        ("render ball.toml -s 0x64", "WIDTHxHEIGHT"),
        ("render ball.toml -j 0", "1..=1024"),
        ("render ball.toml -j 100000", "1..=1024"),
        ("render ball.toml --samples 2", "expected 1, 4, 16, 64 or 256\n"),
        ("render ball.toml --bits 9", "possible values: 8, 16"),
        ("render ball.toml --input-format step", "expected one of toml, nff, stl,"),
        ("render ball.toml --delta -1", "at least 0"),
        ("render ball.toml --delta nan", "at least 0"),
        ("render ball.toml --block 129", "1..=128"),
        ("render ball.toml --layers depth,colour", "surface"),
        ("render ball.toml --method certain", "certified"),
        ("render ball.toml --verify=some", "rows, all"),
        ("render ball.toml --pixel 3", "X,Y"),
        ("compare a.png b.png --max-error x", "at least 0"),
    ]);
}

#[test]
fn negative_values_get_the_words_of_their_option() {
    refuses(&[
        ("render ball.toml --pixel -1,2", "expected X,Y"),
        ("render ball.toml -s -40x30", "expected WIDTHxHEIGHT"),
        ("convert ball.toml a.toml -s -40x30", "expected WIDTHxHEIGHT"),
        ("render ball.toml --threads -1", "1..=1024"),
        ("render ball.toml --samples -1", "expected 1, 4, 16, 64 or 256"),
        ("render ball.toml --bits -1", "possible values: 8, 16"),
        ("render ball.toml --block -1", "1..=128"),
        ("render ball.toml --max-depth -1", "0..=1000"),
        ("render ball.toml --max-memory -1", "expected a size"),
        ("render ball.toml --max-pixels -1", "expected a whole number, at least 0"),
        ("compare a.png b.png --max-pixels -1", "expected a whole number, at least 0"),
        ("scene watch --size -1", "-1 is not in"),
        ("paper --sizes -1", "16..=16384"),
        ("paper --repeat -1", "1..=100"),
        ("peers --sizes -1,32", "32..=32768"),
        ("peers --repeat -1", "1..=100"),
        ("peers --timeout -1", "1..=86400"),
    ]);
}

#[test]
fn outputs_that_make_no_sense() {
    refuses(&[
        ("render ball.toml -o a.ppm --compression small", "`--compression` belongs to .png"),
        ("render ball.toml --compression best", "fast, balanced, small"),
        ("render ball.toml -o a.jpg", "a.jpg: not the name of a picture that can be written"),
        ("render ball.toml -o a", "expected `.png`, `.ppm` or `.exr`"),
        ("render ball.toml a.png -o b.png", "cannot be used with"),
        ("render ball.toml -o - --layers depth", "`--layers`"),
        ("render ball.toml -o - --stats -", "cannot both go to standard output"),
        ("render ball.toml -o a.exr --bits 16", "`--bits` belongs to .png and .ppm"),
        ("render ball.toml -o a.png --stats a.png", "written twice"),
        ("render ball.toml -o a.png --stats ball.toml", "overwrite the scene"),
        ("convert ball.toml ball.toml", "overwrite the scene"),
        ("convert ball.toml ball.nff", "`.toml`"),
        ("scene balls -o balls.png", "`.toml`"),
        ("scene teapot", "no scene is named `teapot`"),
        ("scene balls --size 30", "expected a number from 1 to 6"),
        ("scene seed-a --size 3", "no size to choose"),
        ("compare a.png b.png --heat-map h.gif", "h.gif"),
        ("compare a.png b.png --heat-map a.png", "a.png would overwrite a picture that is compared"),
        ("convert ball.toml a.toml -o b.toml", "cannot be used with"),
        ("convert ball.toml", "required"),
        ("render ball.toml -s 1x2 --sheet", "a sheet needs at least 2×2 pixels"),
    ]);
}

#[test]
fn the_scene_is_not_overwritten_by_another_name_either() {
    let bench = Bench::new();
    fs::rename(bench.path("ball.toml"), bench.path("ball.png")).unwrap();
    let before = bench.read("ball.png");
    let ended = bench.run("render ball.png -o ./ball.png");
    assert_eq!(ended.code, Some(2), "{}", ended.errors);
    assert!(bench.read("ball.png") == before);
}

#[test]
fn habits_of_others_get_a_hint() {
    refuses(&[
        ("render ball.toml +W800 +H600", "hint: the size is `--size WIDTHxHEIGHT` here"),
        ("render ball.toml -res 800 600", "hint: the size is `--size WIDTHxHEIGHT` here"),
        ("render ball.toml -aasamples 12", "hint: samples per pixel are `--samples 1|4|16|64` here"),
        ("render ball.toml +A0.3", "hint: `--samples 1|4|16|64` smooths edges here"),
        ("render ball.toml --verify rows", "hint: did you mean `--verify=rows`?"),
        ("part.stl", "hint: did you mean `brt render part.stl`?"),
        ("ball.toml -o a.png", "hint: did you mean `brt render ball.toml`?"),
        ("", "Usage: brt <COMMAND>"),
    ]);
}
