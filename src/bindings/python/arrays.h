#pragma once

#include <specbake/core/samples.h>
#include <specbake/image/image_types.h>

#include <pybind11/numpy.h>

#include <optional>
#include <string>
#include <vector>

namespace specbake::python {

using Shape = std::vector<pybind11::ssize_t>;

/// "(a, b)": where element `number` of an array of that shape is.
std::string placeOf(std::size_t number, const Shape& shape);

/// The array as it is where it is C-contiguous and aligned, else a copy that is.
pybind11::array contiguous(const pybind11::array& array);

/// The same in the machine's byte order.
pybind11::array nativeOrder(const pybind11::array& array);

/// What an array's elements are as a texture's samples; none for other types than uint8, uint16,
/// float16 and float32.
std::optional<TexelType> texelType(const pybind11::dtype& type);

/// Of float32 or float16, however it is named. Throws ArgumentError for another.
SampleType sampleTypeOf(const pybind11::object& dtype);
pybind11::dtype dtypeOf(SampleType type);

/// A new array, or `out` unless that is None: then it must have this shape and type, be
/// C-contiguous and writeable, else ArgumentError.
pybind11::array outputArray(const Shape& shape, SampleType type, const pybind11::object& out);

}  // namespace specbake::python
