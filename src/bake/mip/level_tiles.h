#pragma once

#include "mip/pyramid.h"

#include <specbake/image/spectral_sink.h>

namespace specbake::internal {

/// Rounds, packs and writes rows of tiles. The tiles of a row are packed by all threads of the
/// arena that the caller is in, and written in order by the caller.
class LevelTiles {
  public:
    /// `bits`: of the mantissa of half samples.
    LevelTiles(SpectralSink& sink, int bits);

    void write(const TileRow& row);

  private:
    std::vector<std::byte> samplesOf(const TileRow& row, const Window& texels) const;

    SpectralSink& sink_;
    int bits_;
};

}  // namespace specbake::internal
