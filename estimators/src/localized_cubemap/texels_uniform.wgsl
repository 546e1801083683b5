// Few texels: a uniform buffer, which shades two to three times as fast as a storage buffer.
@group(0) @binding(4) var<uniform> texels: array<Texel, 1024>;
