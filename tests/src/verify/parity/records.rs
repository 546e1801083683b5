//! What `prepare` makes on the CPU and on the device of the same captures, record by record.

use super::{Apart, LOBE, MethodUnderTest, OF_A_TERM, VerifyError, shared, sum_of, texels};
use crate::exchange::uploaded;
use interreflect_estimators::execution::{BackendScene, LoadedScene};
use interreflect_estimators::{Changed, Records, Tolerance};
use interreflect_gpu::GpuContext;
use interreflect_scene::Points;
use std::rc::Rc;
use std::sync::Arc;

/// Compares the records of a method in a scene: the largest difference over what it may be. Its scale is
/// the largest number of a record's column: the components of a unit vector, and coefficients that
/// cancel, have the error of their terms.
///
/// # Errors
/// [`VerifyError`] if the method can't run there, or what it makes can't be compared.
pub fn record_parity(
    under_test: &MethodUnderTest<'_>,
    context: &Arc<GpuContext>,
    loaded: &LoadedScene,
    points: &Points,
) -> Result<Apart, VerifyError> {
    let (method, quantity) = (under_test.method, under_test.quantity);
    let mut on_host = loaded.cpu().executor(method, quantity, points)?;
    on_host.prepare(Changed::ALL)?;
    let captures = on_host.captures()?;
    shared(&captures)?;
    let mut on_device = loaded.gpu()?.executor(method, quantity, points)?;
    on_device.set_captures(Rc::new(uploaded(context, &captures)?));
    on_device.prepare(Changed::ALL)?;
    let (host, device) = (on_host.records()?, on_device.records()?);
    if host.is_empty() && device.is_empty() {
        let why = "what it prepares is not shown (Prepared::records)";
        return Err(VerifyError::NotComparable(why.into()));
    }
    let mut worst = Apart {
        of_bound: 0.0,
        cases: 0,
        place: String::new(),
    };
    if host.len() != device.len() {
        worst.of_bound = f64::INFINITY;
        worst.place = format!("{} lists, on the device {}", host.len(), device.len());
    }
    for (host, device) in host.iter().zip(&device) {
        let apart = same(host, device, texels(&captures));
        worst.cases += apart.cases;
        worst.keep_larger(apart.of_bound, || apart.place);
    }
    Ok(worst)
}

fn same(host: &Records, device: &Records, captured: f64) -> Apart {
    let (name, width) = (host.name, host.width);
    let mut worst = Apart {
        of_bound: 0.0,
        cases: host.values.len(),
        place: name.into(),
    };
    if name != device.name || width != device.width || host.values.len() != device.values.len() {
        worst.of_bound = f64::INFINITY;
        worst.place = format!(
            "{name}: {} numbers, on the device {} of {}",
            host.values.len(),
            device.values.len(),
            device.name
        );
        return worst;
    }
    let records = (host.values.len() / width).max(1) as f64;
    // Records of single directions share the captured texels; the others each sum over all.
    let terms = match host.shares_captures {
        true => captured / records,
        false => captured,
    };
    for column in 0..width {
        let of = |list: &Records| -> Vec<f64> {
            let column = list.values.iter().skip(column).step_by(width);
            column.map(|v| f64::from(*v)).collect()
        };
        let (a, b) = (of(host), of(device));
        let scale = a.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let tolerance = Tolerance {
            absolute: sum_of(terms, OF_A_TERM) * scale,
            relative: if host.has_lobes { LOBE } else { 0.0 },
            cause: "float32 sums over the captured texels of a record",
        };
        for (i, (a, b)) in a.iter().zip(&b).enumerate() {
            // Words of bits may be no numbers: they are compared as they are.
            let same = (*a as f32).to_bits() == (*b as f32).to_bits();
            let of_bound = if same {
                0.0
            } else {
                tolerance.of_bound(*a, *b)
            };
            worst.keep_larger(of_bound, || {
                let cause = tolerance.cause;
                format!("{name} {i}, column {column}: {a}, on the device {b} ({cause})")
            });
        }
    }
    worst
}

#[cfg(test)]
mod tests {
    use super::*;

    fn records(values: [f32; 3]) -> Records {
        Records {
            name: "means",
            width: 1,
            values: values.into(),
            shares_captures: false,
            has_lobes: false,
        }
    }

    #[test]
    fn a_value_that_is_no_number_on_one_side_is_the_worst_wherever_it_stands() {
        let host = records([1.0, 2.0, 3.0]);
        let apart = |device| same(&host, &records(device), 1.0).of_bound;
        assert_eq!(apart([1.0, 2.0, 3.0]), 0.0);
        assert!((1.0..f64::INFINITY).contains(&apart([1.0, 2.1, 3.0])));
        for i in 0..3 {
            let mut device = [1.0, 2.1, 3.0];
            device[i] = f32::NAN;
            assert_eq!(apart(device), f64::INFINITY, "{device:?}");
        }
    }
}
