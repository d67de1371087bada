#pragma once

#include <specbake/core/upsampler.h>

#include <pybind11/pybind11.h>

namespace specbake::python {

/// The class Solution: what Upsampler.solve() answers.
void addSolution(pybind11::module_& module);

}  // namespace specbake::python
