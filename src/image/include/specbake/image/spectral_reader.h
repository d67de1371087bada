#pragma once

#include <specbake/core/api.h>
#include <specbake/image/spectral_layout.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace specbake {

/// How a file is stored, in words for a user.
struct StorageFacts {
    int channels = 0;
    std::string sampleType;   ///< "half", "float"; of the first channel
    std::string compression;  ///< "zip", …
    int tileWidth = 0;        ///< 0: scan lines
    int tileHeight = 0;
    int levels = 1;  ///< of a mipmap; the first is the one that is read
    std::vector<std::pair<std::string, std::string>> attributes;  ///< by name, values as text
};

/// Reads a spectral EXR back, by rows. It accepts bands of any wavelengths; channels of other names
/// are passed over.
class SPECBAKE_API SpectralReader {
  public:
    /// Throws FileError if the file cannot be read, has not two bands, or not all those that
    /// specbake wrote.
    explicit SpectralReader(const std::string& path);
    ~SpectralReader();

    const SpectralHeader& header() const;

    StorageFacts facts() const;

    /// Of its bands, nm, ascending.
    const std::vector<double>& wavelengths() const;

    /// What its samples are stored as.
    TexelType storedType() const;

    /// The names of all its channels, sorted.
    std::vector<std::string> channels() const;

    /// A string attribute of the file, or an integer in decimal; or nothing.
    std::optional<std::string> text(const std::string& attribute) const;

    /// Rows [first, first + count), counted from 0: for each texel the samples of its N bands, as
    /// wavelengths() lists them. `samples` holds count * width * N floats. Throws FileError.
    /// `alpha`, unless empty, gets count * width floats where the header says that there is alpha.
    /// `preview`, unless empty, gets count * width times R, G, B where hasPreview().
    void readRows(int first, int count, std::span<float> samples, std::span<float> alpha = {},
                  std::span<float> preview = {});

    /// Whether there are channels R, G and B.
    bool hasPreview() const;

  private:
    struct SPECBAKE_LOCAL Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace specbake
