#pragma once

#include "texture/color/color_signs.h"

#include <specbake/image/image_types.h>
#include <specbake/image/spectral_reader.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace specbake::internal {

/// One part (subimage) of a file at its first mip level, in the types of no library that reads
/// files.
struct ImageDescription {
    Window data;     ///< where there are pixels
    Window display;  ///< what is meant to be seen
    float pixelAspectRatio = 1;
    std::vector<std::string> channels;        ///< names, in the order of a pixel's samples
    std::optional<int> alpha;                 ///< the index of the alpha channel
    bool associatedAlpha = false;             ///< colour is multiplied by alpha
    TexelType sampleType = TexelType::uint8;  ///< as stored, or the next larger that is offered
    /// The file holds integers: samples, of whatever type, are shares of the largest.
    bool integers = true;
    /// How it is to be shown, as Exif and TIFF count: 1 as it is stored, 2 to 8 turned or mirrored.
    int orientation = 1;
    ColorSigns signs;                ///< what the file says of its colours
    Attributes attributes;           ///< metadata worth keeping
    std::string parts;               ///< "0 (left), 1 (right)", if there is more than one
    std::vector<std::string> notes;  ///< one line each on what of the file is not used
};

/// An open image whose rows can be read. Every implementation gives the same for the same file.
class ImageFile {
  public:
    explicit ImageFile(ImageDescription description) : description_(std::move(description)) {}
    virtual ~ImageFile() = default;
    ImageFile(const ImageFile&) = delete;
    ImageFile& operator=(const ImageFile&) = delete;

    const ImageDescription& description() const { return description_; }

    /// A string attribute, or an integer in decimal, under the name by which OpenImageIO knows it;
    /// or nothing.
    virtual std::optional<std::string> text(const std::string& attribute) const = 0;

    /// What OpenImageIO would say of how the file is stored, where that is known without it.
    virtual std::optional<StorageFacts> facts() const { return {}; }

    /// Rows [first, first + count) of the data window, counted from 0, channels interleaved, as
    /// samples of the given type: the file's own, or float32. Throws FileError; ArgumentError for
    /// a buffer too small.
    void readRows(int first, int count, TexelType type, std::span<std::byte> samples);

  protected:
    /// Of one row, as samples of that type.
    std::size_t rowBytes(TexelType type) const;

  private:
    /// What readRows() promises, for a buffer of at least the size.
    virtual void unpackRows(int first, int count, TexelType type, std::span<std::byte> samples) = 0;

    ImageDescription description_;
};

/// Opens a file with the lightest reader that knows all that is in it; OpenImageIO is the last.
/// Throws FileError if it cannot be opened or is no image of bounded size.
///
/// `part`: the name or the number (from 0) of one of several; none: the first.
std::unique_ptr<ImageFile> openImageFile(const std::string& path,
                                         const std::optional<std::string>& part = {});

/// 1 for what is none of the eight orientations.
int validOrientation(int stored);

/// Throws FileError for sides of no or of more than kLargestSide pixels, and for more pixels than
/// the limits() allow.
void checkSides(const std::string& path, long long width, long long height);

/// Whether a window lies where OpenEXR takes none, and where sums of its numbers overflow.
bool isFarOut(const Window& window);

/// Throws FileError if the limits() do not allow so many bytes.
void checkMemory(const std::string& path, std::uint64_t bytes);

}  // namespace specbake::internal
