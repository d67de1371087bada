#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace specbake::internal {

/// Rows of one subimage of a file, at its first mip level, whether it is stored in scan lines or in
/// tiles. Channels are interleaved, in the file's order.
class RowSource {
  public:
    /// Throws FileError if the file cannot be opened or is no image of bounded size.
    /// Colour is not multiplied by alpha unless the file holds it so.
    /// `raw`: inks and Lab come as they are stored, not as the library would mix them.
    RowSource(std::string path, int subimage, bool raw = false);

    /// What the file says of the subimage, made consistent and free of the reader's quirks.
    const OIIO::ImageSpec& spec() const { return spec_; }
    const std::vector<std::string>& remarks() const { return remarks_; }
    OIIO::ImageInput& input() { return *input_; }

    /// Rows [first, first + count), counted from 0, as samples of that type, for which there must
    /// be room. Throws FileError.
    void read(int first, int count, const OIIO::TypeDesc& type, std::span<std::byte> samples);

  private:
    void checkUnchanged() const;
    void readTileRow(int tileRow, const OIIO::TypeDesc& type);
    [[noreturn]] void fail();

    std::string path_;
    int subimage_;
    std::unique_ptr<OIIO::ImageInput> input_;
    OIIO::ImageSpec spec_;
    std::vector<std::string> remarks_;
    std::vector<std::byte> tiles_;  ///< row tileRow_ of the tiles, as samples of tileType_
    int tileRow_ = -1;
    OIIO::TypeDesc tileType_;
};

}  // namespace specbake::internal
