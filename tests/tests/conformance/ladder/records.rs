//! What `prepare` makes on the CPU and on the device of the same captures, record by record.

use super::{CAPTURED, OF_A_TERM, sum_of, texels};
use crate::ensure;
use crate::subjects::{SUBJECTS, Subject};
use crate::world::{CPU, Outcome, cpu_stage, gpu_stage, on_gpu};
use interreflect_conformance::exchange::uploaded;
use interreflect_conformance::tolerance::Tolerance;
use interreflect_estimators::classic_envmap::ClassicEnvmap;
use interreflect_estimators::constant_ambient::ConstantAmbient;
use interreflect_estimators::direct_radiance_map::DirectRadianceMap;
use interreflect_estimators::directional_ao::DirectionalAo;
use interreflect_estimators::localized_cubemap::LocalizedCubemap;
use interreflect_estimators::phong_envmap::PhongEnvmap;
use interreflect_estimators::point_form_factor::PointFormFactor;
use interreflect_estimators::polygon_form_factor::PolygonFormFactor;
use interreflect_estimators::sh_mip_envmap::ShMipEnvmap;
use interreflect_estimators::stage::Stage;
use interreflect_estimators::{
    Captures, Changed, Cpu, Estimator, Gpu, Inputs, Method, Prepared, Quantity, Records, Registry,
};
use interreflect_gpu::GpuContext;
use interreflect_scene::{Estimate, Needs, Points, params};
use libtest_mimic::{Failed, Trial};
use std::sync::Arc;

type Settings = &'static [(&'static str, &'static str)];

/// Each method in each fidelity, and in the switches that prepare otherwise. The visibility of
/// `directional_ao` has its own look, in `visibility`.
pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for fidelity in ["published", "corrected"] {
        let all: [Vec<Trial>; 4] = [
            trials_of::<LocalizedCubemap>(fidelity, &[&[], &[("solid_angle", "shader")]]),
            trials_of::<PolygonFormFactor>(
                fidelity,
                &[
                    &[],
                    &[("radiance", "corners")],
                    &[("corners", "nearest")],
                    &[("corners", "per_face")],
                    &[("corners", "seamless")],
                    &[("corners", "exact")],
                ],
            ),
            trials_of::<ShMipEnvmap>(fidelity, &[&[], &[("window", "hanning")]]),
            trials_of::<DirectRadianceMap>(
                fidelity,
                &[
                    &[],
                    &[("surface", "blinn_phong")],
                    &[("mip", "true")],
                    &[("texel", "texture")],
                    &[("solid_angle", "eq11")],
                    &[("solid_angle", "eq15")],
                ],
            ),
        ];
        trials.extend(all.into_iter().flatten());
    }
    trials.extend(trials_of::<PointFormFactor>("", &[&[]]));
    trials.extend(trials_of::<ClassicEnvmap>("", &[&[]]));
    trials.extend(trials_of::<PhongEnvmap>("", &[&[]]));
    trials.extend(trials_of::<ConstantAmbient>("", &[&[]]));
    let looked_at: Vec<String> = trials.iter().map(|t| t.name().to_owned()).collect();
    trials.push(Trial::test("ladder/records/complete", move || {
        complete(&looked_at)
    }));
    trials
}

/// Each method that runs on both backends is looked at here, or where its own look is.
fn complete(looked_at: &[String]) -> Outcome {
    for entry in Registry::builtin().entries() {
        let id = entry.info().id;
        let on_both = entry.gpu().is_ok() && id != DirectionalAo::INFO.id;
        let here = looked_at
            .iter()
            .any(|name| name.starts_with(&format!("ladder/records/{id}")));
        ensure!(
            here == on_both,
            "{id}: the records of a method on both backends are to be compared"
        );
    }
    Ok(())
}

fn trials_of<M>(fidelity: &'static str, switches: &[Settings]) -> Vec<Trial>
where
    M: Estimator<Cpu> + Estimator<Gpu>,
    <M as Estimator<Cpu>>::State: Prepared<Cpu>,
    <M as Estimator<Gpu>>::State: Prepared<Gpu>,
{
    let trial = |&settings: &Settings| {
        let said: String = settings.iter().map(|(n, v)| format!("/{n}={v}")).collect();
        let dot = if fidelity.is_empty() { "" } else { "." };
        let name = format!("ladder/records/{}{dot}{fidelity}{said}", M::INFO.id);
        on_gpu(name, move |context| {
            compare::<M>(context, fidelity, settings)
        })
    };
    switches.iter().map(trial).collect()
}

fn compare<M>(context: &Arc<GpuContext>, fidelity: &str, settings: Settings) -> Outcome
where
    M: Estimator<Cpu> + Estimator<Gpu>,
    <M as Estimator<Cpu>>::State: Prepared<Cpu>,
    <M as Estimator<Gpu>>::State: Prepared<Gpu>,
{
    let mut chosen = M::Params::default();
    // Not every method has these.
    params::set(&mut chosen, "capture_resolution", &CAPTURED.to_string()).ok();
    params::set(&mut chosen, "fidelity", fidelity).ok();
    for (name, value) in settings {
        params::set(&mut chosen, name, value)?;
    }
    let quantity = match M::QUANTITIES.contains(&Quantity::GlossyRadiance) {
        true => Quantity::GlossyRadiance,
        false => M::QUANTITIES[0],
    };
    let needed = |s: &Subject| M::needs(&chosen, quantity, &s.cpu.scene().facts());
    let found = SUBJECTS.iter().find_map(|s| Some((&**s, needed(s).ok()?)));
    let (subject, needs) = found.ok_or("no subject")?;
    let captures = cpu_stage(subject).capture(&needs)?.0;
    let run = Run {
        subject,
        quantity,
        points: subject.points(quantity.layout()),
        needs,
    };
    let host = run.on_host::<M>(&chosen, &captures)?;
    let device = run.on_device::<M>(&chosen, context, &captures)?;
    let first = host.first().ok_or("nothing was prepared")?;
    ensure!(!first.values.is_empty(), "no {}", first.name);
    ensure!(host.len() == device.len(), "other lists on the device");
    for (host, device) in host.iter().zip(&device) {
        let largest = same(host, device, texels(&captures))?;
        println!(
            "{} {}: {largest:.1e} of the largest number",
            M::INFO.id,
            host.name
        );
    }
    Ok(())
}

struct Run {
    subject: &'static Subject,
    quantity: Quantity,
    points: Points,
    needs: Needs,
}

impl Run {
    fn on_host<M>(
        &self,
        params: &M::Params,
        captures: &Captures<Cpu>,
    ) -> Result<Vec<Records>, Failed>
    where
        M: Estimator<Cpu>,
        M::State: Prepared<Cpu>,
    {
        let scene = self.subject.cpu.scene();
        let origin = (
            scene.facts(),
            scene.capture_origin(self.needs.keep_within_m),
        );
        let points = &self.points;
        let inputs = Inputs::new(&self.needs, captures, points, points, origin, Changed::ALL);
        let mut state = M::State::default();
        let out = Estimate::new(points.len());
        M::prepare(params, &mut state, &mut &*CPU, self.quantity, &inputs, &out)?;
        Ok(state.records(&())?)
    }

    fn on_device<M>(
        &self,
        params: &M::Params,
        context: &Arc<GpuContext>,
        captures: &Captures<Cpu>,
    ) -> Result<Vec<Records>, Failed>
    where
        M: Estimator<Gpu>,
        M::State: Prepared<Gpu>,
    {
        let scene = self.subject.cpu.scene();
        let origin = (
            scene.facts(),
            scene.capture_origin(self.needs.keep_within_m),
        );
        let (stage, given) = (
            gpu_stage(context, self.subject)?,
            uploaded(context, captures)?,
        );
        let placed = stage.place(&self.points)?;
        let inputs = Inputs::new(
            &self.needs,
            &given,
            &placed.points,
            &self.points,
            origin,
            Changed::ALL,
        );
        let mut state = M::State::default();
        stage.timed("prepare", &mut |cx| {
            M::prepare(params, &mut state, cx, self.quantity, &inputs, &placed.out)
        })?;
        Ok(state.records(context)?)
    }
}

/// Checks each number; the largest difference. Its scale is the largest of its column: the
/// components of a unit vector, and coefficients that cancel, have the error of their terms.
fn same(host: &Records, device: &Records, captured: f64) -> Result<f64, Failed> {
    let (name, width) = (host.name, host.width);
    ensure!(
        name == device.name && width == device.width && host.values.len() == device.values.len(),
        "{name}: {} numbers, on the device {}",
        host.values.len(),
        device.values.len()
    );
    let records = (host.values.len() / width).max(1) as f64;
    // Records of single directions share the captured texels; the others each sum over all.
    let terms = match name {
        "texels" | "corners" | "radiances" | "photons" | "highlights" => captured / records,
        _ => captured,
    };
    let mut worst = 0.0_f64;
    for column in 0..width {
        let of = |list: &Records| -> Vec<f64> {
            let column = list.values.iter().skip(column).step_by(width);
            column.map(|v| f64::from(*v)).collect()
        };
        let (a, b) = (of(host), of(device));
        let scale = a.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let tolerance = Tolerance {
            absolute: sum_of(terms, OF_A_TERM) * scale,
            relative: if name == "highlights" { LOBE } else { 0.0 },
            cause: "float32 sums over the captured texels of a record",
        };
        let checked = tolerance.check_all(a.iter().copied(), b.iter().copied());
        checked.map_err(|e| format!("{name}, column {column}: {e}"))?;
        let apart = a.iter().zip(&b).map(|(a, b)| (a - b).abs());
        worst = worst.max(apart.fold(0.0, f64::max) / scale.max(f64::MIN_POSITIVE));
    }
    Ok(worst)
}

/// Relative error of a lobe's normalisation, which has a power in it.
const LOBE: f64 = 1e-5;
