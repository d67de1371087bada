// The texture under the lamps, and the texel that is looked at.
function encoded(linear) {
  const value = Math.min(1, Math.max(0, linear));
  return 255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055);
}

function lampImage(texels, lamp) {
  const image = new ImageData(report.columns, report.rows);
  for (let texel = 0; texel < texelCount; ++texel) {
    const rgb = integrate(texels.spectra, texel, lamp.bands);
    image.data.set([encoded(rgb[0]), encoded(rgb[1]), encoded(rgb[2]), 255], 4 * texel);
  }
  return image;
}

class Relit {
  // `look(texel)` is called with the texel looked at, `pin(texel)` with one that is chosen.
  constructor(texels, look, pin) {
    this.texels = texels;
    this.look = look;
    this.pin = pin;
    this.images = new Map();
    this.texel = Math.floor(report.rows / 2) * report.columns + Math.floor(report.columns / 2);
    this.canvas = element("relit");
    this.canvas.width = report.columns;
    this.canvas.height = report.rows;
    element("marks").setAttribute("viewBox", `0 0 ${report.columns} ${report.rows}`);
    this.offerLamps();
    this.listen();
  }

  offerLamps() {
    for (const [id, wanted] of [["left-lamp", report.light], ["right-lamp", report.light === "A" ? "D65" : "A"]]) {
      for (const lamp of report.lamps) element(id).add(new Option(lamp.name, lamp.name));
      element(id).value = wanted;
      element(id).addEventListener("change", () => this.draw());
    }
    element("split").addEventListener("input", () => this.draw());
    element("show-outside").addEventListener("change", () => this.draw());
  }

  listen() {
    const picture = element("picture");
    picture.addEventListener("pointermove", (event) => this.goTo(this.texelAt(event)));
    picture.addEventListener("click", (event) => {
      this.goTo(this.texelAt(event));
      this.pin(this.texel);
    });
    picture.addEventListener("keydown", (event) => this.key(event));
  }

  texelAt(event) {
    const box = this.canvas.getBoundingClientRect();
    const along = (offset, length, count) =>
      Math.min(count - 1, Math.max(0, Math.floor((offset / length) * count)));
    return along(event.clientY - box.top, box.height, report.rows) * report.columns +
      along(event.clientX - box.left, box.width, report.columns);
  }

  key(event) {
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    if (event.key === "Enter" || event.key === " ") this.pin(this.texel);
    else if (event.key in steps) this.move(...steps[event.key], event.shiftKey ? 10 : 1);
    else return;
    event.preventDefault();
  }

  move(right, down, times) {
    const within = (value, count) => Math.min(count - 1, Math.max(0, value));
    const column = within((this.texel % report.columns) + right * times, report.columns);
    const row = within(Math.floor(this.texel / report.columns) + down * times, report.rows);
    this.goTo(row * report.columns + column);
  }

  goTo(texel) {
    this.texel = texel;
    this.look(texel);
  }

  image(name) {
    if (!this.images.has(name)) {
      this.images.set(name, lampImage(this.texels, report.lamps.find((lamp) => lamp.name === name)));
    }
    return this.images.get(name);
  }

  draw() {
    const border = Math.round((element("split").value / 100) * report.columns);
    const context = this.canvas.getContext("2d");
    context.putImageData(this.image(element("left-lamp").value), 0, 0);
    context.putImageData(this.image(element("right-lamp").value), 0, 0, border, 0,
      report.columns - border, report.rows);
    if (element("show-outside").checked) this.markOutside(context);
  }

  markOutside(context) {
    context.fillStyle = "#ff00c8";
    this.texels.marks.forEach((mark, texel) => {
      if (isOutside(mark)) context.fillRect(texel % report.columns, Math.floor(texel / report.columns), 1, 1);
    });
  }
}
