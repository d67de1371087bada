#pragma once

#include "png_chunks.h"

#include <isa-l/igzip_lib.h>

#include <cstdint>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace specbake {

/// The unpacked bytes of a PNG's IDAT chunks, which together are one zlib stream.
class PngStream {
  public:
    /// `data` are the IDAT chunks of the file, in order.
    PngStream(std::string path, std::vector<PngChunk> data);

    /// The next bytes. Throws FileError if there are not so many, or if they do not unpack.
    void read(std::span<std::uint8_t> bytes);

    /// From the beginning again.
    void rewind();

    [[noreturn]] void fail(const std::string& reason) const;

  private:
    bool refill();

    std::string path_;
    std::vector<PngChunk> data_;
    std::ifstream in_;
    std::unique_ptr<inflate_state> state_;
    std::vector<std::uint8_t> packed_;
    std::size_t chunk_ = 0;    ///< the one that is being read
    std::uint32_t taken_ = 0;  ///< bytes of it that have been read
};

}  // namespace specbake
