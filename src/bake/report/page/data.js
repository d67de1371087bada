// What the page shows: the report as JSON, and in it the packed texels.
const report = JSON.parse(document.getElementById("data").textContent);
const texelCount = report.columns * report.rows;
const bandCount = report.wavelengths.length;

const element = (id) => document.getElementById(id);

async function inflated(base64) {
  const packed = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Band by band, high bytes and then low bytes of what each code differs by from that of the band
// before, modulo 65536, with the sign in the last bit. A code is linear from `low` to `high`.
function unpackSpectra(bytes) {
  const spectra = new Float64Array(texelCount * bandCount);
  const codes = new Uint16Array(texelCount);
  const unit = (report.high - report.low) / 65535;
  for (let band = 0; band < bandCount; ++band) {
    const high = 2 * band * texelCount;
    for (let texel = 0; texel < texelCount; ++texel) {
      const folded = (bytes[high + texel] << 8) | bytes[high + texelCount + texel];
      codes[texel] += (folded >> 1) ^ -(folded & 1);
      spectra[texel * bandCount + band] = report.low + codes[texel] * unit;
    }
  }
  return spectra;
}

// { spectra: bandCount numbers a texel; differences: a number a texel; marks: a byte a texel }
async function unpackTexels() {
  const bytes = await inflated(report.texels);
  const after = 2 * texelCount * bandCount;
  const view = new DataView(bytes.buffer, after, 4 * texelCount);
  const differences = Float32Array.from({ length: texelCount }, (_, i) => view.getFloat32(4 * i, true));
  return { spectra: unpackSpectra(bytes), differences, marks: bytes.subarray(after + 4 * texelCount) };
}

const isOutside = (mark) => (mark & 1) !== 0;
const isNotFinite = (mark) => (mark & 2) !== 0;

// The place of a texel of the page in the file's windows, as `inspect --at` takes it.
function placeOf(texel) {
  const middle = (index, length) => Math.min(index * report.step + (report.step >> 1), length - 1);
  return {
    x: report.x + middle(texel % report.columns, report.width),
    y: report.y + middle(Math.floor(texel / report.columns), report.height),
  };
}

// Three sums over the bands of a texel; `weights` has three numbers a band.
function integrate(spectra, texel, weights) {
  const sum = [0, 0, 0];
  for (let band = 0; band < bandCount; ++band) {
    const value = spectra[texel * bandCount + band];
    for (let i = 0; i < 3; ++i) sum[i] += value * weights[3 * band + i];
  }
  return sum;
}
