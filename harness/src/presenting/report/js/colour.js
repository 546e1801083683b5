// From linear pixels to what the screen shows.

function srgbByte(linear) {
  const v = Math.min(Math.max(linear, 0), 1) || 0;
  return 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);
}

function shownImage(rgb, width, height, exposure) {
  const image = new ImageData(width, height);
  for (let i = 0; i < width * height; i++) {
    for (let c = 0; c < 3; c++) image.data[4 * i + c] = srgbByte(exposure * rgb[3 * i + c]);
    image.data[4 * i + 3] = 255;
  }
  return image;
}

// The ε of relMSE for an image: that of the metrics over all pixels that show a surface.
function epsilonOf(reference, mask, fraction) {
  let sum = 0;
  let count = 0;
  for (let i = 0; i < reference.length; i++) {
    if (mask && !mask[Math.floor(i / 3)]) continue;
    sum += Math.abs(reference[i]);
    count++;
  }
  return (fraction * (count ? sum / count : 0)) ** 2;
}

// Mean over the channels of e − r; of (e − r) / √(r² + ε) where an ε is given.
function errorAt(estimate, reference, i, epsilon) {
  let sum = 0;
  for (let k = 3 * i; k < 3 * i + 3; k++) {
    const difference = estimate[k] - reference[k];
    sum += epsilon === null ? difference : difference / (Math.sqrt(reference[k] ** 2 + epsilon) || 1);
  }
  return sum / 3;
}

// Colour of an error as a fraction of the range, linear between the stops.
function errorColour(fraction, stops) {
  const place = ((Math.min(Math.max(fraction, -1), 1) + 1) / 2) * (stops.length - 1);
  const lower = Math.min(Math.floor(place), stops.length - 2);
  const t = place - lower;
  return stops[lower].map((a, c) => a + t * (stops[lower + 1][c] - a));
}

function errorImage(estimate, reference, mask, width, height, { epsilon, range, stops, nothing }) {
  const image = new ImageData(width, height);
  for (let i = 0; i < width * height; i++) {
    const error = errorAt(estimate, reference, i, epsilon);
    const shown = (!mask || mask[i]) && Number.isFinite(error);
    const colour = shown ? errorColour(error / range, stops) : nothing;
    for (let c = 0; c < 3; c++) image.data[4 * i + c] = colour[c];
    image.data[4 * i + 3] = 255;
  }
  return image;
}

// A number with four significant digits.
function words(value) {
  if (value === 0) return "0";
  const magnitude = Math.abs(value);
  return magnitude >= 1e-3 && magnitude < 1e5 ? value.toPrecision(4) : value.toExponential(2);
}
