#include "texture/openimageio/output/openimageio_preview.h"

#include "texture/openimageio/one_line.h"
#include "texture/openimageio/output/checked_output.h"

#include <specbake/core/color_space.h>
#include <specbake/core/error.h>

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace specbake::internal {
namespace {

constexpr int kGiven = 4;  ///< channels of a given row

std::unique_ptr<OIIO::ImageOutput> formatOf(const std::filesystem::path& path) {
    auto output = OIIO::ImageOutput::create(path.string());
    if (!output) throw FileError(path.string(), oneLine(OIIO::geterror()));
    return output;
}

bool hasFloats(const OIIO::ImageOutput& output) {
    const std::string format = output.format_name();
    return format == "openexr" || format == "hdr";
}

OIIO::ImageSpec specOf(const OIIO::ImageOutput& output, const SpectralHeader& like) {
    const int channels = like.alpha && output.supports("alpha") != 0 ? 4 : 3;
    OIIO::ImageSpec spec(like.data.width, like.data.height, channels,
                         hasFloats(output) ? OIIO::TypeFloat : OIIO::TypeUInt8);
    spec.attribute("PixelAspectRatio", like.pixelAspectRatio);
    spec.attribute("oiio:ColorSpace", hasFloats(output) ? "lin_rec709" : "sRGB");
    if (!hasFloats(output)) spec.attribute("oiio:UnassociatedAlpha", 1);
    if (output.supports("displaywindow") != 0) {
        spec.x = like.data.x;
        spec.y = like.data.y;
        spec.full_x = like.display.x;
        spec.full_y = like.display.y;
        spec.full_width = like.display.width;
        spec.full_height = like.display.height;
    }
    return spec;
}

std::uint8_t byteOf(double share) {
    return std::uint8_t(std::lround(std::clamp(share, 0.0, 1.0) * 255));
}

class OpenImageIOPreview : public PreviewFile {
  public:
    OpenImageIOPreview(const std::filesystem::path& path, const std::filesystem::path& file,
                       const SpectralHeader& like)
        : path_(path.string()),
          file_(file),
          output_(formatOf(path)),
          spec_(specOf(*output_, like)) {
        if (!file_.open(*output_, spec_)) fail();
    }

    void writeRow(std::span<const float> rgba) override {
        if (rgba.size() != std::size_t(spec_.width) * kGiven) {
            throw ArgumentError("a row of another width");
        }
        const int y = spec_.y + rowsWritten_++;
        const bool written =
            hasFloats(*output_)
                ? output_->write_scanline(y, 0, OIIO::TypeFloat, floats(rgba).data())
                : output_->write_scanline(y, 0, OIIO::TypeUInt8, bytes(rgba).data());
        if (!written) fail();
    }

    void close() override {
        const bool closed = output_->close();
        if (!file_.close() || !closed) fail();
    }

  private:
    /// What the system says is true; not all formats look at it.
    [[noreturn]] void fail() {
        std::string reason = file_.error();
        const std::string said = output_->geterror();
        if (reason.empty()) reason = said.empty() ? "it cannot be written whole" : oneLine(said);
        throw FileError(path_, reason);
    }

    /// Linear, multiplied by alpha, as EXR wants it.
    std::vector<float> floats(std::span<const float> rgba) const {
        std::vector<float> row;
        for (std::size_t t = 0; t < rgba.size(); t += kGiven) {
            const float alpha = spec_.nchannels == kGiven ? rgba[t + 3] : 1.0F;
            for (std::size_t c = 0; c < 3; ++c) row.push_back(rgba[t + c] * alpha);
            if (spec_.nchannels == kGiven) row.push_back(alpha);
        }
        return row;
    }

    std::vector<std::uint8_t> bytes(std::span<const float> rgba) const {
        std::vector<std::uint8_t> row;
        for (std::size_t t = 0; t < rgba.size(); t += kGiven) {
            for (std::size_t c = 0; c < 3; ++c) {
                row.push_back(byteOf(sRGBFromLinear(double(rgba[t + c]))));
            }
            if (spec_.nchannels == kGiven) row.push_back(byteOf(double(rgba[t + 3])));
        }
        return row;
    }

    std::string path_;
    CheckedOutput file_;
    std::unique_ptr<OIIO::ImageOutput> output_;
    OIIO::ImageSpec spec_;
    int rowsWritten_ = 0;
};

}  // namespace

std::unique_ptr<PreviewFile> createWithOpenImageIO(const std::filesystem::path& path,
                                                   const std::filesystem::path& file,
                                                   const SpectralHeader& like) {
    return std::make_unique<OpenImageIOPreview>(path, file, like);
}

}  // namespace specbake::internal
