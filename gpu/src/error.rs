//! What can go wrong on a GPU.

/// Why the GPU backend could not do what was asked.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GpuError {
    /// There is no Vulkan adapter on this machine.
    #[error(
        "no Vulkan adapter was found: install a driver, for example the software one with \
         `apt-get install mesa-vulkan-drivers libvulkan1`, or use the CPU backend, which needs none"
    )]
    NoAdapter,
    /// No adapter has the index or name that was asked for.
    #[error("no adapter matches `{asked}`; use an index or a part of a name of: {known}")]
    UnknownAdapter {
        /// The choice as given.
        asked: String,
        /// Every adapter with its index.
        known: String,
    },
    /// The adapter could not open a device.
    #[error("the adapter `{adapter}` could not open a device: {reason}")]
    NoDevice {
        /// Name of the adapter.
        adapter: String,
        /// What the driver said.
        reason: String,
    },
    /// A shader is not valid WGSL.
    #[error("the shader `{label}` is not valid: {reason}")]
    Shader {
        /// Label of the shader.
        label: &'static str,
        /// The validator's message, with the place in the source.
        reason: String,
    },
    /// A shader has no such entry point.
    #[error("the shader `{label}` has no entry point `{asked}`; it has: {known}")]
    UnknownEntryPoint {
        /// Label of the shader.
        label: &'static str,
        /// The entry point as given.
        asked: String,
        /// Its entry points.
        known: String,
    },
    /// An entry point reads a slot that was not bound.
    #[error("the shader `{label}` uses slot {slot} (`{name}`) here, but nothing is bound to it")]
    Unbound {
        /// Label of the shader.
        label: &'static str,
        /// The slot: `@group(0) @binding(slot)`.
        slot: u32,
        /// Name of the variable in the shader.
        name: String,
    },
    /// The driver's validation refused a command: a fault in a shader or in its bindings.
    #[error("{what}: the GPU refused a command: {reason}")]
    Validation {
        /// What was being done.
        what: String,
        /// What the validation said.
        reason: String,
    },
    /// Memory ran out on the device.
    #[error("{what}: the GPU is out of memory; use fewer points or smaller captures")]
    OutOfMemory {
        /// What was being done.
        what: String,
    },
    /// A fault inside the driver.
    #[error("{what}: the GPU driver failed: {reason}")]
    Driver {
        /// What was being done.
        what: String,
        /// What the driver said.
        reason: String,
    },
    /// The device is gone: reset, unplugged, or its driver crashed.
    #[error("the GPU device was lost ({reason}); open a new context")]
    DeviceLost {
        /// What the driver said.
        reason: String,
    },
    /// A buffer is larger than the device binds.
    #[error("{what} takes {bytes} bytes, the device binds at most {max}")]
    BufferTooLarge {
        /// What the buffer is for.
        what: String,
        /// Its size in bytes.
        bytes: u64,
        /// Largest size in bytes.
        max: u64,
    },
    /// A texture is larger than the device allows.
    #[error("{what} has {size} texels per edge; the device allows 1 to {max}")]
    TextureTooLarge {
        /// What the texture is for.
        what: String,
        /// Longest edge in texels.
        size: u32,
        /// Longest edge that is allowed.
        max: u32,
    },
    /// More points than one storage binding holds.
    #[error(
        "{points} points do not fit into one storage binding of this device, {max} do: \
         use fewer points or pass them in parts"
    )]
    TooManyPoints {
        /// Number of points.
        points: usize,
        /// Largest number of points.
        max: usize,
    },
    /// A channel of a capture image has the wrong number of texels.
    #[error("a channel of the capture image has {found} texels, its size says {expected}")]
    CubeImage {
        /// Texels of the channel.
        found: usize,
        /// Texels that the size says.
        expected: usize,
    },
    /// Coarse radiosity that is not what a capture needs.
    #[error("coarse radiosity has {found} {what}, the capture needs {expected}")]
    CoarseIrradiance {
        /// What differs.
        what: &'static str,
        /// How many the solution has; 0 without one.
        found: u32,
        /// How many are needed.
        expected: u32,
    },
    /// More triangles than mirrors in lights' views are followed through.
    #[error(
        "mirrors need at most {max} triangles on the GPU, the scene has {triangles}: simplify it, or \
         use the CPU backend"
    )]
    MirroredTriangles {
        /// Number of captured triangles in the scene.
        triangles: u32,
        /// Largest number of triangles.
        max: u32,
    },
    /// More lights than the light buffer holds.
    #[error("the scene has {lights} lights, the GPU capture takes at most {max}")]
    TooManyLights {
        /// Number of lights in the scene.
        lights: usize,
        /// Largest number of lights.
        max: usize,
    },
}
