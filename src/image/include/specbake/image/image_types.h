#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace specbake {

/// A rectangle of pixels; (x, y) is its first pixel, which may be anywhere, also negative.
struct Window {
    int x = 0, y = 0;
    int width = 0, height = 0;
    bool operator==(const Window&) const = default;
};

/// Sides beyond this are refused: hostile headers claim more (the limit of known formats is below).
inline constexpr int kLargestSide = 1 << 17;

enum class TexelType { uint8, uint16, half, float32 };

constexpr std::size_t bytesPerSample(TexelType type) {
    return type == TexelType::uint8 ? 1 : type == TexelType::float32 ? 4 : 2;
}

/// Metadata that a file carries beside its pixels. Vectors have 2, 3, 9 or 16 floats.
using AttributeValue = std::variant<std::string, int, float, std::vector<float>>;
using Attributes = std::map<std::string, AttributeValue>;

}  // namespace specbake
