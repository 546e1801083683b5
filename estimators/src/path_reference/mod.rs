//! Path tracing as an estimator: slow, unbiased, and the measure of all others. Which light paths
//! count is a parameter, so that what another method leaves out can be split into its parts.

mod claims;
mod params;

use crate::{
    Claim, Cpu, CpuOnly, Estimator, EstimatorError, Figure, Frame, Info, Method, OwnModel,
    Prepared, Quantity, Reference, Unsupported,
};
use interreflect_cpu::path_tracer::{PathQuantity, REPLICATES, Stop, mean_of_samples, trace};
use interreflect_scene::{Needs, SceneFacts};

pub use params::PathReference;

impl Method for PathReference {
    const INFO: Info = Info {
        id: "path_reference",
        title: "Path-traced reference",
        summary: "path tracing with selectable light paths (CPU)",
        references: &[
            Reference {
                authors: "J. T. Kajiya",
                title: "The Rendering Equation",
                venue: "SIGGRAPH",
                year: 1986,
                doi: Some("10.1145/15922.15902"),
            },
            Reference {
                authors: "E. Veach, L. J. Guibas",
                title: "Optimally Combining Sampling Techniques for Monte Carlo Rendering",
                venue: "SIGGRAPH",
                year: 1995,
                doi: Some("10.1145/218380.218498"),
            },
        ],
        figure: Some(Figure {
            scene: "cornell-box",
            quantity: Quantity::Irradiance,
            settings: &["path_reference.samples=16"],
        }),
    };

    const QUANTITIES: &'static [Quantity] = &[
        Quantity::Irradiance,
        Quantity::GlossyRadiance,
        Quantity::AmbientOcclusion,
    ];

    fn needs(&self, _quantity: Quantity, _scene: &SceneFacts) -> Result<Needs, Unsupported> {
        Ok(Needs {
            light_transport: true,
            ..Needs::default()
        })
    }

    fn model(&self, _quantity: Quantity) -> OwnModel {
        OwnModel::LightTransport(self.paths())
    }

    fn claims(&self, quantity: Quantity) -> Vec<Claim> {
        claims::claims(self, quantity)
    }
}

impl CpuOnly for PathReference {
    const NO_GPU: &'static str = "path_reference traces rays on the CPU only: WebGPU has no ray \
                                  queries that every driver offers";
}

impl Estimator<Cpu> for PathReference {
    type Prepared = Paths;

    fn prepare(
        &self,
        _frame: &mut Frame<'_, Cpu>,
        _last: Option<Paths>,
    ) -> Result<Paths, EstimatorError> {
        Ok(Paths(self.clone()))
    }
}

/// The paths that are traced while shading: nothing is prepared.
pub struct Paths(PathReference);

impl Prepared<Cpu> for Paths {
    fn shade(&self, frame: &mut Frame<'_, Cpu>) -> Result<(), EstimatorError> {
        let Self(method) = self;
        let scene = frame.light_transport()?;
        let seed = u64::from(method.seed);
        let paths = method.paths();
        let quantity = path_quantity(frame.quantity);
        let (points, samples) = (frame.points, method.samples);
        let estimate = frame.cx.install(|| match samples < REPLICATES {
            true => mean_of_samples(scene, points, quantity, &paths, samples, seed),
            false => {
                let stop = Stop {
                    samples: Some(samples),
                    ..Stop::default()
                };
                trace(scene, points, quantity, &paths, &stop, seed, &|_| {}).mean
            }
        });
        frame.out.clone_from(&estimate);
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
