#include "texture/openimageio/luminance_chroma.h"

#include "file/input_stream.h"
#include "texture/openimageio/one_line.h"
#include "texture/plain/exr_input.h"

#include <specbake/core/error.h>

#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <cstring>
#include <exception>
#include <utility>

namespace specbake::internal {
namespace {

Window windowOf(const std::string& path, const Imath::Box2i& box) {
    const long long width = 1LL + box.max.x - box.min.x;
    const long long height = 1LL + box.max.y - box.min.y;
    checkSides(path, width, height);
    return {box.min.x, box.min.y, int(width), int(height)};
}

ImageDescription describe(const std::string& path, const Imf::RgbaInputFile& file) {
    ImageDescription d;
    d.data = windowOf(path, file.dataWindow());
    d.display = windowOf(path, file.displayWindow());
    d.pixelAspectRatio = file.pixelAspectRatio();
    d.channels = {"R", "G", "B"};
    if ((file.channels() & Imf::WRITE_A) != 0) {
        d.alpha = 3;
        d.channels.emplace_back("A");
    }
    d.associatedAlpha = d.alpha.has_value();
    d.sampleType = TexelType::half;
    d.integers = false;
    if (Imf::hasChromaticities(file.header())) {
        const Imf::Chromaticities& c = Imf::chromaticities(file.header());
        d.signs.chromaticities = Primaries{{double(c.red.x), double(c.red.y)},
                                           {double(c.green.x), double(c.green.y)},
                                           {double(c.blue.x), double(c.blue.y)},
                                           {double(c.white.x), double(c.white.y)}};
    }
    d.notes.emplace_back(
        "luminance and chroma, which is stored of every second row and column: "
        "read as R, G and B");
    return d;
}

class LuminanceChroma : public ImageFile {
  public:
    LuminanceChroma(std::string path, std::unique_ptr<Imf::RgbaInputFile> file)
        : ImageFile(describe(path, *file)), path_(std::move(path)), file_(std::move(file)) {
        row_.resize(std::size_t(description().data.width));
    }

    std::optional<std::string> text(const std::string& attribute) const override {
        const auto* value = file_->header().findTypedAttribute<Imf::StringAttribute>(attribute);
        return value == nullptr ? std::optional<std::string>() : value->value();
    }

  private:
    void unpackRows(int first, int count, TexelType type, std::span<std::byte> samples) override {
        std::byte* to = samples.data();
        for (int row = 0; row < count; ++row) {
            readRow(description().data.y + first + row);
            for (const Imf::Rgba& texel : row_) to = put(texel, type, to);
        }
    }

    void readRow(int y) {
        try {
            // Where texel (0, y) would lie: the library counts from there.
            file_->setFrameBuffer(row_.data() - description().data.x, 1, 0);
            file_->readPixels(y);
        } catch (const std::exception& error) {
            throw FileError(path_, oneLine(error.what()));
        }
    }

    std::byte* put(const Imf::Rgba& texel, TexelType type, std::byte* to) const {
        const std::array<half, 4> channels = {texel.r, texel.g, texel.b, texel.a};
        for (std::size_t c = 0; c < description().channels.size(); ++c) {
            const float value = channels[c];
            const void* from = type == TexelType::half ? static_cast<const void*>(&channels[c])
                                                       : static_cast<const void*>(&value);
            std::memcpy(to, from, bytesPerSample(type));
            to += bytesPerSample(type);
        }
        return to;
    }

    std::string path_;
    std::unique_ptr<Imf::RgbaInputFile> file_;
    std::vector<Imf::Rgba> row_;
};

/// Null for what OpenEXR cannot open so.
std::unique_ptr<Imf::RgbaInputFile> open(const std::string& path) {
    try {
        return std::make_unique<Imf::RgbaInputFile>(path.c_str(), 0);
    } catch (const std::exception&) {
        return {};
    }
}

}  // namespace

std::unique_ptr<ImageFile> openLuminanceChroma(const std::string& path) {
    if (!beginsWith(path, kExrSignature)) return {};
    auto file = open(path);
    if (!file || (file->channels() & Imf::WRITE_C) == 0) return {};
    return std::make_unique<LuminanceChroma>(path, std::move(file));
}

}  // namespace specbake::internal
