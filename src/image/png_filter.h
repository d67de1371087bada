#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace specbake {

/// Undoes one of the filters of the PNG specification (W3C, 10 November 2003), 9.2, in place: `row`
/// is the filtered row, `above` the restored one before it, of the same length (zeros at first).
/// Bytes of a pixel before the first count as 0. False if there is no such filter.
bool unfilter(int filter, std::size_t pixelBytes, std::span<const std::uint8_t> above,
              std::span<std::uint8_t> row);

}  // namespace specbake
