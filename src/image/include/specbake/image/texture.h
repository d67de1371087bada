#pragma once

#include <specbake/core/api.h>
#include <specbake/image/color_meaning.h>
#include <specbake/image/image_types.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace specbake {

/// What is known of a texture.
struct TextureInfo {
    std::string path;  ///< of its file, or what an error calls it
    Window data;       ///< where there are pixels
    Window display;    ///< what is meant to be seen
    float pixelAspectRatio = 1;
    int channels = 0;                         ///< 1 to 5, alpha included
    ColorModel model = ColorModel::rgb;       ///< of the channels of colour
    std::optional<int> alpha;                 ///< the index of the alpha channel
    bool associatedAlpha = false;             ///< stored colour is multiplied by alpha
    TexelType sampleType = TexelType::uint8;  ///< as stored, or the next larger that is offered
    ColorMeaning color;                       ///< what the texture itself says of its numbers
    Attributes attributes;                    ///< metadata worth keeping
    std::vector<std::string> notes;           ///< one line each on what of the file is not used

    std::size_t bytesPerRow() const {
        return std::size_t(data.width) * std::size_t(channels) * bytesPerSample(sampleType);
    }
};

/// An image of one to four channels whose rows can be read: a file (texture_reader.h), an array
/// (memory_texture.h), or whatever else implements this.
class SPECBAKE_API Texture {
  public:
    Texture() = default;
    virtual ~Texture();
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    /// The same at every call.
    virtual const TextureInfo& info() const = 0;

    /// Rows [first, first + count) of the data window, counted from 0, as they are stored:
    /// info().sampleType samples, channels interleaved. Rows are best asked for in order; they may
    /// be asked for again. By one thread at a time. Throws FileError.
    virtual void readRows(int first, int count, std::span<std::byte> samples) = 0;
};

}  // namespace specbake
