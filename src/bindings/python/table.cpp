#include "arrays.h"
#include "bindings.h"
#include "color_array.h"
#include "runs.h"

#include <specbake/core/error.h>
#include <specbake/image/output_file.h>
#include <specbake/image/table_file.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <memory>

namespace py = pybind11;

namespace specbake::python {
namespace {

std::unique_ptr<TableFile> load(const std::filesystem::path& path) {
    const py::gil_scoped_release released;
    return std::make_unique<TableFile>(TableFile::read(path));
}

void save(const TableFile& table, const std::filesystem::path& path) {
    const py::gil_scoped_release released;
    const auto& bytes = table.bytes();
    writeWhole(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

py::dict facts(const TableFile& table) {
    py::dict all;
    for (const auto& [name, value] : table.facts()) all[py::str(name)] = value;
    return all;
}

py::dict errors(const TableFile& table) {
    const SpectralTableHeader& h = table.view().header();
    return py::dict(py::arg("mean") = h.meanError, py::arg("p99") = h.p99Error,
                    py::arg("max") = h.maxError);
}

py::array spectra(const TableFile& table, const py::object& asked,
                  const std::optional<std::vector<float>>& wavelengths, int threads) {
    const SpectralTable& view = table.view();
    const ColorArray colors(asked, colorSpaceNamed("lin_rec709"));  // any linear space
    std::vector<SpectralTable::Wavelengths<1>> at;
    for (const float nm : wavelengths.value_or(std::vector<float>())) {
        at.push_back(view.wavelengths<1>({nm}));
    }
    const std::size_t samples = wavelengths ? at.size() : view.header().bands;
    Shape shape = colors.shape();
    shape.push_back(py::ssize_t(samples));
    py::array values = outputArray(shape, SampleType::float32, py::none());
    auto* to = static_cast<float*>(values.mutable_data());
    forEachRunInterruptibly(
        colors.count(), kRun, threads, [&](std::size_t first, std::size_t count) {
            std::vector<ColorArray::Color> buffer;
            float* next = to + first * samples;
            for (const ColorArray::Color& c : colors.run(first, count, buffer)) {
                const SpectralTable::Place place = view.locate(c[0], c[1], c[2]);
                if (!wavelengths) view.evalBands(place, next);
                for (std::size_t i = 0; i < at.size(); ++i) view.eval(place, at[i], next + i);
                next += samples;
            }
        });
    return values;
}

}  // namespace

void addTable(py::module_& module) {
    py::class_<TableFile>(module, "Table", R"(
Spectra over the unit cube of a linear RGB space, as renderers look them up (docs/table-format.md).
Made by Upsampler.table() or by load().)")
        .def_static("load", &load, py::arg("path"),
                    "The table in a file. Raises FileError where it is none, or damaged.")
        .def("save", &save, py::arg("path"),
             "Writes the file, NAME.spectab, whole or not at all. Raises FileError.")
        .def("spectra", &spectra, py::arg("colors"), py::kw_only(),
             py::arg("wavelengths") = py::none(), py::arg("threads") = 0, R"(
What a renderer gets, by specbake/sampler.h: reflectances (..., N) float32 of linear RGB (..., 3),
components beyond [0, 1] counting as 0 or 1, NaN as 0; or (..., n) at n wavelengths in nm.)")
        .def_property_readonly(
            "wavelengths", [](const TableFile& t) { return bandWavelengths(t.bands()); },
            "(N,) float64: of the bands, nm.")
        .def_property_readonly(
            "nodes", [](const TableFile& t) { return t.view().header().nodes; },
            "Nodes along each axis.")
        .def_property_readonly("errors", &errors, R"(
{'mean', 'p99', 'max'}: CIEDE2000 between colours asked for and those of the 81 bands, over the
colours of the cube that a reflectance can have.)")
        .def_property_readonly("facts", &facts, "What the file says of itself, as text.")
        .def_property_readonly(
            "nbytes", [](const TableFile& t) { return t.bytes().size(); }, "Of the file.")
        .def("__bytes__",
             [](const TableFile& t) {
                 return py::bytes(reinterpret_cast<const char*>(t.bytes().data()),
                                  t.bytes().size());
             })
        .def("__repr__", [](const TableFile& t) {
            return "<specbake.Table: " + std::to_string(t.view().header().nodes) +
                   " nodes an axis, " + std::to_string(t.bytes().size()) + " bytes>";
        });
}

}  // namespace specbake::python
