//! Keeps the Vulkan loader's own messages off standard error, where one clear line is promised.

/// Mesa's device-selection layer complains on standard error where a session has no runtime folder
/// (containers, CI). Only the environment of the process turns it off, and that has to be set
/// before threads start: the program starts itself once more with it. For the first line of `main`.
#[cfg(unix)]
pub fn restart_without_driver_chatter() {
    use std::os::unix::process::CommandExt;
    const OFF: &str = "NODEVICE_SELECT";
    let chatty = std::env::var_os("XDG_RUNTIME_DIR").is_none() && std::env::var_os(OFF).is_none();
    if let (true, Ok(program)) = (chatty, std::env::current_exe()) {
        // Returns only if it fails; the program then goes on as it is.
        let _ = std::process::Command::new(program)
            .args(std::env::args_os().skip(1))
            .env(OFF, "1")
            .exec();
    }
}

/// Elsewhere there is no such layer.
#[cfg(not(unix))]
pub fn restart_without_driver_chatter() {}
