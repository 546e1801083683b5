//! Indirect-illumination estimators: traits, parameters, registry and one folder per method.
