#include "image_array.h"

#include "arrays.h"
#include "color_array.h"

#include <specbake/core/error.h>

namespace py = pybind11;

namespace specbake::python {
namespace {

std::string shapeOf(const py::array& array) {
    return py::str(array.attr("shape"));
}

/// Rows may be any distance apart, below one another; within them texels are packed.
bool rowsArePacked(const py::array& array) {
    const auto sample = array.itemsize();
    const bool channels = array.ndim() < 3 || array.strides(2) == sample;
    const auto texel = array.ndim() < 3 ? sample : sample * array.shape(2);
    const bool aligned = array.strides(0) % sample == 0;
    return channels && aligned && array.strides(1) == texel &&
           array.strides(0) >= texel * array.shape(1);
}

py::array checked(const py::array& array) {
    if (array.ndim() != 2 && (array.ndim() != 3 || array.shape(2) < 1 || array.shape(2) > 4)) {
        throw ArgumentError("an image is (height, width) or (height, width, 1 to 4), not " +
                            shapeOf(array));
    }
    for (int axis = 0; axis < 2; ++axis) {
        if (array.shape(axis) < 1 || array.shape(axis) > kLargestSide) {
            throw ArgumentError("a side of an image is 1 to " + std::to_string(kLargestSide) +
                                ", not " + shapeOf(array));
        }
    }
    const bool native = array.dtype().attr("isnative").cast<bool>();
    return native && rowsArePacked(array) ? array : contiguous(nativeOrder(array));
}

}  // namespace

ImageArray::ImageArray(const py::array& array, const std::optional<std::string>& space)
    : array_(checked(array)) {
    const std::optional<TexelType> type = texelType(array_.dtype());
    if (!type) {
        throw ArgumentError("an image is uint8, uint16, float16 or float32, not " +
                            std::string(py::str(array_.dtype())));
    }
    const bool integer = *type == TexelType::uint8 || *type == TexelType::uint16;
    image_.name = "array";
    image_.height = int(array_.shape(0));
    image_.width = int(array_.shape(1));
    image_.channels = array_.ndim() < 3 ? 1 : int(array_.shape(2));
    if (image_.channels % 2 == 0) image_.alpha = image_.channels - 1;
    image_.sampleType = *type;
    image_.space = colorSpaceNamed(space.value_or(integer ? "srgb" : "lin_rec709"));
    image_.rowStride = std::size_t(array_.strides(0));
    const std::size_t row =
        std::size_t(image_.width) * std::size_t(image_.channels) * bytesPerSample(*type);
    if (image_.height == 1) image_.rowStride = row;
    image_.samples = {static_cast<const std::byte*>(array_.data()),
                      image_.rowStride * std::size_t(image_.height - 1) + row};
}

}  // namespace specbake::python
