#pragma once

#include <specbake/core/spectrum.h>
#include <specbake/image/spectral_layout.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace specbake {

/// Reads a spectral EXR back through OpenImageIO, by rows. It accepts the bands of this project,
/// 380 to 780 nm every 5 nm; channels of other names are passed over.
class SpectralReader {
  public:
    /// Throws FileError if the file cannot be read or does not hold the 81 bands.
    explicit SpectralReader(const std::string& path);
    ~SpectralReader();

    const SpectralHeader& header() const;

    /// A string attribute of the file, or nothing.
    std::optional<std::string> text(const std::string& attribute) const;

    /// Rows [first, first + count), counted from 0: for each texel its kBandCount samples, from
    /// 380 nm up. `samples` holds count * width * kBandCount floats. Throws FileError.
    void readRows(int first, int count, std::span<float> samples);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace specbake
