//! Hemisphere ambient light on the CPU.

use super::HemisphereAmbient;
use super::math::blended_irradiance;
use interreflect::averaging::cube_texels;
use interreflect::prelude::*;

/// Mean radiance from below and from above.
pub struct Means([Vec3; 2]);

impl Estimator<Cpu> for HemisphereAmbient {
    type Prepared = Means;

    fn prepare(
        &self,
        frame: &mut Frame<'_, Cpu>,
        _last: Option<Means>,
    ) -> Result<Means, EstimatorError> {
        let cube = frame.cube(&self.captured())?;
        let mut sums = [(DVec3::ZERO, 0.0); 2];
        for (face, column, row) in cube_texels(cube.size) {
            let place = |i| texel_centre(cube.size, i);
            let up = cube_vector(face, place(column), place(row)).y;
            let omega_sr = texel_solid_angle_sr(cube.size, column, row);
            let radiance = cube.radiance[texel_index(cube.size, face, column, row)].as_dvec3();
            let sum = &mut sums[usize::from(up >= 0.0)];
            *sum = (sum.0 + radiance * omega_sr, sum.1 + omega_sr);
        }
        Ok(Means(
            sums.map(|(sum, omega_sr)| (sum / omega_sr).as_vec3()),
        ))
    }
}

impl Prepared<Cpu> for Means {
    fn shade(&self, frame: &mut Frame<'_, Cpu>) -> Result<(), EstimatorError> {
        frame.for_each_tile(self);
        Ok(())
    }

    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        let means = self.0.map(|mean| mean.extend(0.0).to_array());
        Ok(vec![Records::host("means", &means)])
    }
}

impl TileKernel for Means {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let up = points.plane(PointLayout::NORMAL + 1);
        let [below, above] = self.0.map(|mean| mean.to_array());
        std::array::from_fn(|c| blended_irradiance(below[c].into(), above[c].into(), up))
    }
}
