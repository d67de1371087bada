#include "arrays.h"
#include "bindings.h"
#include "image_array.h"
#include "model_options.h"
#include "runs.h"

#include <specbake/bake/bake.h>
#include <specbake/bake/relight.h>
#include <specbake/bake/verify.h>
#include <specbake/core/error.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <utility>

namespace py = pybind11;

namespace specbake::python {
namespace {

using Path = std::filesystem::path;

Compression compressionNamed(const std::string& name) {
    const auto all = compressions();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](Compression c) { return compressionName(c) == name; });
    if (found == all.end()) throw ArgumentError("unknown compression '" + name + "'");
    return *found;
}

/// What of a file is read: the three keyword arguments that bake() and verify() share.
ReadOptions readOptions(const std::vector<std::string>& channels, const py::object& part,
                        bool orient) {
    ReadOptions read;
    read.channels = channels;
    if (!part.is_none()) read.part = std::string(py::str(part));
    read.orient = orient;
    return read;
}

std::optional<std::string> textOf(const std::optional<Path>& path) {
    if (!path) return {};
    return path->string();
}

BakeStatistics bakeIt(const py::object& source, const Path& output, const BakeOptions& options,
                      const py::object& progress) {
    BakeStatistics statistics;
    BakeOptions watched = options;
    const auto run = [&](const auto& input) {
        runInterruptibly(
            [&](const Watch& watch) {
                watched.stop = watch.stop;
                watched.progress = watch.progress;
                statistics = input(watched);
            },
            progress);
    };
    if (py::isinstance<py::array>(source)) {
        if (!options.read.channels.empty() || options.read.part || options.read.orient) {
            throw ArgumentError("channels, part and orient are for files, not for arrays");
        }
        const ImageArray image(py::reinterpret_borrow<py::array>(source),
                               options.color.config ? std::nullopt : options.color.space);
        run([&](const BakeOptions& o) {
            MemoryTexture texture(image.image());
            return bake(texture, output, o);
        });
    } else {
        const auto path = py::module_::import("os").attr("fspath")(source).cast<std::string>();
        run([&](const BakeOptions& o) { return bake(path, output, o); });
    }
    return statistics;
}

BakeStatistics bakeWithArguments(
    const py::object& source, const Path& output, const std::optional<std::string>& space,
    const std::optional<std::string>& light, const std::optional<std::string>& method,
    const std::string& outside, std::optional<int> grid, const std::optional<std::string>& material,
    const std::optional<Path>& samples, std::optional<double> maxDeviation, int bits,
    std::optional<double> maxDE, const py::object& dtype, const std::string& compression, int level,
    std::optional<std::pair<int, int>> tile, bool mipmap, const std::vector<std::string>& channels,
    const py::object& part, bool orient, int threads, const py::object& progress,
    const std::string& adapt, const std::optional<std::string>& quadrature,
    const std::optional<WavelengthWords>& wavelengths, const std::string& observer,
    const std::optional<Path>& colorconfig) {
    BakeOptions options;
    options.read = readOptions(channels, part, orient);
    options.color.space = space;
    options.color.config = textOf(colorconfig);
    options.model = modelOptions({light, adapt, method, outside, grid, material, samples,
                                  quadrature, wavelengths, observer});
    options.maxDeviation = maxDeviation;
    options.bits = bits;
    options.maxDE = maxDE;
    options.storage.sampleType = sampleTypeOf(dtype);
    options.storage.compression = compressionNamed(compression);
    options.storage.level = level;
    if (tile) options.storage.tile = TileSize{tile->first, tile->second};
    options.storage.mipmap = mipmap;
    options.threads = threadsHere(threads);
    return bakeIt(source, output, options, progress);
}

void relightWithArguments(const Path& spectral, const Path& picture, const std::string& light,
                          bool adapt, double exposure, int threads, const py::object& progress,
                          const std::optional<std::string>& quadrature,
                          const std::optional<std::string>& observer) {
    RelightOptions options;
    options.illuminant = lightNamed(light);
    if (observer) options.observer = observerNamed(*observer);
    options.adapt = adapt ? Adaptation::bradford : Adaptation::none;
    options.exposure = exposure;
    if (quadrature) options.quadrature = quadratureNamed(*quadrature);
    options.threads = threadsHere(threads);
    runInterruptibly(
        [&](const Watch& watch) {
            options.stop = watch.stop;
            options.progress = watch.progress;
            relight(spectral.string(), picture, options);
        },
        progress);
}

Verification verifyWithArguments(
    const Path& spectral, const Path& texture, const std::optional<std::string>& space,
    const std::optional<std::string>& light, const std::vector<std::string>& channels,
    const py::object& part, bool orient, int threads, const std::optional<std::string>& quadrature,
    const std::optional<std::string>& observer, const std::optional<Path>& colorconfig) {
    VerifyOptions options;
    options.color.space = space;
    options.color.config = textOf(colorconfig);
    if (light) options.illuminant = lightNamed(*light);
    if (observer) options.observer = observerNamed(*observer);
    if (quadrature) options.quadrature = quadratureNamed(*quadrature);
    options.threads = threadsHere(threads);
    options.read = readOptions(channels, part, orient);
    Verification verification;
    runInterruptibly(
        [&](const Watch&) { verification = verify(spectral.string(), texture.string(), options); });
    return verification;
}

void addStatistics(py::module_& module) {
    using S = BakeStatistics;
    py::class_<S>(module, "BakeStatistics", "What a bake did.")
        .def_readonly("space", &S::space, "The space in which the texture was taken.")
        .def_readonly("light", &S::illuminant, "The light under which its colours hold.")
        .def_readonly("texels", &S::texels)
        .def_readonly("grid", &S::grid, "Nodes an axis; 0 without a grid.")
        .def_readonly("bits", &S::bits, "Of the samples' mantissa.")
        .def_readonly("direct_texels", &S::directTexels, "Not, or not only, through the grid.")
        .def_readonly("outside_texels", &S::outsideTexels, "Whose colour no reflectance has.")
        .def_readonly("largest_move", &S::largestMove,
                      "Of these: CIEDE2000 from the colour asked for to that given.")
        .def_readonly("deviation", &S::deviation, "What max_deviation met, or None.")
        .def_readonly("delta_e", &S::difference, "What max_de met, or None.")
        .def_readonly("seconds", &S::seconds)
        .def_readonly("notes", &S::notes, "What of the texture's file was not used.");
}

void addVerification(py::module_& module) {
    using V = Verification;
    py::class_<V>(module, "Verification", "How far a spectral image is from its texture.")
        .def_readonly("texels", &V::texels)
        .def_readonly("mean", &V::meanDE2000, "CIEDE2000 over the texels.")
        .def_readonly("p99", &V::p99DE2000, "Its 99th percentile.")
        .def_readonly("max", &V::maxDE2000)
        .def_readonly("max_xyz", &V::maxXYZDifference, "The largest |dX|, |dY|, |dZ|.")
        .def_readonly("beyond_rounding", &V::beyondRounding,
                      "Texels that the rounding of the samples does not explain.")
        .def_readonly("not_finite", &V::notFinite, "Texels with a number that is not finite.")
        .def_readonly("out_of_range", &V::outOfRange, "Bands outside [0, 1].")
        .def_readonly("outside_solid", &V::outsideSolid, "Texels whose colour no reflectance has.")
        .def_readonly("light", &V::illuminant, "Under which was compared.")
        .def_readonly("observer", &V::observer,
                      "By whom: the name of the colour-matching functions.")
        .def_property_readonly(
            "quadrature", [](const V& v) { return std::string(quadratureName(v.quadrature)); },
            "'bands' or 'fine', by which was compared.")
        .def("passes", &V::passes, py::arg("max_de") = py::none(),
             "Whether all numbers are right, and no texel is off by more than max_de (CIEDE2000), "
             "or without it by more than rounding explains.");
}

}  // namespace

void addBaking(py::module_& module) {
    addStatistics(module);
    addVerification(module);
    const BakeOptions b;
    const StorageOptions& s = b.storage;
    const RelightOptions r;
    module.def("bake", &bakeWithArguments, py::arg("source"), py::arg("output"), py::kw_only(),
               py::arg("space") = b.color.space, py::arg("light") = b.model.illuminant,
               py::arg("method") = py::none(),
               py::arg("outside") = std::string(outsideName(b.model.outside)),
               py::arg("grid") = b.model.grid, py::arg("material") = b.model.material,
               py::arg("samples") = py::none(), py::arg("max_deviation") = b.maxDeviation,
               py::arg("bits") = b.bits, py::arg("max_de") = b.maxDE, py::arg("dtype") = "float16",
               py::arg("compression") = std::string(compressionName(s.compression)),
               py::arg("level") = s.level, py::arg("tile") = py::none(),
               py::arg("mipmap") = s.mipmap, py::arg("channels") = py::tuple(),
               py::arg("part") = py::none(), py::arg("orient") = b.read.orient,
               py::arg("threads") = b.threads, py::arg("progress") = py::none(),
               py::arg("adapt") = std::string(adaptationName(b.model.adapt)),
               py::arg("quadrature") = py::none(), py::arg("wavelengths") = py::none(),
               py::arg("observer") = "2", py::arg("colorconfig") = py::none(), R"(
A texture to a spectral EXR, as `specbake bake` does it; the file appears whole or not at all.

source: a file that OpenImageIO reads, or an array (height, width), (height, width, n) with n = 1
  (grey), 2 (grey and alpha), 3 or 4 (the last one alpha, straight), of uint8, uint16, float16 or
  float32; it is not copied. Integers are shares of the largest.
output: the spectral image, NAME.exr.
space: of SPACES, what the source's numbers are; None: what a file says; for an array srgb if it is
  of integers, else lin_rec709.
colorconfig: a configuration of OpenColorIO, a file, whose spaces and roles space may name too, and
  whose file rules say what a file's numbers are where space is None. $OCIO is not looked at.
light, method, outside, grid, material, samples, adapt, quadrature, wavelengths, observer: as of
  Upsampler.
max_deviation: instead of grid, the coarsest one whose spectra deviate by no more from those that
  are solved one by one (RMS).
dtype, compression ('zip', 'zips', 'piz', 'none'), level, tile (width, height), mipmap: how the file
  is stored.
bits: of a half's mantissa. max_de: instead, the fewest that keep within this CIEDE2000.
channels, part, orient: what is read of a file, and whether it is turned as it says.
threads: 0 for all cores. progress: called with 0 to 1. Ctrl-C stops it.

Returns BakeStatistics. Raises FileError, ArgumentError.)");
    module.def("relight", &relightWithArguments, py::arg("spectral"), py::arg("picture"),
               py::kw_only(), py::arg("light") = r.illuminant,
               py::arg("adapt") = r.adapt != Adaptation::none, py::arg("exposure") = r.exposure,
               py::arg("threads") = r.threads, py::arg("progress") = py::none(),
               py::arg("quadrature") = py::none(), py::arg("observer") = py::none(), R"(
The spectral image as it looks under a light, to a picture: linear Rec.709 for EXR and HDR, 8-bit
sRGB for other formats.

light: of LIGHTS, or a file with a spectrum.
adapt: the viewer's eye has adapted, so that white looks white.
exposure: stops; at 0 a white surface's largest component is 1.
quadrature: 'bands' or 'fine', how the bands are integrated; observer: '2', '10' or a file with a
  table, whose eye it is; None: as the file says.

Raises FileError, ArgumentError.)");
    module.def("verify", &verifyWithArguments, py::arg("spectral"), py::arg("texture"),
               py::kw_only(), py::arg("space") = py::none(), py::arg("light") = py::none(),
               py::arg("channels") = py::tuple(), py::arg("part") = py::none(),
               py::arg("orient") = false, py::arg("threads") = 0,
               py::arg("quadrature") = py::none(), py::arg("observer") = py::none(),
               py::arg("colorconfig") = py::none(), R"(
Reads a spectral image back, integrates it under its light and compares it with its texture. What is
left out is as the spectral file says. Returns a Verification. Raises FileError, ArgumentError.)");
}

}  // namespace specbake::python
