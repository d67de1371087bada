#include "bindings.h"

#include <specbake/core/color_space.h>
#include <specbake/core/measured_sample.h>
#include <specbake/core/methods.h>
#include <specbake/core/observer.h>
#include <specbake/core/wavelengths.h>
#include <specbake/version.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace py = pybind11;

namespace specbake::python {
namespace {

void addNames(py::module_& module) {
    py::tuple spaces(colorSpaces().size());
    for (std::size_t i = 0; i < colorSpaces().size(); ++i) spaces[i] = colorSpaces()[i].name;
    py::tuple names(methods().size());
    for (std::size_t i = 0; i < methods().size(); ++i) names[i] = methods()[i].name;
    module.attr("SPACES") = spaces;
    module.attr("LIGHTS") = py::tuple(py::cast(illuminantNames()));
    module.attr("METHODS") = names;
    py::tuple materials(materialNames().size());
    for (std::size_t i = 0; i < materialNames().size(); ++i) materials[i] = materialNames()[i];
    module.attr("MATERIALS") = materials;
    module.attr("WAVELENGTHS") = bandWavelengths({});
    module.attr("__version__") = kVersion;
}

}  // namespace

py::array_t<double> bandWavelengths(const Wavelengths& bands) {
    py::array_t<double> nm(bands.count);
    for (int band = 0; band < bands.count; ++band) nm.mutable_at(band) = bands.at(band);
    nm.attr("flags").attr("writeable") = false;
    return nm;
}

}  // namespace specbake::python

PYBIND11_MODULE(_specbake, module) {
    using namespace specbake::python;
    addErrors(module);
    addNames(module);
    addObserver(module);
    addTable(module);
    addUpsampler(module);
    addBaking(module);
    addSpectralImage(module);
}
