#include "color_array.h"

#include <specbake/core/error.h>

namespace py = pybind11;

namespace specbake::python {
namespace {

/// C-contiguous, in the machine's byte order, and of a type that texelType() knows.
py::array readable(const py::object& colors) {
    const py::object numpy = py::module_::import("numpy");
    py::array array = numpy.attr("asarray")(colors);
    const char kind = array.dtype().kind();
    if (kind != 'u' && kind != 'i' && kind != 'f') {
        throw ArgumentError("colours are numbers, not of type " +
                            std::string(py::str(array.dtype())));
    }
    if (!texelType(array.dtype())) array = array.attr("astype")("float32");
    return contiguous(nativeOrder(array));
}

}  // namespace

ColorArray::ColorArray(const py::object& colors, const ColorSpace& space)
    : array_(readable(colors)) {
    if (array_.ndim() < 1 || array_.shape(array_.ndim() - 1) != 3) {
        throw ArgumentError(
            "the last axis of colours has three components, not an array of shape " +
            std::string(py::str(array_.attr("shape"))));
    }
    shape_.assign(array_.shape(), array_.shape() + array_.ndim() - 1);
    for (const py::ssize_t side : shape_) count_ *= std::size_t(side);
    samples_ = static_cast<const std::byte*>(array_.data());
    TextureInfo info;
    info.path = "colours";
    info.channels = 3;
    info.sampleType = texelType(array_.dtype()).value();
    colorBytes_ = 3 * bytesPerSample(info.sampleType);
    if (info.sampleType != TexelType::float32 || space.transfer != Transfer::linear) {
        info.color.space = space;
        decoder_.emplace(info, info.color);
    }
}

std::string ColorArray::nameOf(std::size_t number) const {
    return shape_.empty() ? "the colour" : "colour " + placeOf(number, shape_);
}

std::span<const ColorArray::Color> ColorArray::run(std::size_t first, std::size_t count,
                                                   std::vector<Color>& buffer) const {
    const std::byte* from = samples_ + first * colorBytes_;
    if (!decoder_) return {reinterpret_cast<const Color*>(from), count};
    buffer.resize(count);
    decoder_->decode({from, count * colorBytes_}, count, buffer.data(), nullptr);
    return buffer;
}

}  // namespace specbake::python
