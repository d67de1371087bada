#pragma once

#include <specbake/bake/bake.h>
#include <specbake/core/api.h>
#include <specbake/image/chunk_grid.h>
#include <specbake/image/table_file.h>
#include <specbake/image/texture.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace specbake {

/// How much a BakedImage may keep, bytes. What is not kept is made anew: other samples never come
/// of it.
struct BakedImageMemory {
    std::size_t texture = std::size_t(256) << 20;  ///< rows of the texture, as they are stored
    std::size_t levels = std::size_t(128) << 20;   ///< spectra of mip levels
};

/// The spectral image that bake() would write of a texture, computed where it is looked at: any
/// chunk of any level, any of its channels, the same samples to the last bit. Bands that are not
/// asked for are not computed, unless a preview channel is. Any number of threads may share one.
class SPECBAKE_API BakedImage {
  public:
    /// Throws what bake() throws before its first row, and ArgumentError for a material map.
    BakedImage(std::unique_ptr<Texture> texture, const BakeOptions& options,
               const BakedImageMemory& memory = {});
    /// The image with the spectra that a renderer looks up in the table, whatever the options say
    /// of a model. Throws FileError for a table of other colours than the texture's, and
    /// ArgumentError for maxDE and maxDeviation.
    BakedImage(std::unique_ptr<Texture> texture, const BakeOptions& options,
               std::shared_ptr<const TableFile> table, const BakedImageMemory& memory = {});
    ~BakedImage();
    BakedImage(const BakedImage&) = delete;
    BakedImage& operator=(const BakedImage&) = delete;

    const SpectralHeader& header() const;
    SampleType sampleType() const;
    /// How the file would be cut: the image itself first, then its mip levels, if it has any.
    const std::vector<ChunkGrid>& levels() const;

    /// A chunk's samples of some channels, numbers in channelNames(header().alpha, header().bands):
    /// row by row, within a row texel by texel, channels interleaved in the order in which they are
    /// asked for.
    /// Throws ArgumentError for a chunk or channel that there is not, or too small a room;
    /// FileError where the texture cannot be read, or has a texel without a spectrum there.
    void readChunk(int chunk, std::span<const int> channels, std::span<std::byte> samples) const;

  private:
    struct SPECBAKE_LOCAL Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace specbake
