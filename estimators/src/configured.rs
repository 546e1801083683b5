//! A method whose types are erased: one virtual call per prepare or shade.

use crate::backend::{Backend, Cpu, Gpu};
use crate::claims::Claim;
use crate::error::{EstimatorError, Unsupported};
use crate::frame::Frame;
use crate::leaves::Leaves;
use crate::method::{Estimator, Info, Method, Prepared};
use crate::model::OwnModel;
use crate::quantity::Quantity;
use interreflect_gpu::{GpuContext, Shader};
use interreflect_scene::params::{self, Choice, FIDELITY, Fidelity, FieldInfo, ParamError, Value};
use interreflect_scene::{Needs, SceneFacts};

/// A method with its parameters, its types erased.
pub trait Configured: Send + Sync {
    /// What the method is called.
    fn info(&self) -> &'static Info;
    /// What it can estimate.
    fn quantities(&self) -> &'static [Quantity];
    /// Every parameter with its value.
    fn values(&self) -> Vec<(FieldInfo, Value)>;
    /// Sets a parameter by name.
    ///
    /// # Errors
    /// [`ParamError`] if there is no such parameter or the text is not a value of it.
    fn set(&mut self, name: &str, text: &str) -> Result<(), ParamError>;
    /// See [`Method::needs`].
    ///
    /// # Errors
    /// [`Unsupported`] if the method can't work there.
    fn needs(&self, quantity: Quantity, scene: &SceneFacts) -> Result<Needs, Unsupported>;
    /// See [`Method::model`].
    fn model(&self, quantity: Quantity) -> OwnModel;
    /// See [`Method::claims`].
    fn claims(&self, quantity: Quantity) -> Vec<Claim>;
    /// Starts a session on the CPU.
    ///
    /// # Errors
    /// [`Unsupported`] if there is no CPU implementation, with the reason.
    fn on_cpu(&self) -> Result<Box<dyn Session<Cpu>>, Unsupported>;
    /// Starts a session on the GPU.
    ///
    /// # Errors
    /// [`Unsupported`] if there is no GPU implementation, or not on this one, with the reason.
    fn on_gpu(&self, context: &GpuContext) -> Result<Box<dyn Session<Gpu>>, Unsupported>;
    /// See [`Method::LEAVES`].
    fn leaves(&self) -> &'static Leaves;
    /// See [`Estimator::SHADERS`], on the GPU.
    fn shaders(&self) -> &'static [Shader];
    /// A copy.
    fn boxed_clone(&self) -> Box<dyn Configured>;

    /// The method once in each of its fidelities, or as it is if it has none.
    fn in_each_fidelity(&self) -> Vec<Box<dyn Configured>> {
        if self.fidelity().is_none() {
            return vec![self.boxed_clone()];
        }
        let variants = Fidelity::all().into_iter().filter_map(|(name, _)| {
            let mut variant = self.boxed_clone();
            variant.set(FIDELITY, name).ok().map(|()| variant)
        });
        variants.collect()
    }

    /// The value of the parameter [`FIDELITY`], for methods that have it.
    fn fidelity(&self) -> Option<&'static str> {
        self.values().into_iter().find_map(|(f, v)| match v {
            Value::Name(name) if f.name == FIDELITY => Some(name),
            _ => None,
        })
    }
}

/// A method that runs on one backend, with what it keeps from frame to frame.
pub trait Session<B: Backend>: Send {
    /// See [`Estimator::prepare`]. After an error nothing is left of earlier frames.
    ///
    /// # Errors
    /// [`EstimatorError`] as there.
    fn prepare(&mut self, frame: &mut Frame<'_, B>) -> Result<(), EstimatorError>;

    /// What the last `prepare` made; `None` before the first, and after an error.
    fn prepared(&self) -> Option<&dyn Prepared<B>>;
}

pub(crate) struct Running<M: Estimator<B>, B: Backend> {
    method: M,
    prepared: Option<M::Prepared>,
}

impl<M: Estimator<B>, B: Backend> Running<M, B> {
    pub(crate) fn open(method: M, caps: &B::Caps) -> Result<Box<dyn Session<B>>, Unsupported> {
        method.supports(caps)?;
        Ok(Box::new(Self {
            method,
            prepared: None,
        }))
    }
}

impl<M: Estimator<B>, B: Backend> Session<B> for Running<M, B> {
    fn prepare(&mut self, frame: &mut Frame<'_, B>) -> Result<(), EstimatorError> {
        let last = self.prepared.take();
        self.prepared = Some(self.method.prepare(frame, last)?);
        Ok(())
    }

    fn prepared(&self) -> Option<&dyn Prepared<B>> {
        let prepared = self.prepared.as_ref();
        prepared.map(|prepared| prepared as &dyn Prepared<B>)
    }
}

pub(crate) type Open<M, B> =
    fn(M, &<B as Backend>::Caps) -> Result<Box<dyn Session<B>>, Unsupported>;

pub(crate) struct Typed<M> {
    pub(crate) method: M,
    pub(crate) cpu: Result<Open<M, Cpu>, &'static str>,
    pub(crate) gpu: Result<Open<M, Gpu>, &'static str>,
    pub(crate) shaders: &'static [Shader],
}

impl<M: Method> Configured for Typed<M> {
    fn info(&self) -> &'static Info {
        &M::INFO
    }
    fn quantities(&self) -> &'static [Quantity] {
        M::QUANTITIES
    }
    fn values(&self) -> Vec<(FieldInfo, Value)> {
        params::values(&self.method)
    }
    fn set(&mut self, name: &str, text: &str) -> Result<(), ParamError> {
        params::set(&mut self.method, name, text)
    }
    fn needs(&self, quantity: Quantity, scene: &SceneFacts) -> Result<Needs, Unsupported> {
        if !M::QUANTITIES.contains(&quantity) {
            let offered: Vec<_> = M::QUANTITIES.iter().map(|q| q.name()).collect();
            return Err(Unsupported(format!(
                "{} does not estimate {}; it offers {}",
                M::INFO.id,
                quantity.name(),
                offered.join(", ")
            )));
        }
        self.method.needs(quantity, scene)
    }
    fn model(&self, quantity: Quantity) -> OwnModel {
        self.method.model(quantity)
    }
    fn claims(&self, quantity: Quantity) -> Vec<Claim> {
        self.method.claims(quantity)
    }
    fn on_cpu(&self) -> Result<Box<dyn Session<Cpu>>, Unsupported> {
        let open = self.cpu.map_err(|why| Unsupported(why.into()))?;
        open(self.method.clone(), &())
    }
    fn on_gpu(&self, context: &GpuContext) -> Result<Box<dyn Session<Gpu>>, Unsupported> {
        let open = self.gpu.map_err(|why| Unsupported(why.into()))?;
        open(self.method.clone(), context)
    }
    fn leaves(&self) -> &'static Leaves {
        &M::LEAVES
    }
    fn shaders(&self) -> &'static [Shader] {
        self.shaders
    }
    fn boxed_clone(&self) -> Box<dyn Configured> {
        Box::new(Self {
            method: self.method.clone(),
            ..*self
        })
    }
}
