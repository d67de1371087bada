#pragma once

#include "spectral/exr_context.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace specbake::internal {

/// OpenEXR's PIZ (wavelet and Huffman), by OpenEXRCore's own encoder.
class PizPacker {
  public:
    /// The context must outlive it.
    explicit PizPacker(const ExrContext& context);
    ~PizPacker();
    PizPacker(const PizPacker&) = delete;
    PizPacker& operator=(const PizPacker&) = delete;

    /// One chunk of a level, in the samples' place. Any number of threads may pack at once.
    void pack(const ChunkGrid& level, int chunk, std::vector<std::byte>& samples);

    /// Gives the encoders' memory back, before the context is finished: they need it for that.
    void release();

  private:
    class Encoder;
    std::unique_ptr<Encoder> takeEncoder(const exr_chunk_info_t& chunk);

    const ExrContext& context_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<Encoder>> idle_;  ///< kept with their memory, one a thread at most
};

}  // namespace specbake::internal
