#pragma once

#include "arrays.h"

#include <specbake/core/upsampler.h>
#include <specbake/image/texel_decoder.h>

#include <pybind11/numpy.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace specbake::python {

/// Colours in an array whose last axis has their three components: numbers as a texture in that
/// space stores them. 8- and 16-bit unsigned integers are shares of the largest; all else is taken
/// as it is, in single precision. Nothing is copied of a C-contiguous array of float32 in a linear
/// space; what else of float32, float16, uint8 and uint16 is contiguous is decoded run by run.
class ColorArray {
  public:
    using Color = Upsampler::Color;

    /// Throws ArgumentError for what is no such array. Needs the GIL, as does destruction.
    ColorArray(const pybind11::object& colors, const ColorSpace& space);

    std::size_t count() const { return count_; }
    /// Of the array without its last axis.
    const Shape& shape() const { return shape_; }
    /// "colour (3, 7)" where there are two axes, and so on; "the colour" where there are none.
    std::string nameOf(std::size_t number) const;

    /// Linear colours [first, first + count), in `buffer` unless they lie in the array so.
    std::span<const Color> run(std::size_t first, std::size_t count,
                               std::vector<Color>& buffer) const;

  private:
    pybind11::array array_;
    Shape shape_;
    std::size_t count_ = 1;
    const std::byte* samples_ = nullptr;
    std::size_t colorBytes_ = 0;
    std::optional<TexelDecoder> decoder_;  ///< none: float32 in a linear space
};

}  // namespace specbake::python
