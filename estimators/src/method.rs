//! The traits that a method implements.

use crate::backend::{Backend, Inputs};
use crate::claims::Claim;
use crate::error::{EstimatorError, Unsupported};
use crate::model::OwnModel;
use crate::quantity::Quantity;
use interreflect_gpu::Shader;
use interreflect_scene::params::Params;
use interreflect_scene::{Needs, SceneFacts};

/// What a method is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Info {
    /// Name in code, on the command line and in records: the name of its folder.
    pub id: &'static str,
    /// Title for readers.
    pub title: &'static str,
    /// Where it comes from: authors, title, year.
    pub source: &'static str,
}

/// What the paper says, wherever it runs.
pub trait Method: Send + Sync + 'static {
    /// The method's parameters.
    type Params: Params;
    /// What it is called.
    const INFO: Info;
    /// What it can estimate, its main quantity first.
    const QUANTITIES: &'static [Quantity];

    /// What it must be given for one quantity in such a scene, and no more.
    ///
    /// # Errors
    /// [`Unsupported`] if it can't work there, with the reason.
    fn needs(
        params: &Self::Params,
        quantity: Quantity,
        scene: &SceneFacts,
    ) -> Result<Needs, Unsupported>;

    /// What it claims to compute.
    fn model(params: &Self::Params, quantity: Quantity) -> OwnModel;

    /// What holds for its estimates with these parameters: `verify` checks it.
    fn claims(params: &Self::Params, quantity: Quantity) -> Vec<Claim>;
}

/// How a method runs on a backend.
pub trait Estimator<B: Backend>: Method {
    /// What lives across frames: texel lists, maps, pipelines with their bindings.
    type State: Default + Send;

    /// Every shader that it runs on this backend: none on the CPU.
    const SHADERS: &'static [Shader] = &[];

    /// Whether this backend, as it is on this machine, can run it.
    ///
    /// # Errors
    /// [`Unsupported`] with the reason if it can't.
    fn supports(params: &Self::Params, caps: &B::Caps) -> Result<(), Unsupported> {
        let (_, _) = (params, caps);
        Ok(())
    }

    /// Turns captures into what shading needs. Called whenever something changed; all allocation
    /// and binding happens here, of `out` too.
    ///
    /// # Errors
    /// [`EstimatorError`] if a capture is undeclared or the backend refuses.
    fn prepare(
        params: &Self::Params,
        state: &mut Self::State,
        cx: &mut B::Cx<'_>,
        quantity: Quantity,
        inputs: &Inputs<'_, B>,
        out: &B::Out,
    ) -> Result<(), EstimatorError>;

    /// Estimates the quantity at every point. Makes no buffer, binding or vector.
    ///
    /// # Errors
    /// [`EstimatorError`] if the backend refuses.
    fn shade(
        params: &Self::Params,
        state: &mut Self::State,
        cx: &mut B::Cx<'_>,
        quantity: Quantity,
        inputs: &Inputs<'_, B>,
        out: &mut B::Out,
    ) -> Result<(), EstimatorError>;
}
