#include "arrays.h"

#include <specbake/core/error.h>

#include <pybind11/stl.h>

namespace py = pybind11;

namespace specbake::python {

std::string placeOf(std::size_t number, const Shape& shape) {
    std::string place;
    for (auto side = shape.rbegin(); side != shape.rend(); ++side) {
        const std::string index = std::to_string(number % std::size_t(*side));
        place.insert(0, place.empty() ? index : index + ", ");
        number /= std::size_t(*side);
    }
    return "(" + place + ")";
}

py::array contiguous(const py::array& array) {
    return py::module_::import("numpy").attr("require")(
        array, py::arg("requirements") = py::make_tuple("C", "A"));
}

std::optional<TexelType> texelType(const py::dtype& type) {
    if (type.kind() == 'u' && type.itemsize() == 1) return TexelType::uint8;
    if (type.kind() == 'u' && type.itemsize() == 2) return TexelType::uint16;
    if (type.kind() == 'f' && type.itemsize() == 2) return TexelType::half;
    if (type.kind() == 'f' && type.itemsize() == 4) return TexelType::float32;
    return {};
}

py::array nativeOrder(const py::array& array) {
    if (array.dtype().attr("isnative").cast<bool>()) return array;
    return array.attr("astype")(array.dtype().attr("newbyteorder")("="));
}

SampleType sampleTypeOf(const py::object& dtype) {
    const py::dtype type = py::dtype::from_args(dtype);
    if (type.kind() == 'f' && type.itemsize() == 4) return SampleType::float32;
    if (type.kind() == 'f' && type.itemsize() == 2) return SampleType::half;
    throw ArgumentError("spectra are float32 or float16, not " +
                        std::string(py::str(py::object(type))));
}

py::dtype dtypeOf(SampleType type) {
    return py::dtype(type == SampleType::half ? "float16" : "float32");
}

py::array outputArray(const Shape& shape, SampleType type, const py::object& out) {
    if (out.is_none()) return {dtypeOf(type), shape};
    if (!py::isinstance<py::array>(out)) throw ArgumentError("out is no numpy array");
    auto array = py::reinterpret_borrow<py::array>(out);
    const Shape has(array.shape(), array.shape() + array.ndim());
    if (has != shape || !array.dtype().equal(dtypeOf(type)) || !array.writeable() ||
        (array.flags() & py::array::c_style) == 0) {
        throw ArgumentError(std::string("out must be a writeable, C-contiguous array of ") +
                            (type == SampleType::half ? "float16" : "float32") + " and of shape " +
                            std::string(py::str(py::tuple(py::cast(shape)))));
    }
    return array;
}

}  // namespace specbake::python
