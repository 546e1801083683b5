//! The traits that a method implements.

use crate::backend::{Backend, Gpu};
use crate::claims::Claim;
use crate::error::{EstimatorError, Unsupported};
use crate::frame::Frame;
use crate::leaves::Leaves;
use crate::model::OwnModel;
use crate::quantity::Quantity;
use crate::records::Records;
use interreflect_gpu::{GpuContext, Kernel, Shader};
use interreflect_scene::params::Params;
use interreflect_scene::{Needs, SceneFacts};
use std::fmt;

/// What a method is called, and where it comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Info {
    /// Name in code, on the command line and in records: the name of its folder.
    pub id: &'static str,
    /// Title for readers.
    pub title: &'static str,
    /// What it is, in one line that begins in lower case.
    pub summary: &'static str,
    /// The papers that it comes from; none for what belongs to everyone.
    pub references: &'static [Reference],
    /// How the picture of its limits is made.
    pub figure: Option<Figure>,
}

/// A publication.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Reference {
    /// Authors, separated by commas.
    pub authors: &'static str,
    /// Title.
    pub title: &'static str,
    /// Journal with volume and number, or conference.
    pub venue: &'static str,
    /// Year of publication.
    pub year: u32,
    /// Digital object identifier, where it is known.
    pub doi: Option<&'static str>,
}

impl fmt::Display for Reference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            authors,
            title,
            venue,
            year,
            ..
        } = self;
        write!(f, "{authors}: {title}. {venue}, {year}")
    }
}

/// The picture of a method's limits: the overview of a `bench` of it alone, limits.png in its folder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Figure {
    /// Scene of the library.
    pub scene: &'static str,
    /// What is shown.
    pub quantity: Quantity,
    /// Settings as `--set` takes them, qualified.
    pub settings: &'static [&'static str],
}

impl Info {
    /// The references in one line.
    pub fn source(&self) -> String {
        let all: Vec<String> = self.references.iter().map(Reference::to_string).collect();
        all.join("; ")
    }
}

/// What the paper says, wherever it runs: the parameters of a method, and what follows from them.
pub trait Method: Params {
    /// What it is called.
    const INFO: Info;
    /// What it can estimate, its main quantity first.
    const QUANTITIES: &'static [Quantity];
    /// The formulas of its math.rs and math.wgsl.
    const LEAVES: Leaves = Leaves::NONE;

    /// What it must be given for one quantity in such a scene, and no more.
    ///
    /// # Errors
    /// [`Unsupported`] if it can't work there, with the reason.
    fn needs(&self, quantity: Quantity, scene: &SceneFacts) -> Result<Needs, Unsupported>;

    /// What it claims to compute.
    fn model(&self, quantity: Quantity) -> OwnModel;

    /// What holds for its estimates with these parameters: `verify` checks it.
    fn claims(&self, quantity: Quantity) -> Vec<Claim>;
}

/// How a method runs on a backend: captures are prepared, then points are shaded.
pub trait Estimator<B: Backend>: Method {
    /// What `prepare` makes: all that shading reads, and what the next frame can go on with.
    type Prepared: Prepared<B>;

    /// Every shader that it runs on this backend: none on the CPU.
    const SHADERS: &'static [Shader] = &[];

    /// Whether this backend, as it is on this machine, can run it.
    ///
    /// # Errors
    /// [`Unsupported`] with the reason if it can't.
    fn supports(&self, _caps: &B::Caps) -> Result<(), Unsupported> {
        Ok(())
    }

    /// Turns captures into what shading needs. Called for the first frame and whenever something
    /// changed, with what the session's last call returned; all allocation and binding happens here,
    /// that of `frame.out` too.
    ///
    /// # Errors
    /// [`EstimatorError`] if a capture is undeclared or the backend refuses.
    fn prepare(
        &self,
        frame: &mut Frame<'_, B>,
        last: Option<Self::Prepared>,
    ) -> Result<Self::Prepared, EstimatorError>;
}

/// A method that is ready to shade.
pub trait Prepared<B: Backend>: Send + 'static {
    /// Estimates the quantity at every point. Makes no buffer, binding or vector.
    ///
    /// # Errors
    /// [`EstimatorError`] if the backend refuses.
    fn shade(&self, frame: &mut Frame<'_, B>) -> Result<(), EstimatorError>;

    /// The numbers that shading reads, laid out as shaders read them, under the same names on both
    /// backends: `verify` compares them.
    ///
    /// # Errors
    /// [`EstimatorError`] if the device fails.
    fn records(&self, _caps: &B::Caps) -> Result<Vec<Records>, EstimatorError> {
        Ok(Vec::new())
    }
}

/// A method whose shading on the GPU is one dispatch over all points, or several in a row.
pub trait Kernels: Send + 'static {
    /// The kernels, in the order in which they run.
    fn kernels(&self) -> &[Kernel];

    /// As [`Prepared::records`].
    ///
    /// # Errors
    /// [`EstimatorError`] if the device fails.
    fn records(&self, _context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        Ok(Vec::new())
    }
}

impl<K: Kernels> Prepared<Gpu> for K {
    fn shade(&self, frame: &mut Frame<'_, Gpu>) -> Result<(), EstimatorError> {
        let workgroups = frame.points.workgroups();
        for kernel in self.kernels() {
            kernel.record(frame.cx, workgroups);
        }
        Ok(())
    }

    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        Kernels::records(self, context)
    }
}
