#pragma once

#include <specbake/core/api.h>
#include <specbake/image/chunk_grid.h>

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace specbake {

/// Takes a spectral image by chunks: runs of rows, or tiles of one or more levels. Packing is apart
/// from writing, so that a caller packs chunks in parallel and writes them in order; nothing is
/// held of the image.
class SPECBAKE_API SpectralSink {
  public:
    /// `levels`: the image itself first. `bands`: how many.
    SpectralSink(std::vector<ChunkGrid> levels, SampleType type, bool alpha,
                 int bands = kBandCount);
    virtual ~SpectralSink();
    SpectralSink(const SpectralSink&) = delete;
    SpectralSink& operator=(const SpectralSink&) = delete;

    SampleType sampleType() const { return type_; }
    bool alpha() const { return alpha_; }
    int channelCount() const { return int(kPreviewSamples) + bands_ + (alpha_ ? 1 : 0); }
    const std::vector<ChunkGrid>& levels() const { return levels_; }
    int chunkCount() const;  ///< of all levels
    const ChunkGrid& levelOf(int chunk) const;
    std::size_t planeRowBytes(int chunk) const;  ///< of one channel in one row
    std::size_t chunkBytes(int chunk) const;     ///< of its samples

    /// A chunk's samples to what is written of them, in the same memory. The samples lie row by
    /// row, within a row channel by channel (channelNames()), each channel's row contiguous. Any
    /// number of threads may pack at once. Throws FileError; ArgumentError for another size.
    std::vector<std::byte> pack(int chunk, std::vector<std::byte> samples) const;

    /// Takes a packed chunk, from one thread at a time. The chunks of one level go in order, those
    /// of several levels in any; all must come. Throws FileError.
    virtual void write(int chunk, std::span<const std::byte> packed) = 0;

  private:
    virtual void packInPlace(int chunk, std::vector<std::byte>& samples) const = 0;

    std::vector<ChunkGrid> levels_;
    SampleType type_;
    bool alpha_;
    int bands_;
};

/// Hands over each row, from the top, as pack() takes it: no file, no compression.
class SPECBAKE_API RowSink : public SpectralSink {
  public:
    using Take = std::function<void(int row, std::span<const std::byte> samples)>;

    /// Rows are numbered from 0 within the header's data window.
    RowSink(const SpectralHeader& header, SampleType type, Take take);

    void write(int chunk, std::span<const std::byte> packed) override;

  private:
    void packInPlace(int chunk, std::vector<std::byte>& samples) const override;

    Take take_;
};

}  // namespace specbake
