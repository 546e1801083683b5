//! Criterion benchmarks over the registry and the captures.
