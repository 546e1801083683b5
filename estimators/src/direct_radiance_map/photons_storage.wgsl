// More photons than a uniform buffer holds.
@group(0) @binding(4) var<storage, read> photons: array<Photon>;
