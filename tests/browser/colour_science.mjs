// Colours are computed as eyes have them: [r, g, b] in [0, 1], as CSS has them, and CIE L*a*b* for differences.

const toLinear = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const toGamma = (c) => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);
const times = (matrix, v) => matrix.map((row) => row.reduce((sum, value, i) => sum + value * v[i], 0));
const clamped = (v) => v.map((c) => Math.min(1, Math.max(0, c)));

// The matrices are of Machado, Oliveira and Fernandes, "A physiologically-based model for simulation of color vision
// deficiency", 2009: severity 1.0, on linear values.
export const eyes = {
  usual: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deuteranopia: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
};

export function seenBy(eye, colour) {
  return clamped(times(eye, colour.map(toLinear))).map(toGamma);
}

const xyzOfLinear = [
  [0.4124564, 0.3575761, 0.1804375],
  [0.2126729, 0.7151522, 0.072175],
  [0.0193339, 0.119192, 0.9503041],
];
const white = [0.95047, 1, 1.08883];

function lab(colour) {
  const cubeRoot = (t) => (t > (6 / 29) ** 3 ? Math.cbrt(t) : t / (3 * (6 / 29) ** 2) + 4 / 29);
  const [x, y, z] = times(xyzOfLinear, colour.map(toLinear)).map((c, i) => cubeRoot(c / white[i]));
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

// Returns the distance in L*a*b* (CIE 1976): about 2 can just be told apart side by side.
export function difference(a, b) {
  const [p, q] = [lab(a), lab(b)];
  return Math.hypot(...p.map((c, i) => c - q[i]));
}

// This is the "contrast ratio" of WCAG 2.2.
export function contrast(a, b) {
  const luminance = (colour) => times([[0.2126, 0.7152, 0.0722]], colour.map(toLinear))[0];
  const [light, dark] = [luminance(a), luminance(b)].sort((x, y) => y - x);
  return (light + 0.05) / (dark + 0.05);
}
