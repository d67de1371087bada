#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <stop_token>

namespace specbake::python {

/// What long work looks at and tells.
struct Watch {
    std::stop_token stop;
    std::function<void(double)> progress;  ///< 0 to 1
};

/// Runs `work` on a thread of its own, with the GIL released. Meanwhile the calling thread lets
/// Python handle signals, so that Ctrl-C stops the work, and hands what is done to `progress`, a
/// callable or None. Throws what `work` throws, or a Python error of these two, after which the
/// work has been stopped.
void runInterruptibly(const std::function<void(const Watch&)>& work,
                      const pybind11::object& progress = pybind11::none());

}  // namespace specbake::python
