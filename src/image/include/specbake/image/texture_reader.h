#pragma once

#include <specbake/core/api.h>
#include <specbake/image/texture.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace specbake {

class SpectralReader;

/// What is read of a file that holds more than one texture, and how it is turned.
struct SPECBAKE_API ReadOptions {
    /// One channel of colour or three, and perhaps one of alpha behind them: their names, or their
    /// numbers from 0. A single name of a layer (`diffuse`) stands for its R, G, B and A. Empty:
    /// the colours of the file (docs/inputs.md).
    std::vector<std::string> channels = {};
    /// The name or the number, from 0, of a part (a subimage, page, layer or frame); none: the
    /// first.
    std::optional<std::string> part = {};
    /// Whether texels are turned as Exif or TIFF would have the image shown. Textures are not
    /// turned by default: what addresses them by u and v, and OpenImageIO's texture system with it,
    /// means them as they are stored.
    bool orient = false;

    /// Whether a file could be read so. `reason`, if it is given, says why not: one line.
    [[nodiscard]] bool isValid(std::string* reason = nullptr) const;

    /// These options; what they leave open as it was when the spectral file was made.
    ReadOptions orAsIn(const SpectralReader& spectral) const;
};

/// "R,G,B" to its parts at the commas.
SPECBAKE_API std::vector<std::string> channelList(const std::string& text);

/// Reads one part, at its first mip level, of any file that OpenImageIO reads, by rows.
/// Throws FileError, with the file and the reason, for what cannot be read: absent, truncated,
/// deep, volumetric, larger than kLargestSide, without channels that can be told to be colours;
/// ArgumentError for options that are not valid.
///
/// What of the options was used stands in the texture's attributes, for ReadOptions::orAsIn().
class SPECBAKE_API TextureReader : public Texture {
  public:
    explicit TextureReader(const std::string& path, const ReadOptions& options = {});
    ~TextureReader() override;

    const TextureInfo& info() const override;
    void readRows(int first, int count, std::span<std::byte> samples) override;

  private:
    struct SPECBAKE_LOCAL Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace specbake
