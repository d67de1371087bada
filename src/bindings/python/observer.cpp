#include "bindings.h"
#include "model_options.h"

#include <specbake/core/observer.h>

#include <pybind11/stl.h>

namespace py = pybind11;

namespace specbake::python {
namespace {

Observer made(const std::string& light, const std::optional<std::string>& quadrature,
              const std::optional<WavelengthWords>& wavelengths, const std::string& observer) {
    const Quadrature usual = wavelengths ? Quadrature::fine : Quadrature::bands;
    return Observer(lightNamed(light), quadrature ? quadratureNamed(*quadrature) : usual,
                    wavelengths ? wavelengthsOf(*wavelengths) : Wavelengths(),
                    observerNamed(observer));
}

/// Of the bands that a reader gets, which may be more than the knots between which they are linear.
py::array_t<double> weights(const Observer& observer) {
    const Wavelengths& bands = observer.bands();
    std::vector<Imath::V3d> ofBands(observer.weights().begin(), observer.weights().end());
    if (bands.knots() != bands) {
        ofBands = fineWeights(observer.illuminant(), listed(bands), observer.functions());
    }
    py::array_t<double> values({py::ssize_t(bands.count), py::ssize_t(3)});
    auto at = values.mutable_unchecked<2>();
    for (py::ssize_t band = 0; band < bands.count; ++band) {
        for (int c = 0; c < 3; ++c) at(band, c) = ofBands[std::size_t(band)][c];
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
An observer under a light, the 2-degree one of CIE 1931 unless another is named: spectra (..., 81) @
weights are colours (..., 3).)")
        .def(py::init(&made), py::arg("light") = "D65", py::kw_only(),
             py::arg("quadrature") = py::none(), py::arg("wavelengths") = py::none(),
             py::arg("observer") = "2", R"(
light: one of LIGHTS, or a file with a spectrum.
quadrature: 'bands', the sum over the 81 bands by the 5 nm table; 'fine', the integral every 1 nm
  from 360 to 830, linear between bands, folded into the weights; None: 'fine' with wavelengths,
  else 'bands'.
wavelengths: of the bands, evenly spaced: an array in nm, or '400:700:10'.
observer: '2' or '10', the CIE's of 1931 and 1964, or a file with a table: nm, x, y, z.

Raises ArgumentError, FileError.)")
        .def_property_readonly(
            "light", [](const Observer& o) { return o.illuminant(); }, "The light's name.")
        .def_property_readonly("name", &Observer::name, "Of the colour-matching functions.")
        .def_property_readonly(
            "quadrature",
            [](const Observer& o) { return std::string(quadratureName(o.quadrature())); },
            "'bands' or 'fine'.")
        .def_property_readonly(
            "wavelengths", [](const Observer& o) { return bandWavelengths(o.bands()); },
            "(N,) float64: of the bands, nm.")
        .def_property_readonly("weights", &weights, R"(
(81, 3), or (N, 3) for N wavelengths: X, Y, Z of each band at reflectance 1, the products of
colour-matching functions and light, scaled so that the perfect reflector has Y = 1.)")
        .def_property_readonly("white", &white,
                               "(3,): X, Y, Z of the perfect reflector, the sum of the weights.")
        .def("__repr__", [](const Observer& o) {
            return "<specbake.Observer: " + std::string(o.name()) + ", " + o.illuminant() + ">";
        });
}

}  // namespace specbake::python
