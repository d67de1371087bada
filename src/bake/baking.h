#pragma once

#include "band.h"
#include "mip/level_tiles.h"
#include "texel_source.h"

#include <specbake/bake/bake.h>
#include <specbake/core/upsampler.h>
#include <specbake/image/spectral_sink.h>

#include <tbb/concurrent_queue.h>

#include <array>
#include <span>
#include <vector>

namespace specbake::internal {

/// One texture on its way to a sink: what the three stages of the pipeline share.
class Baking {
  public:
    /// `bits`: of the mantissa of half samples. All that it is given must outlive it.
    Baking(const TexelSource& source, const Upsampler& upsampler, SpectralSink& sink, int bits);

    /// Before run(). Images change samples in the order in which they were added.
    void add(const ImageBeside& image) { beside_.push_back({&image, {}}); }

    /// All rows, read, solved, packed and written. Throws FileError for texels that have no
    /// spectrum, naming the first, and Cancelled.
    ColorCensus run(const std::function<void(double)>& progress);

    /// After run(): of all texels.
    const BesideCensus& besideCensus() const { return besideCensus_; }

  private:
    /// What one band's work leaves for that of another. There are as many as bands in work, however
    /// many threads take turns.
    struct Buffers {
        std::vector<std::array<float, 3>> colors;
        std::vector<float> alpha;
        std::vector<float> unrounded;  ///< samples, where they are mixed or get fewer bits
        Upsampler::Workspace upsampling;
    };

    std::vector<Band> bandsOf() const;
    std::size_t bandBytes(const Band& band) const;
    void readBand(Band& band);
    void processBand(Band& band);
    void reduceBand(Band& band, Buffers& buffers);
    void writeBand(Band& band);
    bool hasLevels() const { return sink_.levels().size() > 1; }
    /// Halves of fewer bits than they have.
    bool isShort(SampleType type) const {
        return type == SampleType::half && bits_ < BakeOptions::kMostMantissaBits;
    }
    void solveNodes(const Band& band, Buffers& buffers);
    std::size_t noteNodes(const Band& band, int row, Buffers& buffers);
    /// Colours and alpha of some neighbours in one row, into the buffers.
    void decodeRun(const Band& band, const Window& run, Buffers& buffers) const;
    /// Samples of some neighbours in one row, plane by plane.
    void bakeRun(const Band& band, const Window& run, SampleType type, Buffers& buffers,
                 std::span<std::byte> samples, ColorCensus& census, BesideCensus& beside);
    void store(std::span<const float> samples, SampleType type, std::byte* to) const;
    TexelRow unroundedRow(const Band& band, int row, Buffers& buffers);

    const TexelSource& source_;
    const Upsampler& upsampler_;
    struct Beside {
        const ImageBeside* image;
        std::vector<std::byte> readAhead;
    };
    std::vector<Beside> beside_;
    SpectralSink& sink_;
    int bits_;
    SampleSelection channels_;
    std::vector<std::byte> readAhead_;  ///< of the texture
    Pyramid pyramid_;
    LevelTiles levelTiles_;
    ColorCensus census_;
    BesideCensus besideCensus_;
    tbb::concurrent_queue<Buffers> idle_;
    /// Memory of chunks that are written, for those to come: fresh pages cost more than a copy.
    tbb::concurrent_queue<std::vector<std::byte>> spare_;
};

}  // namespace specbake::internal
