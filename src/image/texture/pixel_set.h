#pragma once

#include <specbake/image/color_meaning.h>

#include <cstdint>
#include <vector>

namespace specbake::internal {

/// Pixels on their way through a transform, each of those that return soon only once: a table of
/// four inks costs a hundred times what it costs to see that a pixel was there before.
class PixelSet {
  public:
    /// For pixels of so many channels, at most 4.
    PixelSet(std::size_t channels, std::size_t expected);

    void add(const std::array<float, 4>& stored);

    /// All pixels in the order in which they were added.
    void run(const PixelTransform& transform, std::array<float, 3>* linear) const;

  private:
    static constexpr std::size_t kSlots = 1024;

    std::size_t channels_;
    std::vector<float> different_;               ///< channels_ each
    std::vector<std::uint32_t> which_;           ///< of these, by pixel
    std::array<std::uint32_t, kSlots> slots_{};  ///< which pixel of that hash came last, plus 1
};

}  // namespace specbake::internal
