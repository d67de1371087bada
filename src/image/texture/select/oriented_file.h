#pragma once

#include "texture/image_file.h"

namespace specbake::internal {

/// A file whose texels are turned as Exif and TIFF would have it shown (TIFF 6.0, tag 274): the
/// windows, the aspect ratio and the resolutions with them. Turned rows come from many rows of the
/// file, which are read in order: as many turned rows as `mostBytes` hold are made in one pass over
/// the file and kept, so that most files are read once, and none takes more memory.
class OrientedFile : public ImageFile {
  public:
    static constexpr std::size_t kMostBytes = std::size_t(1) << 30;

    explicit OrientedFile(std::unique_ptr<ImageFile> file, std::size_t mostBytes = kMostBytes);

    std::optional<std::string> text(const std::string& attribute) const override {
        return file_->text(attribute);
    }

  private:
    void unpackRows(int first, int count, TexelType type, std::span<std::byte> samples) override;
    void fill(int first, int count, TexelType type);
    void fillFromRow(int sourceRow, int first, int count, TexelType type);

    std::unique_ptr<ImageFile> file_;
    std::size_t mostBytes_;
    std::vector<std::byte> source_;  ///< a row of the file
    std::vector<std::byte> kept_;    ///< turned rows [keptFirst_, keptEnd_), samples of keptType_
    int keptFirst_ = 0;
    int keptEnd_ = 0;
    TexelType keptType_ = TexelType::uint8;
};

}  // namespace specbake::internal
