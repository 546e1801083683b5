// Packed pixels of the page, unpacked when they are first asked for.

async function unpacked(id) {
  const text = document.getElementById(id).textContent.trim();
  const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function halfToFloat(bits) {
  const sign = bits & 0x8000 ? -1 : 1;
  const exponent = (bits >> 10) & 31;
  const fraction = bits & 1023;
  if (exponent === 31) return fraction ? NaN : sign * Infinity;
  if (exponent === 0) return sign * fraction * 2 ** -24;
  return sign * (1 + fraction / 1024) * 2 ** (exponent - 15);
}

// Differences of halves, upper bytes before lower ones, a plane for each channel: see `pixels.rs`.
function rgbOf(bytes) {
  const count = bytes.length / 6;
  const rgb = new Float32Array(3 * count);
  for (let channel = 0; channel < 3; channel++) {
    const upper = 2 * channel * count;
    let bits = 0;
    for (let i = 0; i < count; i++) {
      bits = (bits + (bytes[upper + i] << 8) + bytes[upper + count + i]) & 0xffff;
      rgb[3 * i + channel] = halfToFloat(bits);
    }
  }
  return rgb;
}

const decoded = new Map();

// The value that `make` gives for a block, made once.
function once(id, make) {
  if (!decoded.has(id)) decoded.set(id, unpacked(id).then(make));
  return decoded.get(id);
}

// Linear R, G, B of a picture, row by row.
const pixelsOf = (picture) => once(picture.pixels, rgbOf);

// A byte for each pixel of a row: 0 where there is no surface. `null` if there is one everywhere.
const maskOf = (row) => (row.mask ? once(row.mask, (bytes) => bytes) : Promise.resolve(null));
