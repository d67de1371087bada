#pragma once

#include <specbake/core/api.h>
#include <specbake/core/samples.h>
#include <specbake/image/image_types.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The layout of a spectral EXR: A. Fichet, R. Pacanowski, A. Wilkie, "An OpenEXR Layout for
/// Spectral Images", JCGT 10(3), 2021. docs/file-format.md has the whole of it.
namespace specbake {

/// The channel of the reflectance at a wavelength, nm: "T.380,000000nm" and so on. Decimal comma,
/// six decimals.
SPECBAKE_API std::string bandChannelName(double nm);

/// The wavelength, nm, of a reflectance channel's name; nothing for another channel.
SPECBAKE_API std::optional<double> bandWavelength(std::string_view channelName);

/// A file's channels in the order in which they are stored, the alphabet's: A (if any), then the
/// samples of a texel (samples.h). Wavelengths are from 100 to 999 nm.
SPECBAKE_API std::vector<std::string> channelNames(bool alpha, const Wavelengths& bands = {});

enum class Compression { none, zip, zips, piz };

/// "zip" and so on; every compression that is offered, the default first.
SPECBAKE_API std::string_view compressionName(Compression compression);
SPECBAKE_API std::span<const Compression> compressions();

/// The size of a file's tiles.
struct TileSize {
    int width = 64;
    int height = 64;

    static constexpr int kLargestSide = 1024;
};

/// How pixels are stored.
struct StorageOptions {
    SampleType sampleType = SampleType::half;  ///< of every channel
    Compression compression = Compression::zip;
    int level = kFastestSmall;  ///< of zip and zips
    /// None: scan lines, or with `mipmap` tiles of the usual size.
    std::optional<TileSize> tile = std::nullopt;
    bool mipmap = false;  ///< all levels down to one texel, not the first alone
    bool sync = false;    ///< the file outlives a power cut (output_file.h)

    bool isTiled() const { return tile.has_value() || mipmap; }

    /// Levels 1 to 3 are our own encoder's (fast), 4 to 12 libdeflate's (small).
    static constexpr int kFastestSmall = 3;
    static constexpr int kHighestLevel = 12;
};

/// Rows that OpenEXR compresses as one chunk of scan lines.
constexpr int rowsPerChunk(Compression compression) {
    return compression == Compression::zip ? 16 : compression == Compression::piz ? 32 : 1;
}

/// Whether a file's user may say something under that name: 1 to 31 characters, none of the
/// attributes by which EXR, the layout or OpenImageIO ("oiio:…") describe the file, and none of
/// specbake's own ("specbake:…").
SPECBAKE_API bool isFreeAttributeName(std::string_view name);

/// What a spectral file says of itself.
struct SpectralHeader {
    Window data;
    Window display;
    float pixelAspectRatio = 1;
    bool alpha = false;
    Attributes attributes;
    Wavelengths bands = {};  ///< that are written; a reader has its own list
};

/// `storage`, with Compression::zips for `zip` where a chunk of its 16 rows would take more than
/// 64 MiB of the writer and of every reader: from about 25,000 texels of halves on.
SPECBAKE_API StorageOptions withBoundedChunks(const StorageOptions& storage,
                                              const SpectralHeader& header);

}  // namespace specbake
