//! Image files: what is written can be read again, and what fails leaves no trace.

use std::fs;
use std::path::Path;

use brilliance_renderer::error::RendererError;
use brilliance_renderer::image_file::{
    ImageFormat, SCENE_KEYWORD, read_metadata, write_exr, write_png8, write_png16,
};
use brilliance_renderer::spectrum::Bins;
use exr::prelude::{FlatSamples, read_first_flat_layer_from_file};

const SIZE: [u32; 2] = [7, 5];
const PIXELS: usize = 35;
const SCENE: &str = "name = \"Größe — 寶石\"\n[camera]\nfov = 18\n";

fn rgb() -> Vec<[f32; 3]> {
    (0..PIXELS).map(|i| [i as f32, -0.25 * i as f32, 1e4 / (1.0 + i as f32)]).collect()
}

fn names_in(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}

#[test]
fn a_png_of_8_bits_holds_its_pixels_and_its_scene() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("stone.png");
    let rgba8: Vec<u8> = (0..4 * PIXELS).map(|i| (37 * i % 256) as u8).collect();
    write_png8(&path, SIZE, &rgba8, &[(SCENE_KEYWORD, SCENE), ("Software", "test")]).unwrap();

    let image = image::open(&path).unwrap();
    assert_eq!((image.width(), image.height()), (7, 5));
    assert_eq!(image.as_rgba8().unwrap().as_raw(), &rgba8);
    let metadata = read_metadata(&path).unwrap();
    assert_eq!(metadata[SCENE_KEYWORD], SCENE);
    assert_eq!(metadata["Software"], "test");
    assert!(fs::read(&path).unwrap().windows(4).any(|chunk| chunk == b"sRGB"));
}

#[test]
fn a_png_of_16_bits_holds_its_pixels_and_its_scene() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("stone.PNG");
    let rgb16: Vec<u16> = (0..3 * PIXELS).map(|i| (4111 * i % 65536) as u16).collect();
    write_png16(&path, SIZE, &rgb16, &[(SCENE_KEYWORD, SCENE)]).unwrap();

    let image = image::open(&path).unwrap();
    assert_eq!(image.as_rgb16().unwrap().as_raw(), &rgb16);
    assert_eq!(read_metadata(&path).unwrap()[SCENE_KEYWORD], SCENE);
}

#[test]
fn an_exr_holds_its_pixels_and_its_scene() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("stone.exr");
    write_exr(&path, SIZE, &rgb(), None, &[(SCENE_KEYWORD, SCENE)]).unwrap();

    let image = image::open(&path).unwrap();
    assert_eq!(image.as_rgb32f().unwrap().as_raw(), &rgb().concat());
    assert_eq!(read_metadata(&path).unwrap()[SCENE_KEYWORD], SCENE);
}

#[test]
fn a_spectral_exr_has_one_channel_per_bin() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("stone.exr");
    let bins = Bins::new(28);
    let means: Vec<f32> = (0..PIXELS * 28).map(|i| 0.5 * i as f32).collect();
    write_exr(&path, SIZE, &rgb(), Some((bins, &means)), &[(SCENE_KEYWORD, SCENE)]).unwrap();

    let image = image::open(&path).unwrap();
    assert_eq!(image.as_rgb32f().unwrap().as_raw(), &rgb().concat());
    let image = read_first_flat_layer_from_file(&path).unwrap();
    let channels = &image.layer_data.channel_data.list;
    assert_eq!(channels.len(), 3 + 28);
    // Bins of 12.5 nm: the first is centred on 386.25, the fourth on 423.75 nm.
    for (name, bin) in [("S0.386,250nm", 0), ("S0.423,750nm", 3), ("S0.723,750nm", 27)] {
        let channel = channels.iter().find(|channel| channel.name.eq(name)).unwrap();
        let expected = means.iter().skip(bin).step_by(28).copied().collect();
        assert_eq!(channel.sample_data, FlatSamples::F32(expected), "{name}");
    }
    let metadata = read_metadata(&path).unwrap();
    assert_eq!(metadata["spectralLayoutVersion"], "1.0");
    assert_eq!(metadata["emissiveUnits"], "W.m^-2.sr^-1");
    assert_eq!(metadata[SCENE_KEYWORD], SCENE);
}

#[test]
fn a_picture_takes_the_place_of_an_older_one() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("stone.png");
    fs::write(&path, "old").unwrap();
    write_png8(&path, [1, 1], &[1, 2, 3, 255], &[]).unwrap();
    assert_eq!(image::open(&path).unwrap().as_rgba8().unwrap().as_raw(), &[1, 2, 3, 255]);
    assert_eq!(names_in(folder.path()), ["stone.png"]);
}

#[cfg(unix)]
#[test]
fn a_picture_has_the_permissions_of_any_new_file() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    let (picture, other) = (folder.path().join("stone.png"), folder.path().join("other"));
    write_png8(&picture, [1, 1], &[0; 4], &[]).unwrap();
    fs::write(&other, "").unwrap();
    let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode();
    assert_eq!(mode(&picture), mode(&other));
}

/// A keyword that neither format takes fails after the file was begun.
#[test]
fn a_failed_write_leaves_the_old_file_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let png = folder.path().join("stone.png");
    let exr = folder.path().join("stone.exr");
    for path in [&png, &exr] {
        fs::write(path, "old").unwrap();
    }
    let too_long = "k".repeat(300);
    let metadata = [(too_long.as_str(), "text")];
    write_png8(&png, [1, 1], &[0; 4], &metadata).unwrap_err();
    write_png16(&png, [1, 1], &[0; 3], &metadata).unwrap_err();
    write_exr(&exr, [1, 1], &[[0.0; 3]], None, &metadata).unwrap_err();
    write_exr(&exr, [1, 1], &[[0.0; 3]], None, &[("channels", "text")]).unwrap_err();
    for path in [&png, &exr] {
        assert_eq!(fs::read_to_string(path).unwrap(), "old");
    }
    let mut names = names_in(folder.path());
    names.sort();
    assert_eq!(names, ["stone.exr", "stone.png"]);
}

#[test]
fn pixels_that_do_not_fill_the_size_are_refused_in_words() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("stone.png");
    let refused = [
        write_png8(&path, [2, 2], &[0; 15], &[]),
        write_png8(&path, [0, 2], &[], &[]),
        write_png16(&path, [u32::MAX, u32::MAX], &[0; 12], &[]),
        write_exr(&path, [2, 1], &[[0.0; 3]; 3], None, &[]),
        write_exr(&path, [1, 1], &[[0.0; 3]], Some((Bins::new(4), &[0.0; 3])), &[]),
    ];
    for result in refused {
        let error = result.unwrap_err();
        assert!(matches!(error, RendererError::Invalid(_)), "{error}");
        assert!(error.to_string().contains("pixels"), "{error}");
    }
    assert!(names_in(folder.path()).is_empty());
}

#[test]
fn errors_name_the_file_and_the_remedy() {
    let folder = tempfile::tempdir().unwrap();
    let missing = folder.path().join("nowhere").join("stone.png");
    let message = write_png8(&missing, [1, 1], &[0; 4], &[]).unwrap_err().to_string();
    assert!(message.contains("stone.png") && message.contains("create it"), "{message}");

    let message = write_png8(folder.path(), [1, 1], &[0; 4], &[]).unwrap_err().to_string();
    assert!(message.contains("is a folder"), "{message}");

    let message = ImageFormat::of(Path::new("stone.gif")).unwrap_err().to_string();
    assert!(message.contains("stone.gif") && message.contains(".png or .exr"), "{message}");
    assert_eq!(ImageFormat::of(Path::new("a/stone.Exr")).unwrap(), ImageFormat::Exr);

    for name in ["broken.png", "broken.exr"] {
        let broken = folder.path().join(name);
        fs::write(&broken, "no image at all").unwrap();
        let message = read_metadata(&broken).unwrap_err().to_string();
        assert!(message.contains(name) && message.contains("export it again"), "{message}");
    }
    let message = read_metadata(&folder.path().join("none.png")).unwrap_err().to_string();
    assert!(message.contains("none.png"), "{message}");
}
