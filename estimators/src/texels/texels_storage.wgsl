// More texels than a uniform buffer holds.
@group(0) @binding(4) var<storage, read> texels: array<Texel>;
