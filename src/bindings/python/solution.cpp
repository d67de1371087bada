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

}  // namespace

void addSolution(py::module_& module) {
    using A = ColorAnswer;
    py::class_<A>(module, "Solution", "One colour's spectrum, and how it was found.")
        .def_property_readonly(
            "reflectance",
            [](const A& a) { return py::array_t<double>(kBandCount, a.solution.spectrum.data()); },
            "(81,) float64 in [0, 1], at WAVELENGTHS.")
        .def_property_readonly(
            "status", [](const A& a) { return statusName(a.solution.report.status); },
            "'solved'; 'outside' where outside='error' refused it; or 'failed'.")
        .def_property_readonly(
            "asked", [](const A& a) { return vector(a.asked); }, "(3,): X, Y, Z asked for.")
        .def_property_readonly(
            "given", [](const A& a) { return vector(a.given); },
            "(3,): X, Y, Z that the spectrum has.")
        .def_readonly("gauge", &A::gauge,
                      "Of the colour asked for: at most 1 where a reflectance can have it.")
        .def_readonly("outside", &A::outside, "Whether another colour than was asked for is given.")
        .def_readonly("delta_e", &A::difference,
                      "CIEDE2000 from the colour asked for to that given.")
        .def_property_readonly(
            "residual", [](const A& a) { return a.solution.report.residual; },
            "max |W s - t| over X, Y, Z.")
        .def_property_readonly(
            "iterations", [](const A& a) { return a.solution.report.iterations; },
            "Newton steps, or path segments.")
        .def("__repr__", [](const A& a) {
            const auto status = statusName(a.solution.report.status);
            return "<specbake.Solution: " + std::string(status) + ", gauge " +
                   std::to_string(a.gauge) + ">";
        });
}

}  // namespace specbake::python
