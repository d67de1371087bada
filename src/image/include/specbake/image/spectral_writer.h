#pragma once

#include <specbake/core/api.h>
#include <specbake/image/chunk_grid.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace specbake {

/// Writes one spectral EXR by chunks: runs of rows, or tiles of one or more levels. Packing (the
/// compression) is apart from writing, so that a caller packs chunks in parallel and writes them in
/// order; nothing is held of the image.
///
///     SpectralWriter writer(path, header, storage);
///     for (int chunk = 0; chunk < writer.chunkCount(); ++chunk)
///         writer.write(chunk, writer.pack(chunk, samples));
///     writer.commit();
///
/// The file appears at commit(), whole; without it nothing stays behind.
class SPECBAKE_API SpectralWriter {
  public:
    /// Throws FileError if the file cannot be created, ArgumentError for a wrong option.
    SpectralWriter(const std::filesystem::path& path, const SpectralHeader& header,
                   const StorageOptions& storage);
    ~SpectralWriter();
    SpectralWriter(const SpectralWriter&) = delete;
    SpectralWriter& operator=(const SpectralWriter&) = delete;

    int channelCount() const;
    int chunkCount() const;                        ///< of all levels
    const std::vector<ChunkGrid>& levels() const;  ///< the image itself first
    std::size_t chunkBytes(int chunk) const;       ///< of its samples

    /// A chunk's samples to the bytes that stand in the file, in the same memory. The samples lie
    /// row by row, within a row channel by channel (channelNames()), each channel's row contiguous.
    /// Any number of threads may pack at once. Throws FileError.
    std::vector<std::byte> pack(int chunk, std::vector<std::byte> samples) const;

    /// Appends a packed chunk, from one thread at a time. The chunks of one level go in order,
    /// those of several levels in any; all must come. Throws FileError.
    void write(int chunk, std::span<const std::byte> packed);

    /// Completes the file and puts it in its place. Throws FileError.
    void commit();

  private:
    struct SPECBAKE_LOCAL Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace specbake
