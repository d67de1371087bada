#include "arrays.h"
#include "bindings.h"
#include "interruptible.h"

#include <specbake/core/error.h>
#include <specbake/image/spectral_reader.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace py = pybind11;

namespace specbake::python {
namespace {

/// A spectral image in memory.
struct SpectralImage {
    py::array spectra;
    py::array wavelengths;
    py::object alpha = py::none();
    py::object preview = py::none();
    Window data, display;
    py::dict attributes;
    std::string storedType;
};

/// Numbers as such where the reader keeps them, all else as text.
py::dict attributesOf(SpectralReader& reader) {
    py::dict all;
    for (const auto& [name, text] : reader.facts().attributes) all[py::str(name)] = text;
    for (const auto& [name, value] : reader.header().attributes) {
        all[py::str(name)] = std::visit([](const auto& v) { return py::cast(v); }, value);
    }
    return all;
}

std::pair<int, int> checkedRows(const std::optional<std::pair<int, int>>& rows, int height) {
    if (!rows) return {0, height};
    if (rows->first < 0 || rows->second > height || rows->first >= rows->second) {
        throw ArgumentError("rows are (first, end) of 0 to " + std::to_string(height));
    }
    return *rows;
}

std::span<float> valuesOf(py::object& array) {
    if (array.is_none()) return {};
    auto values = py::reinterpret_borrow<py::array_t<float>>(array);
    return {values.mutable_data(), std::size_t(values.size())};
}

SpectralImage readSpectral(const std::filesystem::path& path,
                           const std::optional<std::pair<int, int>>& asked) {
    std::optional<SpectralReader> opened;
    runInterruptibly([&](const Watch&) { opened.emplace(path.string()); });
    SpectralReader& reader = *opened;
    const SpectralHeader& header = reader.header();
    const auto [first, end] = checkedRows(asked, header.data.height);
    const py::ssize_t rows = end - first;
    const py::ssize_t width = header.data.width;
    SpectralImage image;
    image.spectra = py::array_t<float>({rows, width, py::ssize_t(reader.wavelengths().size())});
    image.wavelengths =
        py::array_t<double>(py::ssize_t(reader.wavelengths().size()), reader.wavelengths().data());
    if (header.alpha) image.alpha = py::array_t<float>({rows, width});
    if (reader.hasPreview()) image.preview = py::array_t<float>({rows, width, py::ssize_t(3)});
    image.data = header.data;
    image.data.y += first;
    image.data.height = int(rows);
    image.display = header.display;
    image.attributes = attributesOf(reader);
    image.storedType = reader.storedType() == TexelType::half ? "float16" : "float32";
    py::object all = image.spectra;
    const std::span<float> samples = valuesOf(all);
    const std::span<float> alpha = valuesOf(image.alpha);
    const std::span<float> preview = valuesOf(image.preview);
    runInterruptibly([&, from = first, to = end](const Watch& watch) {
        constexpr int atATime = 64;
        const auto side = std::size_t(width);
        const std::size_t bands = reader.wavelengths().size();
        for (int row = from; row < to; row += atATime) {
            if (watch.stop.stop_requested()) throw Cancelled();
            const int count = std::min(atATime, to - row);
            const std::size_t texels = side * std::size_t(count);
            const std::size_t before = side * std::size_t(row - from);
            reader.readRows(row, count, samples.subspan(before * bands, texels * bands),
                            alpha.empty() ? alpha : alpha.subspan(before, texels),
                            preview.empty() ? preview : preview.subspan(before * 3, texels * 3));
        }
    });
    return image;
}

py::tuple windowTuple(const Window& w) {
    return py::make_tuple(w.x, w.y, w.width, w.height);
}

py::object attribute(const SpectralImage& image, const char* name) {
    return image.attributes.contains(name) ? py::object(image.attributes[name]) : py::none();
}

}  // namespace

void addSpectralImage(py::module_& module) {
    using I = SpectralImage;
    py::class_<I>(module, "SpectralImage", "A spectral image, read by read_spectral().")
        .def_readonly("spectra", &I::spectra,
                      "(height, width, N) float32: reflectances at `wavelengths`.")
        .def_readonly("wavelengths", &I::wavelengths,
                      "(N,) float64: nm, ascending; WAVELENGTHS unless the file has other bands.")
        .def_readonly("alpha", &I::alpha, "(height, width) float32, or None.")
        .def_readonly("preview", &I::preview,
                      "(height, width, 3) float32: linear sRGB under D65, or None.")
        .def_property_readonly(
            "data_window", [](const I& i) { return windowTuple(i.data); },
            "x, y, width, height of the rows that were read.")
        .def_property_readonly(
            "display_window", [](const I& i) { return windowTuple(i.display); },
            "x, y, width, height of what is meant to be seen.")
        .def_readonly("attributes", &I::attributes, "The file's metadata, a dict.")
        .def_readonly("stored_dtype", &I::storedType, "'float16' or 'float32'.")
        .def_property_readonly(
            "light", [](const I& i) { return attribute(i, "specbake:illuminant"); },
            "The light under which the spectra have the texture's colours, if the file names it.")
        .def("__repr__", [](const I& i) {
            return "<specbake.SpectralImage: " + std::string(py::str(i.spectra.attr("shape"))) +
                   ">";
        });
    module.def("read_spectral", &readSpectral, py::arg("path"), py::kw_only(),
               py::arg("rows") = py::none(), R"(
Reads a spectral EXR of reflectance bands, whatever their wavelengths: a SpectralImage.

rows: (first, end), counted from 0 at the data window's top; None: all. A texel takes 4 bytes a
band, 324 for 81 bands.
Raises FileError, ArgumentError. The GIL is released.)");
}

}  // namespace specbake::python
