// Few texels: a uniform buffer, which shades about 1.5 to 1.8 times as fast on lavapipe.
@group(0) @binding(4) var<uniform> texels: array<Texel, 1024>;
