#include "texture/select/oriented_file.h"

#include <doctest/doctest.h>

#include <cstring>

using namespace specbake;
using namespace specbake::internal;

namespace {

constexpr int kWidth = 7;
constexpr int kHeight = 5;

/// Texel (x, y) holds x and y; its rows are counted.
class Numbered : public ImageFile {
  public:
    Numbered(int orientation, int& rowsRead)
        : ImageFile(described(orientation)), rowsRead_(rowsRead) {}
    std::optional<std::string> text(const std::string& /*attribute*/) const override { return {}; }

  private:
    static ImageDescription described(int orientation) {
        ImageDescription d;
        d.data = {3, 1, kWidth, kHeight};
        d.display = {0, 0, 20, 10};
        d.pixelAspectRatio = 2;
        d.channels = {"R", "G"};
        d.orientation = orientation;
        d.attributes = {{"XResolution", 72.0F}, {"YResolution", 36.0F}};
        return d;
    }
    void unpackRows(int first, int count, TexelType /*type*/,
                    std::span<std::byte> samples) override {
        for (int row = 0; row < count; ++row) {
            for (int x = 0; x < kWidth; ++x) {
                const auto at = std::size_t(2 * (row * kWidth + x));
                samples[at] = std::byte(x);
                samples[at + 1] = std::byte(first + row);
            }
        }
        rowsRead_ += count;
    }
    int& rowsRead_;
};

struct Place {
    int x, y;
};

/// Where texel (x, y) is to be shown: TIFF 6.0, tag 274, which says where the first row and the
/// first column are.
Place shownAt(int orientation, int x, int y) {
    const int right = kWidth - 1 - x;
    const int below = kHeight - 1 - y;
    const Place places[] = {{x, y}, {right, y}, {right, below}, {x, below},
                            {y, x}, {below, x}, {below, right}, {y, right}};
    return places[orientation - 1];
}

void checkTurned(int orientation, std::size_t mostBytes) {
    int rowsRead = 0;
    OrientedFile turned(std::make_unique<Numbered>(orientation, rowsRead), mostBytes);
    const Window& window = turned.description().data;
    std::vector<std::byte> samples(std::size_t(window.width * window.height * 2));
    const std::size_t rowBytes = std::size_t(window.width) * 2;
    for (int row = 0; row < window.height; ++row) {
        turned.readRows(row, 1, TexelType::uint8,
                        std::span(samples).subspan(rowBytes * std::size_t(row)));
    }
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const Place to = shownAt(orientation, x, y);
            const auto at = std::size_t(2 * (to.y * window.width + to.x));
            CHECK(samples.at(at) == std::byte(x));
            CHECK(samples.at(at + 1) == std::byte(y));
        }
    }
    // As many passes as the memory asks for.
    const std::size_t kept = std::max(mostBytes / rowBytes, std::size_t(1));
    const std::size_t passes = (std::size_t(window.height) + kept - 1) / kept;
    CHECK(std::size_t(rowsRead) <= passes * kHeight);
}

}  // namespace

TEST_CASE("orientation: every texel goes where TIFF says, in one pass or in many") {
    for (int orientation = 1; orientation <= 8; ++orientation) {
        CAPTURE(orientation);
        checkTurned(orientation, OrientedFile::kMostBytes);
        checkTurned(orientation, 30);  // two or three rows
        checkTurned(orientation, 1);   // a row at a time
    }
}

TEST_CASE("orientation: windows and resolutions turn with the texels") {
    int rowsRead = 0;
    const OrientedFile mirrored(std::make_unique<Numbered>(2, rowsRead));
    CHECK(mirrored.description().data == Window{20 - 3 - kWidth, 1, kWidth, kHeight});
    CHECK(mirrored.description().display == Window{0, 0, 20, 10});
    const OrientedFile turned(std::make_unique<Numbered>(6, rowsRead));
    // A quarter clockwise: what was 10 − 1 − 5 = 4 above the lower edge is now 4 from the left.
    CHECK(turned.description().data == Window{4, 3, kHeight, kWidth});
    CHECK(turned.description().display == Window{0, 0, 10, 20});
    CHECK(turned.description().pixelAspectRatio == 0.5F);
    CHECK(std::get<float>(turned.description().attributes.at("XResolution")) == 36.0F);
    CHECK(turned.description().orientation == 1);
}
