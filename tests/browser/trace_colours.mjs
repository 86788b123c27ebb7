// What is measured inside a page; each function is sent to the browser whole.

// Texts whose contrast with what is behind them is less than WCAG AA asks for: 4.5, or 3 for large ones.
export function poorContrasts() {
  const channels = (colour) => colour.match(/[\d.]+/g).map(Number);
  const linear = (c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4);
  const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
  const ratio = (a, b) => (Math.max(luminance(a), luminance(b)) + 0.05) / (Math.min(luminance(a), luminance(b)) + 0.05);
  const background = (node) => {
    for (let n = node; n instanceof Element; n = n.parentElement) {
      const found = channels(getComputedStyle(n).backgroundColor);
      if (found.length === 3 || found[3] === 1) return found;
    }
    return [255, 255, 255];
  };
  // In the drawing a text has a white halo.
  const colours = (node) => (node instanceof SVGElement ? [channels(getComputedStyle(node).fill), [255, 255, 255]]
    : [channels(getComputedStyle(node).color), background(node)]);
  const isLarge = (style) => parseFloat(style.fontSize) >= 24 || (parseFloat(style.fontSize) >= 18.66 && +style.fontWeight >= 700);
  const poor = [];
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const node = texts.currentNode.parentElement;
    if (!texts.currentNode.textContent.trim() || ["SCRIPT", "OPTION"].includes(node.tagName) || node.getClientRects().length === 0) continue;
    const found = ratio(...colours(node));
    if (found < (isLarge(getComputedStyle(node)) ? 3 : 4.5)) poor.push(`${node.tagName} ${node.className.baseVal ?? node.className}: ${found.toFixed(2)}`);
  }
  return poor;
}

// For full sight, protanopia and deuteranopia (Viénot, Brettel and Mollon 1999): how near the two nearest of the eight
// colours of faces are, in CIE L*a*b*.
export function colourDistances() {
  const linear = (c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4);
  const times = (m, v) => m.map((row) => row.reduce((sum, a, i) => sum + a * v[i], 0));
  const simulations = {
    full: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
    protanopia: [[0.11238, 0.88762, 0], [0.11238, 0.88762, 0], [0.00401, -0.00401, 1]],
    deuteranopia: [[0.29275, 0.70725, 0], [0.29275, 0.70725, 0], [-0.02234, 0.02234, 1]],
  };
  const toXyz = [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]];
  const lab = (rgb) => {
    const white = [0.9505, 1, 1.089];
    const [x, y, z] = times(toXyz, rgb).map((v, i) => Math.cbrt(Math.max(v / white[i], 0)));
    return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
  };
  const probe = document.body.appendChild(document.createElement("span"));
  const colours = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => {
    probe.className = `chip face-${i}`;
    return getComputedStyle(probe).backgroundColor.match(/\d+/g).map((c) => linear(+c));
  });
  probe.remove();
  return Object.entries(simulations).map(([kind, matrix]) => {
    const seen = colours.map((rgb) => lab(times(matrix, rgb)));
    const apart = seen.flatMap((a, i) => seen.slice(i + 1).map((b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2])));
    return { kind, nearest: Math.min(...apart) };
  });
}
