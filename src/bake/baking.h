#pragma once

#include "band.h"
#include "job.h"
#include "mip/level_tiles.h"

#include <specbake/image/spectral_writer.h>

#include <tbb/concurrent_queue.h>
#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <span>
#include <vector>

namespace specbake {

/// One texture on its way to its file: what the three stages of the pipeline share.
class Baking {
  public:
    /// `bits`: of the mantissa of half samples.
    Baking(Job& job, SpectrumLookup& lookup, SpectralWriter& writer, const StorageOptions& storage,
           int bits);

    /// All rows, read, solved, packed and written; the writer is not committed. Throws FileError
    /// for texels that have no spectrum, naming the first, and Cancelled.
    TexelCensus run(const std::function<void(double)>& progress);

  private:
    std::vector<Band> bandsOf() const;
    void readBand(Band& band);
    void processBand(Band& band);
    void reduceBand(Band& band);
    void writeBand(Band& band);
    bool hasLevels() const { return writer_.levels().size() > 1; }
    /// What a thread keeps from band to band.
    struct Buffers {
        std::vector<std::array<float, 3>> colors;
        std::vector<float> alpha;
        std::vector<Mix> mixes;
    };
    /// Samples of some neighbours in one row, plane by plane.
    void blendRun(const Band& band, const Window& run, BlendType type, Buffers& buffers,
                  std::span<std::byte> samples, TexelCensus& census);
    TexelRow unroundedRow(const Band& band, int row);
    BlendType blendType() const;

    Job& job_;
    SpectrumLookup& lookup_;
    SpectralWriter& writer_;
    StorageOptions storage_;
    int bits_;
    std::vector<std::byte> readAhead_;  ///< of the texture
    Pyramid pyramid_;
    LevelTiles levelTiles_;
    TexelCensus census_;
    tbb::enumerable_thread_specific<Buffers> buffers_;
    /// Memory of chunks that are written, for those to come: fresh pages cost more than a copy.
    tbb::concurrent_queue<std::vector<std::byte>> spare_;
};

}  // namespace specbake
