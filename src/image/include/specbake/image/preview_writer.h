#pragma once

#include <specbake/core/api.h>
#include <specbake/image/output_file.h>
#include <specbake/image/spectral_layout.h>

#include <filesystem>
#include <memory>
#include <span>

namespace specbake {

namespace internal {
class PreviewFile;
}

/// Writes a picture to be looked at, by rows, in the format of its name's extension: linear floats
/// where the format has them (EXR, HDR), else 8-bit sRGB. The file appears at commit(), whole;
/// without it nothing stays behind.
class SPECBAKE_API PreviewWriter {
  public:
    /// Windows and alpha are those of `like`; a format without them has neither.
    /// `sync`: as an OutputFile has it.
    /// Throws FileError if there is no such format or the file cannot be created.
    PreviewWriter(const std::filesystem::path& path, const SpectralHeader& like, bool sync = false);
    ~PreviewWriter();
    PreviewWriter(const PreviewWriter&) = delete;
    PreviewWriter& operator=(const PreviewWriter&) = delete;

    /// The next row: width texels of linear Rec.709 R, G, B and alpha, not multiplied by it. What
    /// an 8-bit format cannot show is clamped. Throws FileError.
    void writeRow(std::span<const float> rgba);

    /// Completes the file and puts it in its place. Throws FileError.
    void commit();

  private:
    OutputFile output_;
    std::unique_ptr<internal::PreviewFile> file_;
};

}  // namespace specbake
