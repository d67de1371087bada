#pragma once

#include <specbake/core/upsampler.h>

#include <pybind11/pybind11.h>

namespace specbake::python {

/// What Upsampler.solve() answers, of a model of these bands.
struct SolvedColor {
    ColorAnswer answer;
    Wavelengths bands;
};

/// The class Solution, which is a SolvedColor.
void addSolution(pybind11::module_& module);

}  // namespace specbake::python
