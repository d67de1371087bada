#include "table.h"

#include "arrays.h"
#include "bindings.h"
#include "color_array.h"
#include "runs.h"

#include <specbake/core/error.h>
#include <specbake/image/output_file.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace py = pybind11;

namespace specbake::python {
namespace {

const char* reasonOf(SpectralTable::Status status) {
    switch (status) {
        case SpectralTable::Status::ok:
            return "";
        case SpectralTable::Status::truncated:
            return "it ends too early";
        case SpectralTable::Status::notATable:
            return "no table of spectra";
        case SpectralTable::Status::otherVersion:
            return "a table of another version";
        case SpectralTable::Status::badSizes:
            return "its sizes contradict each other";
        case SpectralTable::Status::bigEndianHost:
            break;
    }
    return "tables are read by little-endian machines only";
}

/// More than the largest table: hostile files may be of any size.
constexpr std::uintmax_t kMostBytes = std::uintmax_t(8) << 30;

std::unique_ptr<Table> load(const std::filesystem::path& path) {
    const py::gil_scoped_release released;
    std::error_code missing;
    const std::uintmax_t size = std::filesystem::file_size(path, missing);
    if (missing) throw FileError(path.string(), missing.message());
    if (size > kMostBytes) throw FileError(path.string(), "larger than any table");
    std::vector<std::byte> bytes(size);
    std::ifstream stream(path, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size));
    if (!stream) throw FileError(path.string(), "cannot be read whole");
    auto table = std::make_unique<Table>(path.string(), std::move(bytes));
    if (!table->view().intact()) throw FileError(path.string(), "its checksum does not agree");
    return table;
}

void save(const Table& table, const std::filesystem::path& path) {
    const py::gil_scoped_release released;
    OutputFile file(path);
    std::ofstream stream(file.temporaryPath(), std::ios::binary);
    stream.write(reinterpret_cast<const char*>(table.bytes().data()),
                 std::streamsize(table.bytes().size()));
    stream.close();
    if (!stream) throw FileError(path.string(), "cannot be written whole");
    file.commit();
}

py::array_t<double> wavelengths(const Table& table) {
    const SpectralTableHeader& h = table.view().header();
    py::array_t<double> nm(py::ssize_t(h.bands));
    for (std::uint32_t band = 0; band < h.bands; ++band) {
        nm.mutable_at(py::ssize_t(band)) =
            double(h.firstWavelength) + band * double(h.wavelengthStep);
    }
    return nm;
}

py::dict facts(const Table& table) {
    py::dict all;
    std::istringstream lines(
        std::string(table.view().text(), std::size_t(table.view().header().textBytes)));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t equal = line.find('=');
        if (equal == std::string::npos) continue;
        all[py::str(line.substr(0, equal))] = line.substr(equal + 1);
    }
    return all;
}

py::dict errors(const Table& table) {
    const SpectralTableHeader& h = table.view().header();
    return py::dict(py::arg("mean") = h.meanError, py::arg("p99") = h.p99Error,
                    py::arg("max") = h.maxError);
}

py::array spectra(const Table& table, const py::object& asked,
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

Table::Table(const std::string& name, std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {
    const SpectralTable::Status status = view_.view(bytes_.data(), bytes_.size());
    if (status != SpectralTable::Status::ok) throw FileError(name, reasonOf(status));
}

void addTable(py::module_& module) {
    py::class_<Table>(module, "Table", R"(
Spectra over the unit cube of a linear RGB space, as renderers look them up (docs/table-format.md).
Made by Upsampler.table() or by load().)")
        .def_static("load", &load, py::arg("path"),
                    "The table in a file. Raises FileError where it is none, or damaged.")
        .def("save", &save, py::arg("path"),
             "Writes the file, NAME.spectab, whole or not at all. Raises FileError.")
        .def("spectra", &spectra, py::arg("colors"), py::kw_only(),
             py::arg("wavelengths") = py::none(), py::arg("threads") = 0, R"(
What a renderer gets, by specbake/sampler.h: reflectances (..., 81) float32 of linear RGB (..., 3),
components beyond [0, 1] counting as 0 or 1, NaN as 0; or (..., n) at n wavelengths in nm.)")
        .def_property_readonly("wavelengths", &wavelengths, "(81,) float64, nm.")
        .def_property_readonly(
            "nodes", [](const Table& t) { return t.view().header().nodes; },
            "Nodes along each axis.")
        .def_property_readonly("errors", &errors, R"(
{'mean', 'p99', 'max'}: CIEDE2000 between colours asked for and those of the 81 bands, over the
colours of the cube that a reflectance can have.)")
        .def_property_readonly("facts", &facts, "What the file says of itself, as text.")
        .def_property_readonly(
            "nbytes", [](const Table& t) { return t.bytes().size(); }, "Of the file.")
        .def("__bytes__",
             [](const Table& t) {
                 return py::bytes(reinterpret_cast<const char*>(t.bytes().data()),
                                  t.bytes().size());
             })
        .def("__repr__", [](const Table& t) {
            return "<specbake.Table: " + std::to_string(t.view().header().nodes) +
                   " nodes an axis, " + std::to_string(t.bytes().size()) + " bytes>";
        });
}

}  // namespace specbake::python
