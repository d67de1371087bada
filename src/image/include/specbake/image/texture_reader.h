#pragma once

#include <specbake/core/api.h>
#include <specbake/image/texture.h>

#include <memory>
#include <string>

namespace specbake {

/// Reads the first subimage and mip level of any file that OpenImageIO reads, by rows.
/// Throws FileError, with the file and the reason, for what cannot be read: absent, truncated,
/// deep, volumetric, larger than kLargestSide, more than four channels, four without an alpha.
class SPECBAKE_API TextureReader : public Texture {
  public:
    explicit TextureReader(const std::string& path);
    ~TextureReader() override;

    const TextureInfo& info() const override;
    void readRows(int first, int count, std::span<std::byte> samples) override;

  private:
    struct SPECBAKE_LOCAL Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace specbake
