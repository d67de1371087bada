#pragma once

#include "file/write_stream.h"

#include <specbake/image/chunk_grid.h>

#include <OpenEXR/openexr.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace specbake::internal {

/// An OpenEXRCore file being written: one part, its header written by the constructor.
class ExrContext {
  public:
    /// `file` is written, `shownAs` is what errors call it.
    ExrContext(const std::filesystem::path& file, std::string shownAs, const SpectralHeader& header,
               const StorageOptions& storage);
    ~ExrContext();
    ExrContext(const ExrContext&) = delete;
    ExrContext& operator=(const ExrContext&) = delete;

    exr_context_t get() const { return context_; }

    /// Takes space for so many bytes. Throws FileError if there is not so much.
    void reserve(std::uint64_t bytes);

    /// What OpenEXRCore's encoder asks for. Safe from several threads.
    exr_chunk_info_t chunkInfo(const ChunkGrid& level, int chunk) const;

    void writeChunk(const ChunkGrid& level, int chunk, std::span<const std::byte> packed) const;

    /// Throws FileError if a call of the library failed.
    void check(exr_result_t result) const;

    /// Writes what remains and closes the file.
    void finish();

  private:
    /// Of a chunk of scan lines, in the data window's coordinates.
    int firstRow(const ChunkGrid& level, int chunk) const;

    std::string shownAs_;
    WriteStream stream_;
    int top_;
    bool tiled_;
    exr_context_t context_ = nullptr;
};

}  // namespace specbake::internal
