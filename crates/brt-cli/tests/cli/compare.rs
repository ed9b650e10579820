//! `brt compare`.

use crate::bench::{Bench, keys, size_of};

/// A bench with grey pictures of these levels.
fn greys(levels: &[u8]) -> Bench {
    let bench = Bench::new();
    for level in levels {
        bench.write(
            &format!("{level}.ppm"),
            &format!("P6 2 1 255\n{}", char::from(*level).to_string().repeat(6)),
        );
    }
    bench
}

#[test]
fn json_has_the_promised_keys_in_levels() {
    let bench = greys(&[50, 53]);
    let json = bench.done("compare 50.ppm 53.ppm --json").json();
    assert_eq!(keys(&json), ["max_error", "mean_error", "over_1", "over_10", "over_2", "pixels"]);
    assert_eq!(
        (&json["pixels"], &json["max_error"], &json["mean_error"]),
        (&2.into(), &3.0.into(), &3.0.into())
    );
    assert_eq!((&json["over_1"], &json["over_2"], &json["over_10"]), (&2.into(), &2.into(), &0.into()));
}

#[test]
fn errors_over_the_limit_end_with_3() {
    let bench = greys(&[50, 53]);
    bench.done("compare 50.ppm 53.ppm --max-error 3");
    assert_eq!(bench.run("compare 50.ppm 53.ppm --max-error 2.9").code, Some(3));
    assert_eq!(bench.run("compare 50.ppm 53.ppm --max-error 0 --json").code, Some(3));
    bench.done("compare 50.ppm 50.ppm --max-error 0");
}

#[test]
fn one_level_may_be_rounding_alone() {
    let bench = greys(&[50, 51, 52]);
    assert!(bench.done("compare 50.ppm 51.ppm").text().contains("rounding to 8 bits"));
    assert!(!bench.done("compare 50.ppm 52.ppm").text().contains("rounding"));
    assert!(!bench.done("compare 50.ppm 50.ppm").text().contains("rounding"));
}

#[test]
fn heat_maps_have_the_pictures_size() {
    let bench = greys(&[50, 53]);
    bench.done("compare 50.ppm 53.ppm --heat-map h.png");
    assert_eq!(size_of(&bench.path("h.png")), [2, 1]);
}

#[test]
fn pictures_of_other_sizes_and_too_large_ones_are_refused() {
    let bench = greys(&[50]);
    bench.write("large.ppm", &format!("P6 2 2 255\n{}", "a".repeat(12)));
    let ended = bench.run("compare 50.ppm large.ppm");
    assert_eq!(ended.code, Some(1));
    assert!(ended.errors.contains("2×1") && ended.errors.contains("2×2"), "{}", ended.errors);
    assert_eq!(bench.run("compare large.ppm large.ppm --max-pixels 3").code, Some(1));
}

#[test]
fn a_picture_may_come_from_standard_input() {
    let bench = greys(&[50, 53]);
    let picture = format!("P6 2 1 255\n{}", "2".repeat(6));
    let ended = bench.run_with_input("compare 50.ppm - --max-error 0", &picture);
    assert_eq!(ended.code, Some(0), "{}", ended.errors);
    assert_eq!(bench.run_with_input("compare 53.ppm - --max-error 1", &picture).code, Some(3));
    assert_eq!(bench.run_with_input("compare - -", &picture).code, Some(2));
    assert_eq!(bench.run_with_input("compare - 50.ppm", "P6 no").code, Some(1));
}
