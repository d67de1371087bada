// The chromaticities of the texels, of all reflectances, and of the texture's space.
function chromaticityOf(xyz) {
  const sum = xyz[0] + xyz[1] + xyz[2];
  return sum > 1e-6 ? [xyz[0] / sum, xyz[1] / sum] : null;
}

// One texel of every small square of the diagram that has any.
function chromaticitySquares(texels, side) {
  const squares = new Map();
  for (let texel = 0; texel < texelCount; ++texel) {
    const at = chromaticityOf(integrate(texels.spectra, texel, report.weights));
    if (!at || isNotFinite(texels.marks[texel])) continue;
    const key = `${Math.floor(at[0] / side)} ${Math.floor(at[1] / side)}`;
    if (!squares.has(key)) squares.set(key, texel);
  }
  return squares;
}

function drawChromaticities(texels) {
  const tenths = [0, 0.2, 0.4, 0.6, 0.8];
  const plot = new Plot(element("chromaticity"),
    { from: 0, to: 0.8, ticks: tenths, label: "x", text: String }, { from: 0, to: 0.9, ticks: tenths, text: String });
  const side = 0.005;
  const lamp = report.lamps.find((one) => one.name === report.light) || report.lamps[0];
  for (const [key, texel] of chromaticitySquares(texels, side)) {
    const [column, row] = key.split(" ").map(Number);
    const rgb = integrate(texels.spectra, texel, lamp.bands).map(encoded).map(Math.round);
    shape(plot.svg, "rect", {
      x: plot.toX(column * side), y: plot.toY((row + 1) * side), fill: `rgb(${rgb})`,
      width: plot.toX(side) - plot.toX(0) + 0.5, height: plot.toY(0) - plot.toY(side) + 0.5,
    });
  }
  plot.region(report.locus, { stroke: "currentColor", "stroke-width": 1.5 });
  if (report.triangle) plot.region(report.triangle, { stroke: "var(--accent)", "stroke-width": 1.5, "stroke-dasharray": "6 4" });
  const outside = report.verified.outside;
  element("chromaticity-says").textContent = `Under ${report.light}. The line bounds what reflectances can have ` +
    `(dark ones; bright colours have less room)` + (report.triangle ? `, the dashed triangle is the space ${report.space}. ` : ". ") +
    (outside ? `${outside} texels asked for a colour that no reflectance has, and were given another.`
      : "Every texel asked for a colour that a reflectance has.");
}
