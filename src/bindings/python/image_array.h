#pragma once

#include <specbake/image/memory_texture.h>

#include <pybind11/numpy.h>

#include <optional>
#include <string>

namespace specbake::python {

/// An array (height, width[, channels]) as a texture's image; its rows are not copied where texels
/// lie side by side.
class ImageArray {
  public:
    /// `space`: none for sRGB of integers, linear Rec.709 of floats. Throws ArgumentError. Needs
    /// the GIL, as does destruction.
    ImageArray(const pybind11::array& array, const std::optional<std::string>& space);

    const MemoryImage& image() const { return image_; }

  private:
    pybind11::array array_;
    MemoryImage image_;
};

}  // namespace specbake::python
