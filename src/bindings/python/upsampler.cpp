#include "arrays.h"
#include "bindings.h"
#include "color_array.h"
#include "model_options.h"
#include "runs.h"
#include "solution.h"

#include <specbake/core/error.h>
#include <specbake/core/table.h>
#include <specbake/image/table_file.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <tbb/enumerable_thread_specific.h>

#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

namespace py = pybind11;

namespace specbake::python {
namespace {

Upsampler made(const std::string& space, const std::optional<std::string>& light,
               const std::optional<std::string>& method, const std::string& outside,
               std::optional<int> grid, const std::optional<std::string>& material,
               const std::optional<std::filesystem::path>& samples, const std::string& adapt,
               const std::optional<std::string>& quadrature,
               const std::optional<WavelengthWords>& wavelengths, const std::string& observer) {
    return Upsampler(colorSpaceNamed(space),
                     modelOptions({light, adapt, method, outside, grid, material, samples,
                                   quadrature, wavelengths, observer}));
}

enum class Invalid { raise, nan };

Invalid invalidRule(const std::string& name) {
    if (name == "raise") return Invalid::raise;
    if (name == "nan") return Invalid::nan;
    throw ArgumentError("invalid is 'raise' or 'nan', not '" + name + "'");
}

void raise(const ColorArray& colors, const ColorCensus& census) {
    const std::pair<Fate, const char*> reasons[] = {
        {Fate::notFinite, " is not a finite number"},
        {Fate::refused, " is one that no reflectance has"},
        {Fate::failed, " was not solved"}};
    for (const auto& [fate, what] : reasons) {
        const ColorCensus::Kind& kind = census.of(fate);
        if (kind.first) {
            throw ArgumentError(colors.nameOf(*kind.first) + what + "; " +
                                std::to_string(kind.count) + " such in all");
        }
    }
}

/// What spectra() is asked, apart from the colours.
struct Sampling {
    const Upsampler& model;
    SampleSelection wanted;
    SampleType type;
    Invalid invalid;
};

void fillWithNaN(const SampleTarget& target, std::size_t count) {
    const std::vector<float> none(count, std::numeric_limits<float>::quiet_NaN());
    storeSamples(none, target.type, target.to);
}

/// A run of which some colours have no spectrum: one by one, those become NaN.
void markInvalid(const Sampling& s, std::span<const Upsampler::Color> colors, SampleTarget target,
                 Upsampler::Workspace& workspace) {
    for (const Upsampler::Color& color : colors) {
        const ColorCensus one = s.model.sample({&color, 1}, s.wanted, target, workspace);
        if (one.withoutSpectrum() > 0) fillWithNaN(target, s.wanted.count());
        target.to += target.perColor;
    }
}

ColorCensus sampleAll(const Sampling& s, const ColorArray& colors, std::byte* to, int threads) {
    struct Buffers {
        std::vector<Upsampler::Color> colors;
        Upsampler::Workspace workspace;
    };
    tbb::enumerable_thread_specific<Buffers> buffers;
    std::mutex mutex;
    ColorCensus total;
    const std::size_t run = s.model.options().grid ? kRun : 16;  // solved one by one: 10 ms each
    forEachRunInterruptibly(
        colors.count(), run, threads, [&](std::size_t first, std::size_t count) {
            Buffers& own = buffers.local();
            SampleTarget target = SampleTarget::interleaved(s.type, to, s.wanted);
            target.to += first * target.perColor;
            const auto linear = colors.run(first, count, own.colors);
            const ColorCensus census = s.model.sample(linear, s.wanted, target, own.workspace);
            if (census.withoutSpectrum() > 0 && s.invalid == Invalid::nan) {
                markInvalid(s, linear, target, own.workspace);
            }
            const std::scoped_lock lock(mutex);
            total.add(census, first);
        });
    return total;
}

py::array spectra(const Upsampler& model, const py::object& asked,
                  const std::optional<std::vector<double>>& wavelengths, const py::object& dtype,
                  const py::object& out, const std::string& invalid, int threads) {
    const ColorArray colors(asked, model.space());
    const Wavelengths& bands = model.options().bands;
    const Sampling sampling{
        model,
        wavelengths ? SampleSelection::at(*wavelengths, bands) : SampleSelection::bands(bands),
        sampleTypeOf(dtype), invalidRule(invalid)};
    Shape shape = colors.shape();
    shape.push_back(py::ssize_t(sampling.wanted.count()));
    py::array samples = outputArray(shape, sampling.type, out);
    auto* to = static_cast<std::byte*>(samples.mutable_data());
    const ColorCensus census = sampleAll(sampling, colors, to, threads);
    if (sampling.invalid == Invalid::raise) raise(colors, census);
    return samples;
}

py::array_t<double> xyz(const Upsampler& model, const py::object& asked) {
    const ColorArray colors(asked, model.space());
    Shape shape = colors.shape();
    shape.push_back(3);
    py::array_t<double> values(shape);
    double* to = values.mutable_data();
    forEachRunInterruptibly(colors.count(), kRun, 0, [&](std::size_t first, std::size_t count) {
        std::vector<Upsampler::Color> buffer;
        double* next = to + 3 * first;
        for (const Upsampler::Color& color : colors.run(first, count, buffer)) {
            const XYZ value = model.xyz(color);
            for (int c = 0; c < 3; ++c) *next++ = value[c];
        }
    });
    return values;
}

/// The tristimulus of a colour in double precision, as `specbake solve` takes it.
XYZ askedColor(const Upsampler& model, const std::vector<double>& color) {
    if (color.size() != 3) throw ArgumentError("a colour has three components");
    RGB linear;
    for (int c = 0; c < 3; ++c) {
        linear[c] = linearFrom(color[std::size_t(c)], model.space().transfer);
    }
    return model.xyz(linear);
}

SolvedColor solve(const Upsampler& model, const std::optional<std::vector<double>>& color,
                  const std::optional<std::array<double, 3>>& xyz) {
    if (color.has_value() == xyz.has_value()) {
        throw ArgumentError("solve takes a colour of the space, or xyz=");
    }
    const XYZ asked = xyz ? XYZ((*xyz)[0], (*xyz)[1], (*xyz)[2]) : askedColor(model, *color);
    if (!std::isfinite(asked.x) || !std::isfinite(asked.y) || !std::isfinite(asked.z)) {
        throw ArgumentError("a colour of finite numbers is wanted");
    }
    const py::gil_scoped_release released;
    return {model.solve(asked), model.options().bands};
}

std::unique_ptr<TableFile> table(const Upsampler& model) {
    SpectralTableFile file;
    runInterruptibly([&](const Watch&) { file = spectralTable(model); });
    return std::make_unique<TableFile>("table", std::move(file.bytes));
}

}  // namespace

void addUpsampler(py::module_& module) {
    addSolution(module);
    const UpsamplerOptions defaults;
    py::class_<Upsampler>(module, "Upsampler", R"(
A model: colours of one space to reflectance spectra under one light.

Each spectrum has exactly the colour under the light, by the sum over the 81 bands or by the fine
quadrature; it stays within [0, 1], and is continuous in the colour. Any number of threads may share
a model.

Colours are arrays (..., 3) of what a texture in the space stores: encoded components for 'srgb',
linear ones for 'lin_rec709', 'acescg' and so on, X, Y, Z (perfect reflector: Y = 1) for 'xyz'.
uint8 and uint16 are shares of 255 and 65535; all else counts as it is, in single precision.)")
        .def(py::init(&made), py::arg("space") = "lin_rec709", py::kw_only(),
             py::arg("light") = py::none(), py::arg("method") = py::none(),
             py::arg("outside") = std::string(outsideName(defaults.outside)),
             py::arg("grid") = defaults.grid, py::arg("material") = defaults.material,
             py::arg("samples") = py::none(),
             py::arg("adapt") = std::string(adaptationName(defaults.adapt)),
             py::arg("quadrature") = py::none(), py::arg("wavelengths") = py::none(),
             py::arg("observer") = "2", R"(
space: one of SPACES.
light: one of LIGHTS, or a file with a spectrum, under which the colours hold; None: the space's own
  white.
method: one of METHODS; None: 'natural'.
outside: what a colour gets that no reflectance has: 'nearest', 'scale' or 'error'.
grid: nodes along each axis of the lookup, 2 to 129; None: each colour is solved by itself.
material: one of MATERIALS: near the colours of its samples, spectra are that material's.
samples: a file of measured reflectances, which spectra are at and near the samples' colours.
adapt: how colours are adapted to a light that is not the space's white: 'bradford', 'cat16' or
  'none'.
quadrature: the reader for whom colours are exact: 'bands', one who sums the 81 bands, or 'fine',
  one who integrates every 1 nm from 360 to 830, linear between bands, as renderers do; None: 'fine'
  with wavelengths, else 'bands'.
wavelengths: of the bands, evenly spaced within 360 to 830 nm: an array, or '400:700:10'.
observer: who sees the colours so: '2' or '10', or a file with a table, as of Observer.

Raises ArgumentError, FileError.)")
        .def("spectra", &spectra, py::arg("colors"), py::kw_only(),
             py::arg("wavelengths") = py::none(), py::arg("dtype") = "float32",
             py::arg("out") = py::none(), py::arg("invalid") = "raise", py::arg("threads") = 0, R"(
Reflectances (..., 81) of colours (..., 3), at the model's wavelengths: 380 to 780 nm every 5 nm,
unless it was made with others.

wavelengths: reflectances at these instead, in nm, linear between bands: (..., n).
dtype: 'float32' or 'float16'.
out: an array to write into, C-contiguous, of that shape and dtype.
invalid: what a colour gets that has no spectrum (not finite; or refused, with outside='error'):
  'raise', an ArgumentError that names the first; 'nan', a spectrum of NaN.
threads: 0 for all cores. The result does not depend on it.

A C-contiguous array of float32 in a linear space is not copied. The GIL is released, and Ctrl-C
stops it.)")
        .def("xyz", &xyz, py::arg("colors"), R"(
What is asked for: tristimulus values (..., 3), float64, of colours (..., 3). The perfect reflector
has Y = 1. Within the object-colour solid the spectra have these colours.)")
        .def("solve", &solve, py::arg("color") = py::none(), py::kw_only(),
             py::arg("xyz") = py::none(), R"(
One colour (3,) of the space, or xyz=(X, Y, Z), in double precision: solved by itself, not through
the grid. Returns a Solution; raises ArgumentError for numbers that are not finite.)")
        .def("table", &table, R"(
The model as a Table, which renderers look spectra up in. Raises ArgumentError for a model without a
grid, and for 'xyz'.)")
        .def_property_readonly(
            "space", [](const Upsampler& u) { return u.space().name; }, "The colour space's name.")
        .def_property_readonly(
            "light", [](const Upsampler& u) { return u.observer().illuminant(); },
            "The light's name.")
        .def_property_readonly(
            "method", [](const Upsampler& u) { return u.options().method; }, "The method's name.")
        .def_property_readonly(
            "outside",
            [](const Upsampler& u) { return std::string(outsideName(u.options().outside)); },
            "The rule for colours that no reflectance has.")
        .def_property_readonly(
            "grid", [](const Upsampler& u) { return u.options().grid; },
            "Nodes along each axis of the lookup, or None.")
        .def_property_readonly(
            "observer", [](const Upsampler& u) { return u.observer(); },
            "The Observer under the model's light.")
        .def_property_readonly(
            "quadrature",
            [](const Upsampler& u) { return std::string(quadratureName(u.options().quadrature)); },
            "The reader for whom colours are exact: 'bands' or 'fine'.")
        .def_property_readonly(
            "wavelengths", [](const Upsampler& u) { return bandWavelengths(u.options().bands); },
            "(N,) float64: of the bands, nm.")
        .def_property_readonly("notes", &Upsampler::notes,
                               "What is to be told of the samples, a line each.")
        .def_property_readonly("identity", &Upsampler::identity,
                               "All that the spectra depend on, as one line of text.")
        .def("__repr__",
             [](const Upsampler& u) { return "<specbake.Upsampler: " + u.identity() + ">"; });
}

}  // namespace specbake::python
