#include "bindings.h"

#include <specbake/core/observer.h>

#include <pybind11/numpy.h>

namespace py = pybind11;

namespace specbake::python {
namespace {

py::array_t<double> weights(const Observer& observer) {
    py::array_t<double> values({py::ssize_t(kBandCount), py::ssize_t(3)});
    auto at = values.mutable_unchecked<2>();
    for (py::ssize_t band = 0; band < kBandCount; ++band) {
        for (int c = 0; c < 3; ++c) at(band, c) = observer.weights()[std::size_t(band)][c];
    }
    return values;
}

py::array_t<double> white(const Observer& observer) {
    py::array_t<double> values(3);
    for (int c = 0; c < 3; ++c) values.mutable_at(c) = observer.white()[c];
    return values;
}

}  // namespace

void addObserver(py::module_& module) {
    py::class_<Observer>(module, "Observer", R"(
The CIE 1931 2-degree observer under a light: spectra (..., 81) @ weights are colours (..., 3).)")
        .def(py::init<std::string_view>(), py::arg("light") = "D65",
             "light: one of LIGHTS. Raises ArgumentError.")
        .def_property_readonly(
            "light", [](const Observer& o) { return o.illuminant(); }, "The light's name.")
        .def_property_readonly("name", &Observer::name, "Of the colour-matching functions.")
        .def_property_readonly("weights", &weights, R"(
(81, 3): X, Y, Z of each band at reflectance 1, the products of colour-matching functions and light,
scaled so that the perfect reflector has Y = 1.)")
        .def_property_readonly("white", &white,
                               "(3,): X, Y, Z of the perfect reflector, the sum of the weights.")
        .def("__repr__", [](const Observer& o) {
            return "<specbake.Observer: " + std::string(o.name()) + ", " + o.illuminant() + ">";
        });
}

}  // namespace specbake::python
