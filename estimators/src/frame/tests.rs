//! A method that declares what it never reads is told so, for every kind of capture.

use super::*;
use interreflect_scene::{PointLayout, RsmChannels, RsmViews};

/// What is left of these needs after two phases have read those.
fn unread(needs: &Needs, read: [Needs; 2]) -> Needs {
    let request = Request {
        quantity: Quantity::Irradiance,
        needs: needs.clone(),
        scene: SceneFacts::default(),
        reference_point: Vec3::ZERO,
        read: RefCell::default(),
    };
    let (captures, points) = (
        Captures::<Cpu>::default(),
        Points::new(PointLayout::Surface, []),
    );
    for read in read {
        let inputs = Inputs::new(&request, &captures, (&points, &points), Changed::ALL);
        // Nothing was captured: what is asked for counts.
        for spec in &read.cubes {
            inputs.cube(spec).err();
        }
        for spec in &read.rsms {
            inputs.rsm(spec).err();
        }
        for spec in &read.directional_depths {
            inputs.depths(spec).err();
        }
        if read.environment {
            inputs.environment().err();
        }
        if read.light_transport {
            inputs.light_transport().err();
        }
    }
    request.unread()
}

/// One of each kind.
fn each() -> [(&'static str, Needs); 5] {
    let depth = DirectionalDepthSpec {
        size: 8,
        slope_scaled: true,
    };
    let view = RsmSpec {
        size: 8,
        views: RsmViews::Picture,
        channels: RsmChannels::default(),
    };
    let nothing = Needs::default;
    [
        (
            "cubes",
            Needs {
                cubes: [CubeSpec::of_radiance(8)].into(),
                ..nothing()
            },
        ),
        (
            "RSMs",
            Needs {
                rsms: [view].into(),
                ..nothing()
            },
        ),
        (
            "depths",
            Needs {
                directional_depths: [depth].into(),
                ..nothing()
            },
        ),
        (
            "environment",
            Needs {
                environment: true,
                ..nothing()
            },
        ),
        (
            "light transport",
            Needs {
                light_transport: true,
                ..nothing()
            },
        ),
    ]
}

#[test]
fn what_is_declared_and_not_read_is_told_and_nothing_else() {
    let nothing = Needs::default();
    for (kind, needs) in each() {
        let read = |first: &Needs, again: &Needs| unread(&needs, [first.clone(), again.clone()]);
        assert_eq!(read(&nothing, &nothing), needs, "{kind}: never read");
        assert_eq!(read(&needs, &needs), nothing, "{kind}: read");
        // Later frames need not read again what does not change.
        assert_eq!(read(&needs, &nothing), nothing, "{kind}: read once");
        let undeclared = unread(&nothing, [needs.clone(), needs.clone()]);
        assert_eq!(undeclared, nothing, "{kind}: read without a word");
    }
}

/// Of two cubes one is read.
#[test]
fn specs_are_told_one_by_one() {
    let [one, two] = [8, 16].map(CubeSpec::of_radiance);
    let of = |cubes: &[CubeSpec]| Needs {
        cubes: cubes.iter().copied().collect(),
        ..Needs::default()
    };
    let left = unread(&of(&[one, two]), [of(&[two]), Needs::default()]);
    assert_eq!(left, of(&[one]));
    let later = unread(&of(&[one, two]), [of(&[two]), of(&[one])]);
    assert_eq!(later, Needs::default());
}
