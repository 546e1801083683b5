//! The adapters of this machine and the choice among them.

use crate::GpuError;

/// What is known of an adapter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AdapterInfo {
    /// Name of the device.
    pub name: String,
    /// Name of the driver.
    pub driver: String,
    /// Version of the driver.
    pub driver_info: String,
    /// Graphics API.
    pub backend: wgpu::Backend,
    /// Discrete, integrated, virtual or software.
    pub device_type: wgpu::DeviceType,
    /// Whether it runs on the CPU: every time measured on it must say so.
    pub software: bool,
}

impl From<wgpu::AdapterInfo> for AdapterInfo {
    fn from(info: wgpu::AdapterInfo) -> Self {
        Self {
            name: info.name,
            driver: info.driver,
            driver_info: info.driver_info,
            backend: info.backend,
            device_type: info.device_type,
            software: info.device_type == wgpu::DeviceType::Cpu,
        }
    }
}

/// Every Vulkan adapter of this machine; an adapter's index is its place in the list.
pub fn adapters() -> Vec<AdapterInfo> {
    enumerate().iter().map(|a| a.get_info().into()).collect()
}

fn enumerate() -> Vec<wgpu::Adapter> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends: wgpu::Backends::VULKAN,
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    });
    pollster::block_on(instance.enumerate_adapters(wgpu::Backends::VULKAN))
}

/// The adapter of an index or a part of a name, or the best one.
pub(crate) fn choose(choice: Option<&str>) -> Result<wgpu::Adapter, GpuError> {
    let adapters = enumerate();
    let infos: Vec<AdapterInfo> = adapters.iter().map(|a| a.get_info().into()).collect();
    let index = choose_index(&infos, choice)?;
    adapters.into_iter().nth(index).ok_or(GpuError::NoAdapter)
}

fn choose_index(infos: &[AdapterInfo], choice: Option<&str>) -> Result<usize, GpuError> {
    // `min_by_key` keeps the first of equals, so the driver's own order decides among them.
    let best = (0..infos.len()).min_by_key(|&i| rank(infos[i].device_type));
    let best = best.ok_or(GpuError::NoAdapter)?;
    let Some(asked) = choice else {
        return Ok(best);
    };
    let found = match asked.parse::<usize>() {
        Ok(index) => (index < infos.len()).then_some(index),
        Err(_) => {
            let wanted = asked.to_lowercase();
            infos
                .iter()
                .position(|i| i.name.to_lowercase().contains(&wanted))
        }
    };
    found.ok_or_else(|| {
        let known = infos
            .iter()
            .enumerate()
            .map(|(i, a)| format!("{i}: {}", a.name));
        GpuError::UnknownAdapter {
            asked: asked.to_owned(),
            known: known.collect::<Vec<_>>().join(", "),
        }
    })
}

fn rank(device_type: wgpu::DeviceType) -> u32 {
    match device_type {
        wgpu::DeviceType::DiscreteGpu => 0,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::VirtualGpu => 2,
        wgpu::DeviceType::Other => 3,
        wgpu::DeviceType::Cpu => 4,
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]
    use super::*;

    fn info(name: &str, device_type: wgpu::DeviceType) -> AdapterInfo {
        AdapterInfo {
            name: name.into(),
            driver: String::new(),
            driver_info: String::new(),
            backend: wgpu::Backend::Vulkan,
            device_type,
            software: device_type == wgpu::DeviceType::Cpu,
        }
    }

    fn three() -> [AdapterInfo; 3] {
        [
            info("llvmpipe (LLVM 15)", wgpu::DeviceType::Cpu),
            info("Iris Xe", wgpu::DeviceType::IntegratedGpu),
            info("GeForce", wgpu::DeviceType::DiscreteGpu),
        ]
    }

    #[test]
    fn hardware_is_preferred_to_software() {
        assert_eq!(choose_index(&three(), None), Ok(2));
        assert_eq!(choose_index(&three()[..2], None), Ok(1));
        assert_eq!(choose_index(&three()[..1], None), Ok(0));
    }

    #[test]
    fn an_adapter_is_chosen_by_index_or_part_of_its_name() {
        assert_eq!(choose_index(&three(), Some("1")), Ok(1));
        assert_eq!(choose_index(&three(), Some("LLVMPIPE")), Ok(0));
    }

    #[test]
    fn a_choice_without_a_match_lists_the_adapters() {
        for asked in ["3", "Radeon"] {
            let error = choose_index(&three(), Some(asked)).unwrap_err().to_string();
            assert!(
                error.contains(asked) && error.contains("1: Iris Xe"),
                "{error}"
            );
        }
    }

    #[test]
    fn no_adapter_says_what_to_install_and_that_the_cpu_works() {
        let error = choose_index(&[], Some("0")).unwrap_err();
        assert_eq!(error, GpuError::NoAdapter);
        let text = error.to_string();
        assert!(
            text.contains("apt-get install mesa-vulkan-drivers libvulkan1"),
            "{text}"
        );
        assert!(text.contains("CPU backend"), "{text}");
    }
}
