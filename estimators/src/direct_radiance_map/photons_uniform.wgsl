// Few photons: a uniform buffer, which is read faster than a storage buffer.
@group(0) @binding(4) var<uniform> photons: array<Photon, 1024>;
