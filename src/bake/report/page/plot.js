// Axes and lines in an SVG, in its own pixels, so that letters keep their size on narrow screens.
const svgName = "http://www.w3.org/2000/svg";

function shape(parent, kind, attributes, text) {
  const made = parent.appendChild(document.createElementNS(svgName, kind));
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

class Plot {
  // `x` and `y`: { from, to, ticks: [value...], label, text: value -> string }
  constructor(svg, x, y) {
    this.svg = svg;
    this.x = x;
    this.y = y;
    this.width = svg.clientWidth;
    this.height = svg.clientHeight;
    this.inside = { left: 46, right: this.width - 10, top: 10, bottom: this.height - 40 };
    svg.replaceChildren();
    svg.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
    this.drawAxes();
  }

  toX(value) {
    const { left, right } = this.inside;
    return left + ((value - this.x.from) / (this.x.to - this.x.from)) * (right - left);
  }

  toY(value) {
    const { top, bottom } = this.inside;
    return bottom - ((value - this.y.from) / (this.y.to - this.y.from)) * (bottom - top);
  }

  drawAxes() {
    const { left, right, top, bottom } = this.inside;
    for (const tick of this.x.ticks) {
      shape(this.svg, "line", { class: "axis", x1: this.toX(tick), x2: this.toX(tick), y1: top, y2: bottom });
      shape(this.svg, "text", { x: this.toX(tick), y: bottom + 16, "text-anchor": "middle" }, this.x.text(tick));
    }
    for (const tick of this.y.ticks) {
      shape(this.svg, "line", { class: "axis", x1: left, x2: right, y1: this.toY(tick), y2: this.toY(tick) });
      shape(this.svg, "text", { x: left - 6, y: this.toY(tick) + 4, "text-anchor": "end" }, this.y.text(tick));
    }
    shape(this.svg, "text", { x: (left + right) / 2, y: this.height - 6, "text-anchor": "middle" }, this.x.label);
  }

  line(points, attributes) {
    const at = points.map(([x, y]) => `${this.toX(x).toFixed(2)},${this.toY(y).toFixed(2)}`);
    return shape(this.svg, "polyline", { points: at.join(" "), fill: "none", "stroke-width": 2, ...attributes });
  }

  region(points, attributes) {
    const at = points.map(([x, y]) => `${this.toX(x).toFixed(2)},${this.toY(y).toFixed(2)}`);
    return shape(this.svg, "polygon", { points: at.join(" "), fill: "none", ...attributes });
  }
}
