// The spectra of the texel looked at and of those pinned.
const pinColors = ["#e69f00", "#56b4e9", "#009e73", "#d55e00", "#cc79a7", "#8c7ae6"];

function spectrumOf(texels, texel) {
  const first = texel * bandCount;
  return report.wavelengths.map((nm, band) => [nm, texels.spectra[first + band]]);
}

function nameOf(texel) {
  const { x, y } = placeOf(texel);
  return `(${x}, ${y})`;
}

class Spectra {
  constructor(texels) {
    this.texels = texels;
    this.pinned = []; // { texel, color }
    this.current = 0;
  }

  look(texel) {
    this.current = texel;
    const mark = this.texels.marks[texel];
    const words = [`texel ${nameOf(texel)}`, `ΔE up to ${this.texels.differences[texel].toPrecision(2)} here`];
    if (isOutside(mark)) words.push("a colour that no reflectance has");
    if (isNotFinite(mark)) words.push("not a finite number");
    element("readout").value = words.join(" · ");
    this.draw();
  }

  pin(texel) {
    const known = this.pinned.findIndex((pin) => pin.texel === texel);
    if (known >= 0) this.pinned.splice(known, 1);
    else if (this.pinned.length < pinColors.length) {
      const color = pinColors.find((one) => !this.pinned.some((pin) => pin.color === one));
      this.pinned.push({ texel, color });
    } else element("readout").value = `No more than ${pinColors.length} spectra are compared: unpin one first.`;
    this.listPins();
    this.draw();
  }

  listPins() {
    element("pins").replaceChildren(...this.pinned.map(({ texel, color }) => {
      const swatch = Object.assign(document.createElement("span"), { className: "swatch" });
      swatch.style.background = color;
      const button = document.createElement("button");
      button.append(swatch, `${nameOf(texel)} ×`);
      button.setAttribute("aria-label", `unpin texel ${nameOf(texel)}`);
      button.addEventListener("click", () => this.pin(texel));
      const item = document.createElement("li");
      item.append(button);
      return item;
    }));
    this.tabulate();
  }

  tabulate() {
    const table = element("numbers");
    table.replaceChildren();
    const row = (cells, kind) => {
      const line = table.insertRow();
      for (const text of cells) line.appendChild(document.createElement(kind)).textContent = text;
    };
    row(["nm", ...this.pinned.map(({ texel }) => nameOf(texel))], "th");
    report.wavelengths.forEach((nm, band) =>
      row([nm, ...this.pinned.map(({ texel }) => this.texels.spectra[texel * bandCount + band].toFixed(5))], "td"));
  }

  draw() {
    const waves = report.wavelengths;
    const plot = new Plot(element("spectra"),
      { from: waves[0], to: waves[waves.length - 1], ticks: [400, 500, 600, 700], label: "wavelength, nm", text: String },
      { from: Math.min(0, report.low), to: Math.max(1, report.high), ticks: [0, 0.25, 0.5, 0.75, 1], text: String });
    for (const { texel, color } of this.pinned) plot.line(spectrumOf(this.texels, texel), { stroke: color });
    plot.line(spectrumOf(this.texels, this.current), { stroke: "currentColor", "stroke-dasharray": "5 4" });
    this.drawMarks();
  }

  drawMarks() {
    const circle = (texel, color) => shape(element("marks"), "circle", {
      cx: (texel % report.columns) + 0.5, cy: Math.floor(texel / report.columns) + 0.5,
      r: report.columns / 60, fill: "none", stroke: color, "stroke-width": 2, "vector-effect": "non-scaling-stroke",
    });
    element("marks").replaceChildren();
    for (const { texel, color } of this.pinned) circle(texel, color);
    circle(this.current, "#ffffff");
    circle(this.current, "#000000").setAttribute("stroke-dasharray", "3 3");
  }
}
