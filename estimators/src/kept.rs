//! What a session keeps across frames.

use crate::error::EstimatorError;

/// Tables that depend on a method's parameters alone, kept until these change.
pub(crate) struct Kept<P, T>(Option<(P, T)>);

impl<P, T> Default for Kept<P, T> {
    fn default() -> Self {
        Self(None)
    }
}

impl<P: Clone + PartialEq, T> Kept<P, T> {
    /// The tables of the last call.
    pub(crate) fn made(&self) -> Option<&T> {
        self.0.as_ref().map(|(_, tables)| tables)
    }

    /// The tables for these parameters, made if there are none yet.
    pub(crate) fn tables(
        &mut self,
        params: &P,
        make: impl FnOnce() -> Result<T, EstimatorError>,
    ) -> Result<&mut T, EstimatorError> {
        let kept = self.0.take().filter(|(made_for, _)| made_for == params);
        let kept = match kept {
            Some(kept) => kept,
            None => (params.clone(), make()?),
        };
        Ok(&mut self.0.insert(kept).1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_made_once_for_each_value_of_the_parameters() {
        let (mut kept, mut made) = (Kept::default(), 0);
        for params in [1, 1, 2, 2, 1] {
            let tables = kept.tables(&params, || {
                made += 1;
                Ok(10 * params)
            });
            assert_eq!(tables.ok(), Some(&mut (10 * params)));
        }
        assert_eq!(made, 3);
    }
}
