#pragma once

#include "demand/block.h"
#include "demand/block_cache.h"
#include "demand/spectra.h"
#include "demand/stored_rows.h"

#include <specbake/image/chunk_grid.h>
#include <specbake/image/texel_decoder.h>

#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <memory>
#include <vector>

namespace specbake::internal {

/// Unrounded texels of any place of any level: of the image, looked up; of the others, averages of
/// the level above. Any number of threads may share it.
class LevelBlocks {
  public:
    /// All that it is given must outlive it. `levels`: the image first.
    LevelBlocks(StoredRows& rows, const TextureInfo& info, const TexelDecoder& decoder,
                const Spectra& spectra, const std::vector<ChunkGrid>& levels, std::size_t bytes);

    /// `at` lies within the level. Throws FileError.
    Block texels(int level, const Window& at, const BlockChannels& channels);

  private:
    /// Levels are cut into blocks of this side to be kept, whatever the file's chunks are.
    static constexpr int kSide = 64;

    Block sampled(const Window& at, const BlockChannels& channels);
    Block averaged(int level, const Window& at, const BlockChannels& channels);
    Block assembled(int level, const Window& at, const BlockChannels& channels);
    void addPart(Block& whole, int level, const Window& cell, const BlockChannels& channels);
    void sampleRow(const Window& at, std::span<const std::byte> stored,
                   const BlockChannels& channels, TexelRow& row);

    StoredRows& rows_;
    const TextureInfo& info_;
    const TexelDecoder& decoder_;
    const Spectra& spectra_;
    const std::vector<ChunkGrid>& levels_;
    BlockCache cache_;
    tbb::enumerable_thread_specific<std::vector<Upsampler::Color>> colors_;
};

}  // namespace specbake::internal
