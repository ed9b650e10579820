//! `brt render` when all goes well.

use brt::image::{PictureLimits, decode_picture};

use crate::bench::{Bench, SCENE, keys, size_of};

const QUICK: &str = "-s 64x48 --samples 1";

#[test]
fn the_picture_is_named_after_the_scene_and_a_pipe_hears_nothing() {
    let bench = Bench::new();
    let ended = bench.done(&format!("render ball.toml {QUICK}"));
    assert_eq!((ended.text(), ended.errors.as_str()), ("", ""));
    assert_eq!(bench.files(), ["ball.png", "ball.toml"]);
    assert_eq!(size_of(&bench.path("ball.png")), [64, 48]);
}

#[test]
fn the_last_line_tells_file_size_samples_time_and_method() {
    let bench = Bench::new();
    let last = |arguments: &str| {
        let ended = bench.done(&format!("render ball.toml a.png -v -s 64x48 {arguments}"));
        ended.errors.trim_end().lines().last().unwrap().to_owned()
    };
    let line = last("--samples 4");
    assert!(line.starts_with("a.png 64×48 ×4 · "), "{line}");
    assert!(line.ends_with(" % traced · every pixel within 1 level"), "{line}");
    assert!(last("--samples 1 --method border").ends_with(" % traced · border Δ 16"));
    assert!(last("--samples 1 --tolerance 0").ends_with(" · every pixel as traced"));
    assert!(last("--samples 1 --method full").ends_with(" · 100 % traced · full"));
    assert!(last("--samples 1 --method pixel-selected --delta 2").ends_with(" · pixel-selected Δ 2"));
    let default = bench.done("render ball.toml -v -s 32x32");
    assert!(default.errors.contains("32×32 ×16 ·"), "{}", default.errors);
}

#[test]
fn quiet_is_quiet_and_excludes_verbose() {
    let bench = Bench::new();
    assert_eq!(bench.done(&format!("render ball.toml -q {QUICK}")).errors, "");
    assert_eq!(bench.run("render ball.toml -q -v").code, Some(2));
}

#[test]
fn size_comes_from_the_command_then_the_file() {
    let bench = Bench::new();
    bench.write("sized.toml", &format!("size = [40, 30]\n{SCENE}"));
    bench.done("render sized.toml --samples 1");
    assert_eq!(size_of(&bench.path("sized.png")), [40, 30]);
    bench.done("render sized.toml --samples 1 --size 20x10");
    assert_eq!(size_of(&bench.path("sized.png")), [20, 10]);
}

#[test]
fn standard_output_gets_a_png_and_nothing_else() {
    let bench = Bench::new();
    let ended = bench.done(&format!("render ball.toml -o - --verify {QUICK}"));
    let picture = decode_picture(&ended.stdout, PictureLimits::default()).unwrap();
    assert_eq!([picture.size().width, picture.size().height], [64, 48]);
    assert!(ended.errors.contains("pixels checked"));
    assert_eq!(bench.files(), ["ball.toml"]);
    bench.done(&format!("render ball.toml ball.png {QUICK}"));
    assert!(bench.read("ball.png") == ended.stdout);
}

#[test]
fn standard_input_is_toml() {
    let bench = Bench::new();
    let ended = bench.run_with_input(&format!("render - {QUICK} -o a.png"), SCENE);
    assert_eq!(ended.code, Some(0), "{}", ended.errors);
    bench.done(&format!("render ball.toml {QUICK}"));
    assert!(bench.read("a.png") == bench.read("ball.png"));
}

#[test]
fn threads_do_not_change_a_byte() {
    let bench = Bench::new();
    bench.done("render ball.toml one.png -s 300x200 --samples 4 -j 1");
    bench.done("render ball.toml many.png -s 300x200 --samples 4 -j 7");
    assert!(bench.read("one.png") == bench.read("many.png"));
}

#[test]
fn layers_stand_beside_the_picture_in_its_size() {
    let bench = Bench::new();
    bench.done(&format!(
        "render ball.toml a.png {QUICK} --layers surface,depth,normal,history,state,error,depth"
    ));
    for layer in ["surface", "depth", "normal", "history", "state", "error"] {
        assert_eq!(size_of(&bench.path(&format!("a.{layer}.png"))), [64, 48], "{layer}");
    }
    assert_eq!(bench.files().len(), 8);
}

#[test]
fn layers_of_an_exr_are_inside_it() {
    let bench = Bench::new();
    bench.done(&format!("render ball.toml a.exr {QUICK} --layers depth,normal,state,error"));
    assert_eq!(bench.files(), ["a.exr", "ball.toml"]);
    assert_eq!(size_of(&bench.path("a.exr")), [64, 48]);
    let bytes = bench.read("a.exr");
    for channel in ["depth.Z", "normal.X", "state.Y", "error.Y"] {
        assert!(bytes.windows(channel.len()).any(|window| window == channel.as_bytes()), "{channel}");
    }
}

#[test]
fn the_state_layer_is_white_where_all_is_traced() {
    let bench = Bench::new();
    bench.done(&format!("render ball.toml a.png {QUICK} --method full --layers state"));
    let state = brt::image::read_picture(&bench.path("a.state.png"), PictureLimits::default()).unwrap();
    assert!((0..64 * 48).all(|i| state.levels(i) == [255.0; 3]));
}

#[test]
fn linear_and_bits_reach_the_file() {
    let bench = Bench::new();
    for (name, options) in
        [("a.png", ""), ("b.png", "--linear"), ("c.png", "--bits 16"), ("d.ppm", "--bits 16")]
    {
        bench.done(&format!("render ball.toml {name} {QUICK} {options}"));
    }
    assert!(bench.read("a.png") != bench.read("b.png"));
    assert_eq!(bench.read("c.png")[24], 16);
    assert!(bench.read("d.ppm").starts_with(b"P6\n64 48\n65535\n"));
}

#[test]
fn stats_have_the_promised_keys() {
    let bench = Bench::new();
    bench.done("render ball.toml -s 64x48 --samples 4 -j 2 --stats s.json --method border");
    let stats: serde_json::Value = serde_json::from_slice(&bench.read("s.json")).unwrap();
    assert_eq!(
        keys(&stats),
        [
            "blocks",
            "certificates",
            "height",
            "method",
            "nodes_visited",
            "pixels",
            "primitive_tests",
            "rays",
            "samples",
            "seconds",
            "threads",
            "width"
        ]
    );
    assert_eq!(
        keys(&stats["seconds"]),
        ["encode", "fill", "load", "perspective", "prepare", "render", "select", "total", "trace"]
    );
    assert_eq!(keys(&stats["pixels"]), ["filled", "shaded", "total", "traced"]);
    assert_eq!(keys(&stats["rays"]), ["camera", "mirror", "refracted", "shadow"]);
    assert_eq!(keys(&stats["blocks"]), ["divided", "filled", "judged"]);
    assert_eq!(
        (&stats["method"], &stats["width"], &stats["height"]),
        (&"border".into(), &64.into(), &48.into())
    );
    assert_eq!((&stats["samples"], &stats["threads"]), (&4.into(), &2.into()));
    let count = |key: &str| stats["pixels"][key].as_u64().unwrap();
    assert_eq!(count("total"), 64 * 48 * 4);
    assert_eq!(count("traced") + count("shaded") + count("filled"), count("total"));
    let seconds = |key: &str| stats["seconds"][key].as_f64().unwrap();
    assert!(seconds("load") + seconds("render") <= seconds("total"));
    assert!(seconds("encode") <= 2.0 * seconds("total"));
}

#[test]
fn no_save_writes_nothing_but_stats() {
    let bench = Bench::new();
    let ended = bench.done(&format!("render ball.toml {QUICK} --no-save --stats -"));
    assert_eq!(ended.json()["method"], "certified");
    let visibility = &ended.json()["certificates"]["color"];
    assert_eq!(keys(visibility), ["failed", "proven", "tried"]);
    assert_eq!(bench.files(), ["ball.toml"]);
    assert_eq!(bench.run("render ball.toml --no-save -o a.png").code, Some(2));
}

#[test]
fn verification_is_a_line_to_cite_and_a_limit_if_one_is_given() {
    let bench = Bench::new();
    let full = bench.done(&format!("render ball.toml {QUICK} --method full --verify"));
    assert_eq!(full.text(), "3,072 pixels checked, greatest error 0.00 levels, 0 above 0\n");
    let border = bench.done(&format!("render ball.toml {QUICK} --method border --delta 128 --verify"));
    assert!(border.text().starts_with("3,072 pixels checked, greatest error "), "{}", border.text());
    let over = bench.run(&format!("render ball.toml {QUICK} --method border --delta 128 --max-error 0"));
    assert_eq!(over.code, Some(3), "{}", over.text());
    assert!(over.errors.contains("above the 0 that --max-error allows"), "{}", over.errors);
    bench.done(&format!("render ball.toml {QUICK} --method border --delta 128 --max-error 255"));
    // Every 16th of 48 rows of 64 pixels.
    let rows = bench.done(&format!("render ball.toml {QUICK} --tolerance 0.25 --verify=rows"));
    assert!(rows.text().starts_with("192 pixels checked, "), "{}", rows.text());
    assert!(rows.text().ends_with(" levels, 0 above 0.25\n"), "{}", rows.text());
    for output in ["--no-save --linear", "-o a.exr", "--no-save"] {
        bench.done(&format!("render ball.toml -s 64x48 --samples 4 --max-error 1 {output}"));
    }
}

#[test]
fn a_quiet_verification_speaks_of_pixels_above_the_limit_only() {
    let bench = Bench::new();
    let good = bench.done(&format!("render ball.toml {QUICK} -q --verify"));
    assert_eq!((good.text(), good.errors.as_str()), ("", ""));
    let border = format!("render ball.toml {QUICK} --method border --delta 128 --verify");
    let (loud, quiet) = (bench.done(&border), bench.done(&format!("{border} -q")));
    assert!(!loud.text().ends_with(", 0 above 1\n"), "{}", loud.text());
    assert_eq!((quiet.text(), quiet.errors.as_str()), (loud.text(), ""));
    // What ends with 3 says why.
    let over = bench.run(&format!("render ball.toml {QUICK} -q --tolerance 8 --max-error 0"));
    assert_eq!(over.code, Some(3));
    assert!(over.text().ends_with(", 0 above 8\n"), "{}", over.text());
}

#[test]
fn a_pixel_tells_what_is_seen_in_it() {
    let bench = Bench::new();
    let ended = bench.done(&format!("render ball.toml {QUICK} --pixel 32,24 --verify"));
    for part in
        ["pixel    32,24 of 64×48 ×1", "sphere \"ball\", material \"clay\"", "depth ", "history ", "error "]
    {
        assert!(ended.text().contains(part), "{part}: {}", ended.text());
    }
    let sky = bench.done(&format!("render ball.toml {QUICK} --pixel 0,0"));
    assert!(sky.text().contains("none: the background"), "{}", sky.text());
    assert_eq!(bench.files(), ["ball.toml"]);
    assert_eq!(bench.run(&format!("render ball.toml {QUICK} --pixel 64,0")).code, Some(2));
}

#[test]
fn every_method_and_paper_option_renders() {
    let bench = Bench::new();
    for options in [
        "--method full --accelerator none",
        "--method pixel-selected --icps --block 8 --delta 4 --history shadower",
        "--method border --judge variance --regions together --history shadower --block 32 --delta 4",
        "--method border --judge difference --filter gaussian --samples 4 --max-depth 0",
        "--tolerance 0.5 --filter gaussian --samples 4 --accelerator extents --layers certificates,state,history",
    ] {
        bench.done(&format!("render ball.toml -s 40x30 {options}"));
    }
}

#[test]
fn every_simd_level_gives_the_same_file() {
    let bench = Bench::new();
    for level in ["widest", "avx2", "baseline"] {
        bench.done(&format!("render ball.toml {level}.png --simd {level} {QUICK}"));
    }
    let bytes = |name: &str| std::fs::read(bench.path(name)).unwrap();
    assert!(bytes("avx2.png") == bytes("widest.png") && bytes("baseline.png") == bytes("widest.png"));
    let ended = bench.done(&format!("render ball.toml -v --simd baseline {QUICK}"));
    assert!(ended.errors.contains("instructions: baseline"), "{}", ended.errors);
    let ended = bench.run("render ball.toml --simd sse9");
    assert_eq!(ended.code, Some(2));
    assert!(ended.errors.contains("widest, avx2, baseline"), "{}", ended.errors);
}
