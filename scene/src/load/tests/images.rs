use super::{Folder, shared};
use crate::LatLongImage;
use crate::load::open_image;
use glam::Vec3;
use std::path::Path;

fn one_bright_texel(column: u32, row: u32, radiance: Vec3) -> LatLongImage {
    let mut texels = vec![Vec3::ZERO; 32];
    texels[(row * 8 + column) as usize] = radiance;
    LatLongImage {
        width: 8,
        height: 4,
        texels,
    }
}

#[test]
fn images_keep_their_orientation_in_both_formats() {
    let folder = Folder::new(&[]);
    // φ = 2.5·45°, θ = 67.5°.
    let expected = one_bright_texel(2, 1, Vec3::new(4.0, 2.0, 1.0));
    let flat = |p: &Vec3| p.to_array();
    let hdr = folder.path("e.hdr");
    let pixels: Vec<_> = expected
        .texels
        .iter()
        .map(|t| image::Rgb(flat(t)))
        .collect();
    let file = std::fs::File::create(&hdr).unwrap();
    image::codecs::hdr::HdrEncoder::new(file)
        .encode(&pixels, 8, 4)
        .unwrap();
    let exr = folder.path("e.exr");
    let at = |x: usize, y: usize| expected.texels[y * 8 + x].into();
    exr::prelude::write_rgb_file(&exr, 8, 4, at).unwrap();
    for path in [hdr, exr] {
        let image = open_image(&path).unwrap();
        assert_eq!(image, expected, "{}", path.display());
        let (theta, phi) = (67.5f32.to_radians(), 112.5f32.to_radians());
        let d = Vec3::new(
            theta.sin() * phi.sin(),
            theta.cos(),
            -theta.sin() * phi.cos(),
        );
        // 1e-3: bilinear weights from f32 angles.
        assert!(image.sample(d).distance(Vec3::new(4.0, 2.0, 1.0)) < 1e-3);
        assert!(d.x > 0.0 && d.y > 0.0 && d.z > 0.0);
    }
}

#[test]
fn images_that_hold_no_light_are_refused() {
    let folder = Folder::new(&[
        ("b.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n"),
        ("b.exr", "no"),
    ]);
    let write = |name: &str, value: f32| {
        let path = folder.path(name);
        exr::prelude::write_rgb_file(&path, 8, 4, |x, y| {
            if (x, y) == (3, 1) {
                (value, 1.0, 1.0)
            } else {
                (1.0, 1.0, 1.0)
            }
        })
        .unwrap();
        path
    };
    let refused = |path: &Path| open_image(path).expect_err("refused").to_string();
    assert!(
        refused(&write("nan.exr", f32::NAN))
            .contains("nan.exr: pixel (column 3, row 1) is [NaN, 1.0, 1.0]; replace")
    );
    assert!(
        refused(&write("bright.exr", 2e30))
            .contains("bright.exr: pixel (column 3, row 1) is [2e30, 1.0, 1.0]; replace")
    );
    assert_eq!(
        open_image(&write("negative.exr", -1.0)).unwrap().texels[11],
        Vec3::new(0.0, 1.0, 1.0)
    );
    for name in ["b.hdr", "b.exr"] {
        let message = refused(&folder.path(name));
        assert!(
            message.contains(name) && message.contains("; "),
            "{message}"
        );
    }
}

#[test]
fn the_brightest_rgbe_pixel_is_named() {
    let folder = Folder::new(&[]);
    let path = folder.path("b.hdr");
    let mut bytes = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n".to_vec();
    bytes.extend([128, 128, 128, 129, 255, 1, 1, 255]);
    std::fs::write(&path, bytes).unwrap();
    let message = open_image(&path).expect_err("refused").to_string();
    assert!(
        message.contains("b.hdr: pixel (column 1, row 0) is [1.6"),
        "{message}"
    );
}

#[test]
fn shared_environment_maps_load() {
    for name in [
        "blender_courtyard",
        "blender_interior",
        "pmndrs_hall",
        "pmndrs_lobby",
    ] {
        let Some(path) = shared(&format!("assets/envmaps/{name}.hdr")) else {
            continue;
        };
        let image = open_image(&path).unwrap();
        assert_eq!(image.width, 2 * image.height);
        assert!(image.texels.iter().any(|t| t.max_element() > 1.0));
    }
}

#[test]
fn dwa_compression_is_read() {
    use exr::prelude::{Compression, Encoding, Image, SpecificChannels, WritableImage};
    let folder = Folder::new(&[]);
    for compression in [Compression::DWAA(Some(45.0)), Compression::DWAB(Some(45.0))] {
        let path = folder.path("dwa.exr");
        let channels = SpecificChannels::rgb(|_| (4.0f32, 2.0f32, 1.0f32));
        let encoding = Encoding {
            compression,
            ..Encoding::SMALL_LOSSLESS
        };
        let image = Image::from_encoded_channels((64, 32), encoding, channels);
        image.write().to_file(&path).unwrap();
        let read = open_image(&path).unwrap();
        assert_eq!((read.width, read.height), (64, 32));
        // 5 %: the compression is lossy.
        let error = |t: &Vec3| (*t / Vec3::new(4.0, 2.0, 1.0) - 1.0).abs().max_element();
        assert!(read.texels.iter().all(|t| error(t) < 0.05));
    }
}
