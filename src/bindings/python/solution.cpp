#include "solution.h"

#include <pybind11/numpy.h>

namespace py = pybind11;

namespace specbake::python {
namespace {

py::array_t<double> vector(const Imath::V3d& v) {
    py::array_t<double> values(3);
    for (int c = 0; c < 3; ++c) values.mutable_at(c) = v[c];
    return values;
}

py::array_t<double> reflectance(const SolvedColor& s) {
    py::array_t<double> values(s.bands.count);
    for (int band = 0; band < s.bands.count; ++band) {
        values.mutable_at(band) =
            valueAt(s.answer.solution.spectrum, s.bands.knots(), s.bands.at(band));
    }
    return values;
}

}  // namespace

void addSolution(py::module_& module) {
    using S = SolvedColor;
    py::class_<S>(module, "Solution", "One colour's spectrum, and how it was found.")
        .def_property_readonly("reflectance", &reflectance,
                               "(81,) float64 in [0, 1], at the model's wavelengths.")
        .def_property_readonly(
            "status", [](const S& s) { return statusName(s.answer.solution.report.status); },
            "'solved'; 'outside' where outside='error' refused it; or 'failed'.")
        .def_property_readonly(
            "asked", [](const S& s) { return vector(s.answer.asked); }, "(3,): X, Y, Z asked for.")
        .def_property_readonly(
            "given", [](const S& s) { return vector(s.answer.given); },
            "(3,): X, Y, Z that the spectrum has.")
        .def_property_readonly(
            "gauge", [](const S& s) { return s.answer.gauge; },
            "Of the colour asked for: at most 1 where a reflectance can have it.")
        .def_property_readonly(
            "outside", [](const S& s) { return s.answer.outside; },
            "Whether another colour than was asked for is given.")
        .def_property_readonly(
            "delta_e", [](const S& s) { return s.answer.difference; },
            "CIEDE2000 from the colour asked for to that given.")
        .def_property_readonly(
            "residual", [](const S& s) { return s.answer.solution.report.residual; },
            "max |W s - t| over X, Y, Z.")
        .def_property_readonly(
            "iterations", [](const S& s) { return s.answer.solution.report.iterations; },
            "Newton steps, or path segments.")
        .def("__repr__", [](const S& s) {
            const auto status = statusName(s.answer.solution.report.status);
            return "<specbake.Solution: " + std::string(status) + ", gauge " +
                   std::to_string(s.answer.gauge) + ">";
        });
}

}  // namespace specbake::python
