//! Path tracing as an estimator: slow, unbiased, and the measure of all others. Which light paths
//! count is a parameter, so that what another method leaves out can be split into its parts.

mod claims;
mod params;

use crate::{
    Claim, Cpu, CpuOnly, Estimator, EstimatorError, Info, Inputs, Method, OwnModel, Quantity,
    Unsupported,
};
use interreflect_cpu::path_tracer::{PathQuantity, REPLICATES, Stop, mean_of_samples, trace};
use interreflect_cpu::tiles::CpuCx;
use interreflect_scene::{Estimate, Needs, SceneFacts};

pub use params::PathReferenceParams;

/// The method.
pub struct PathReference;

impl Method for PathReference {
    type Params = PathReferenceParams;

    const INFO: Info = Info {
        id: "path_reference",
        title: "Path-traced reference",
        source: "J. Kajiya: The Rendering Equation; E. Veach, L. Guibas: Optimally Combining \
                 Sampling Techniques for Monte Carlo Rendering",
    };

    const QUANTITIES: &'static [Quantity] = &[
        Quantity::Irradiance,
        Quantity::GlossyRadiance,
        Quantity::AmbientOcclusion,
    ];

    fn needs(
        _params: &Self::Params,
        _quantity: Quantity,
        _scene: &SceneFacts,
    ) -> Result<Needs, Unsupported> {
        Ok(Needs {
            light_transport: true,
            ..Needs::default()
        })
    }

    fn model(params: &Self::Params, _quantity: Quantity) -> OwnModel {
        OwnModel::LightTransport(params.paths())
    }

    fn claims(params: &Self::Params, quantity: Quantity) -> Vec<Claim> {
        claims::claims(params, quantity)
    }
}

impl CpuOnly for PathReference {
    const NO_GPU: &'static str = "path_reference traces rays on the CPU only: WebGPU has no ray \
                                  queries that every driver offers";
}

impl Estimator<Cpu> for PathReference {
    type State = ();

    fn prepare(
        _params: &PathReferenceParams,
        _state: &mut (),
        _cx: &mut &CpuCx,
        _quantity: Quantity,
        _inputs: &Inputs<'_, Cpu>,
        _out: &Estimate,
    ) -> Result<(), EstimatorError> {
        Ok(())
    }

    fn shade(
        params: &PathReferenceParams,
        _state: &mut (),
        cx: &mut &CpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        out: &mut Estimate,
    ) -> Result<(), EstimatorError> {
        let scene = inputs.light_transport()?;
        let seed = u64::from(params.seed);
        let paths = params.paths();
        let quantity = path_quantity(quantity);
        let (points, samples) = (inputs.points, params.samples);
        let estimate = cx.install(|| match samples < REPLICATES {
            true => mean_of_samples(scene, points, quantity, &paths, samples, seed),
            false => {
                let stop = Stop {
                    samples: Some(samples),
                    ..Stop::default()
                };
                trace(scene, points, quantity, &paths, &stop, seed, &|_| {}).mean
            }
        });
        out.clone_from(&estimate);
        Ok(())
    }
}

/// The path tracer's word for a quantity.
pub fn path_quantity(quantity: Quantity) -> PathQuantity {
    match quantity {
        Quantity::Irradiance => PathQuantity::Irradiance,
        Quantity::GlossyRadiance => PathQuantity::GlossyRadiance,
        Quantity::AmbientOcclusion => PathQuantity::AmbientOcclusion,
    }
}
