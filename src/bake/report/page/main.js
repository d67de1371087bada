// Puts the figures onto the page.
function tell(id, words) {
  element(id).textContent = words;
}

function showHeader() {
  document.title = `${report.title}: specbake report`;
  tell("title", report.title);
  const verdict = document.createElement("strong");
  verdict.className = report.verified.passes ? "good" : "bad";
  verdict.textContent = report.verified.passes ? "It passes." : "It does not pass.";
  element("verdict").append(verdict, ` ${report.verified.says}`);
  tell("picture-says", `${report.step === 1 ? "Every texel" : `One of each ${report.step} × ${report.step} texels`} ` +
    `of ${report.texture}, lit by the two lamps, each as an eye sees it that is used to that lamp. Where the halves differ beyond ` +
    "the border, the lamp changes the colours among each other.");
}

function showFacts() {
  for (const [name, value] of report.facts) {
    const row = element("facts").insertRow();
    row.appendChild(document.createElement("th")).textContent = name;
    row.insertCell().textContent = value;
  }
}

function drawAll(texels, relit, spectra) {
  relit.draw();
  spectra.draw();
  drawMap(texels);
  drawHistogram();
  drawChromaticities(texels);
}

async function start() {
  showHeader();
  showFacts();
  const texels = await unpackTexels();
  element("figures").hidden = false;
  const spectra = new Spectra(texels);
  const relit = new Relit(texels, (texel) => spectra.look(texel), (texel) => spectra.pin(texel));
  spectra.listPins();
  drawAll(texels, relit, spectra);
  relit.goTo(relit.texel);
  let width = window.innerWidth;
  window.addEventListener("resize", () => {
    if (window.innerWidth === width) return; // phones hide and show their bars
    width = window.innerWidth;
    drawAll(texels, relit, spectra);
  });
  document.body.dataset.ready = "yes";
}

start().catch((error) => {
  element("trouble").hidden = false;
  tell("trouble", `The figures cannot be shown: ${error.message}. A browser of 2023 or later can.`);
});
