#pragma once

#include <specbake/core/wavelengths.h>

#include <pybind11/numpy.h>

/// The Python module, part by part: each adds its classes and functions, with what `help()` shows.
namespace specbake::python {

void addErrors(pybind11::module_& module);
void addObserver(pybind11::module_& module);
void addUpsampler(pybind11::module_& module);
void addTable(pybind11::module_& module);
void addBaking(pybind11::module_& module);
void addSpectralImage(pybind11::module_& module);

/// (N,) float64, nm; not to be written to.
pybind11::array_t<double> bandWavelengths(const Wavelengths& bands);

}  // namespace specbake::python
