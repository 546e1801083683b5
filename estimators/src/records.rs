//! A look at what a session has prepared, for those who compare backends record by record.

use crate::error::EstimatorError;
use bytemuck::Pod;
use interreflect_gpu::GpuContext;

/// Numbers of one kind that `prepare` made, laid out as shaders read them.
#[derive(Clone, Debug, PartialEq)]
pub struct Records {
    /// What they are.
    pub name: &'static str,
    /// How many make one record.
    pub width: usize,
    /// Record after record.
    pub values: Vec<f32>,
    /// Each is made of captured texels of its own, as those of single directions are; else each sums
    /// over all.
    pub shares_captures: bool,
    /// The power of a lobe is in them.
    pub has_lobes: bool,
}

impl Records {
    /// Records that lie on the host.
    pub fn host<T: Pod>(name: &'static str, records: &[T]) -> Self {
        Self {
            name,
            width: size_of::<T>() / size_of::<f32>(),
            values: bytemuck::cast_slice(records).to_vec(),
            shares_captures: false,
            has_lobes: false,
        }
    }

    /// Records of type `T` in a buffer.
    pub fn device<T: Pod>(
        name: &'static str,
        context: &GpuContext,
        buffer: &wgpu::Buffer,
    ) -> Result<Self, EstimatorError> {
        Ok(Self {
            name,
            width: size_of::<T>() / size_of::<f32>(),
            values: context.read_buffer(buffer)?,
            shares_captures: false,
            has_lobes: false,
        })
    }

    /// Each made of captured texels of its own.
    pub fn sharing_captures(self) -> Self {
        Self {
            shares_captures: true,
            ..self
        }
    }

    /// With the power of a lobe in them.
    pub fn with_lobes(self) -> Self {
        Self {
            has_lobes: true,
            ..self
        }
    }

    /// The first `count` of them: a buffer may be longer than what it holds.
    pub fn first(mut self, count: usize) -> Self {
        self.values.truncate(count * self.width);
        self
    }

    /// Bits, by words of 32: they are compared as they are, not as numbers.
    pub fn bits(name: &'static str, words: Vec<u32>) -> Self {
        Self {
            name,
            width: 1,
            values: bytemuck::cast_vec(words),
            shares_captures: false,
            has_lobes: false,
        }
    }

    /// A count, which has to be below 2²⁴ to be exact.
    pub fn count(name: &'static str, count: u64) -> Self {
        Self {
            name,
            width: 1,
            values: vec![count as f32],
            shares_captures: false,
            has_lobes: false,
        }
    }

    /// Those that are not 0 throughout.
    pub fn without_zeros(self) -> Self {
        let records = self.values.chunks_exact(self.width);
        let written = records.filter(|record| record.iter().any(|v| *v != 0.0));
        Self {
            values: written.flatten().copied().collect(),
            ..self
        }
    }
}
