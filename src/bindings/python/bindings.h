#pragma once

#include <pybind11/pybind11.h>

/// The Python module, part by part: each adds its classes and functions, with what `help()` shows.
namespace specbake::python {

void addErrors(pybind11::module_& module);
void addObserver(pybind11::module_& module);
void addUpsampler(pybind11::module_& module);
void addTable(pybind11::module_& module);
void addBaking(pybind11::module_& module);
void addSpectralImage(pybind11::module_& module);

}  // namespace specbake::python
