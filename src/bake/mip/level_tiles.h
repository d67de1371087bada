#pragma once

#include "mip/pyramid.h"

#include <specbake/image/spectral_writer.h>

namespace specbake {

/// Rounds, packs and writes rows of tiles. The tiles of a row are packed by all threads of the
/// arena that the caller is in, and written in order by the caller.
class LevelTiles {
  public:
    /// `bits`: of the mantissa of half samples.
    LevelTiles(SpectralWriter& writer, SampleType type, int bits, bool alpha);

    void write(const TileRow& row);

  private:
    std::vector<std::byte> samplesOf(const TileRow& row, const Window& texels) const;

    SpectralWriter& writer_;
    SampleType type_;
    int bits_;
    bool alpha_;
};

}  // namespace specbake
