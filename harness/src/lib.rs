//! Measures real-time indirect-illumination estimators: bench, render, probe, reference, compare.
