//! Direct radiance maps on the CPU.

use super::math::{omega_corrected, omega_published, towards_photon};
use super::samples::{Highlight, Photon, photons};
use super::{DirectRadianceMap, Formula};
use crate::texels::math::{cos_half, lobe_normalisation, normalised_reflectivity};
use crate::{Cpu, Estimator, EstimatorError, Frame, Prepared, Quantity, Records};
use interreflect_cpu::lane::{Lane, Vector};
use interreflect_cpu::tiles::{PointLanes, TileKernel};
use interreflect_scene::PointLayout;

/// The photons.
pub struct Photons {
    method: DirectRadianceMap,
    photons: Vec<Photon>,
    highlights: Vec<Highlight>,
}

impl Estimator<Cpu> for DirectRadianceMap {
    type Prepared = Photons;

    fn prepare(
        &self,
        frame: &mut Frame<'_, Cpu>,
        last: Option<Photons>,
    ) -> Result<Photons, EstimatorError> {
        if let Some(last) = frame.unless_stale(last) {
            return Ok(last);
        }
        let (photons, highlights) = photons(self, frame.rsm(&self.captured())?);
        Ok(Photons {
            method: self.clone(),
            photons,
            highlights,
        })
    }
}

impl Prepared<Cpu> for Photons {
    fn shade(&self, frame: &mut Frame<'_, Cpu>) -> Result<(), EstimatorError> {
        let (photons, highlights) = (&self.photons, &self.highlights);
        let shining = self.method.shining();
        match self.method.formula() {
            Formula::Constant => Sum::<Constant>::new(photons, highlights).run(frame, shining),
            Formula::Published => Sum::<Published>::new(photons, highlights).run(frame, shining),
            Formula::Corrected => Sum::<Corrected>::new(photons, highlights).run(frame, shining),
        }
        Ok(())
    }

    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        Ok(vec![
            Records::host("photons", &self.photons).sharing_captures(),
            Records::host("highlights", &self.highlights)
                .sharing_captures()
                .with_lobes(),
        ])
    }
}

/// The solid angle in sr of a photon.
trait Omega: Sync {
    fn omega<L: Lane>(extent: L, r2: L, cos_surface: L) -> L;
}

struct Constant;
struct Published;
struct Corrected;

impl Omega for Constant {
    #[inline(always)]
    fn omega<L: Lane>(extent: L, _r2: L, _cos_surface: L) -> L {
        extent
    }
}

impl Omega for Published {
    #[inline(always)]
    fn omega<L: Lane>(extent: L, r2: L, cos_surface: L) -> L {
        omega_published(extent, r2, cos_surface)
    }
}

impl Omega for Corrected {
    #[inline(always)]
    fn omega<L: Lane>(extent: L, r2: L, cos_surface: L) -> L {
        omega_corrected(extent, r2, cos_surface)
    }
}

struct Sum<'a, F> {
    photons: &'a [Photon],
    highlights: &'a [Highlight],
    formula: std::marker::PhantomData<F>,
}

#[inline(always)]
fn accumulate<L: Lane>(sum: &mut [L; 3], radiance: [L; 3], weight: L) {
    for (sum, radiance) in sum.iter_mut().zip(radiance) {
        *sum = *sum + weight * radiance;
    }
}

impl<'a, F: Omega> Sum<'a, F> {
    fn new(photons: &'a [Photon], highlights: &'a [Highlight]) -> Self {
        Self {
            photons,
            highlights,
            formula: std::marker::PhantomData,
        }
    }

    fn run(self, frame: &mut Frame<'_, Cpu>, shining: bool) {
        match (shining, frame.quantity == Quantity::GlossyRadiance) {
            (false, false) => frame.for_each_tile(&Irradiance::<_, false>(self)),
            (true, false) => frame.for_each_tile(&Irradiance::<_, true>(self)),
            (false, true) => frame.for_each_tile(&Glossy::<_, false>(self)),
            (true, true) => frame.for_each_tile(&Glossy::<_, true>(self)),
        }
    }

    /// Direction to a photon, its solid angle in sr and its radiance towards the points.
    #[inline(always)]
    fn seen<const SHINING: bool, L: Lane>(
        &self,
        index: usize,
        x: Vector<L>,
    ) -> (Vector<L>, L, [L; 3]) {
        let photon = &self.photons[index];
        let (i, r2) = towards_photon(Vector::splat(photon.position), x);
        let normal = Vector::splat(photon.normal);
        let omega = F::omega(photon.extent.into(), r2, -i.dot(normal));
        let mut radiance = photon.radiance.map(L::from);
        if SHINING {
            let highlight = &self.highlights[index];
            let cos_half = cos_half(normal, Vector::splat(highlight.to_light), -i);
            let lobe = cos_half.lobe_power(photon.shininess.into());
            accumulate(&mut radiance, highlight.radiance.map(L::from), lobe);
        }
        (i, omega, radiance)
    }
}

/// E = Σ L·(n·ω)⁺·Δω.
struct Irradiance<'a, F, const SHINING: bool>(Sum<'a, F>);

impl<F: Omega, const SHINING: bool> TileKernel for Irradiance<'_, F, SHINING> {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let x = points.vector(PointLayout::POSITION);
        let n = points.vector(PointLayout::NORMAL);
        let zero = L::from(0.0);
        let mut sum = [zero; 3];
        for index in 0..self.0.photons.len() {
            let (i, omega, radiance) = self.0.seen::<SHINING, L>(index, x);
            accumulate(&mut sum, radiance, omega * n.dot(i).max(zero));
        }
        sum
    }
}

/// Σ L·f_r·(n·ω)⁺·Δω with the points' own lobes.
struct Glossy<'a, F, const SHINING: bool>(Sum<'a, F>);

impl<F: Omega, const SHINING: bool> TileKernel for Glossy<'_, F, SHINING> {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let x = points.vector(PointLayout::POSITION);
        let n = points.vector(PointLayout::NORMAL);
        let v = points.vector(PointLayout::VIEW);
        let shininess = points.plane(PointLayout::SHININESS);
        let normalisation = lobe_normalisation(shininess);
        let zero = [L::from(0.0); 3];
        let (mut diffuse, mut specular) = (zero, zero);
        for index in 0..self.0.photons.len() {
            let (i, omega, radiance) = self.0.seen::<SHINING, L>(index, x);
            let half = cos_half(n, i, v);
            let (d, s) = normalised_reflectivity(n.dot(i), half, shininess, normalisation);
            accumulate(&mut diffuse, radiance, d * omega);
            accumulate(&mut specular, radiance, s * omega);
        }
        std::array::from_fn(|c| {
            points.plane(PointLayout::DIFFUSE + c) * diffuse[c]
                + points.plane(PointLayout::SPECULAR + c) * specular[c]
        })
    }
}
