// Where, and how much, the file's colours differ from those of the texture.
const heat = [[0, 0, 4], [87, 16, 110], [188, 55, 84], [249, 142, 9], [252, 255, 164]];

function heatColor(share) {
  const at = Math.min(1, Math.max(0, share)) * (heat.length - 1);
  const low = Math.min(Math.floor(at), heat.length - 2);
  return heat[low].map((value, i) => value + (at - low) * (heat[low + 1][i] - value));
}

function drawMap(texels) {
  const most = Math.max(report.verified.max, 1e-6);
  const canvas = element("map");
  canvas.width = report.columns;
  canvas.height = report.rows;
  const image = new ImageData(report.columns, report.rows);
  texels.differences.forEach((de, texel) => image.data.set([...heatColor(de / most), 255], 4 * texel));
  canvas.getContext("2d").putImageData(image, 0, 0);
  const scale = element("map-scale");
  scale.width = 256;
  scale.height = 1;
  const bar = new ImageData(256, 1);
  for (let i = 0; i < 256; ++i) bar.data.set([...heatColor(i / 255), 255], 4 * i);
  scale.getContext("2d").putImageData(bar, 0, 0);
  element("map-most").textContent = most.toPrecision(2);
  const size = report.step === 1 ? "Each point is a texel." :
    `Each point is the worst of ${report.step} × ${report.step} texels.`;
  element("map-says").textContent = `CIEDE2000 between the colour that the texture asks for and that of the ` +
    `bands under ${report.light}. ${size} A difference below 1 is not seen side by side.`;
}

function drawHistogram() {
  const { from, perDecade, counts } = report.histogram;
  const power = (bin) => from + bin / perDecade;
  const total = counts.reduce((sum, count) => sum + count, 0);
  const most = Math.max(...counts, 1);
  const ticks = [];
  const apart = element("histogram").clientWidth < 480 ? 2 : 1;
  for (let exponent = from; exponent <= power(counts.length); exponent += apart) ticks.push(exponent);
  const plot = new Plot(element("histogram"),
    { from, to: power(counts.length), ticks, label: "CIEDE2000", text: (value) => `1e${value}` },
    { from: 0, to: most / total, ticks: [0, most / total], text: (share) => `${(100 * share).toFixed(0)} %` });
  counts.forEach((count, bin) => {
    const top = plot.toY(count / total);
    shape(plot.svg, "rect", {
      class: "bar", x: plot.toX(power(bin)) + 0.5, width: plot.toX(power(bin + 1)) - plot.toX(power(bin)) - 1,
      y: top, height: plot.inside.bottom - top,
    });
  });
  const { mean, p99, max } = report.verified;
  element("histogram-says").textContent = `All ${total} texels, by their difference; the first bar also holds ` +
    `those below it. Mean ${mean.toPrecision(2)}, 99 of 100 below ${p99.toPrecision(2)}, the worst ${max.toPrecision(2)}.`;
}
