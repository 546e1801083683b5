//! Oracles, invariants and parity checks that every estimator faces.
