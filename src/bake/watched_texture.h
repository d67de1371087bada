#pragma once

#include <specbake/image/texture.h>

#include <cstddef>

namespace specbake::internal {

/// A texture that passes its rows on, and looks at some of their texels on the way: whether they
/// are colours at all.
class WatchedTexture : public Texture {
  public:
    explicit WatchedTexture(Texture& texture) : texture_(texture) {}

    const TextureInfo& info() const override { return texture_.info(); }
    void readRows(int first, int count, std::span<std::byte> samples) override;

    /// Whether nearly all texels seen are unit vectors around (½, ½, 1), as a normal map stores
    /// them: |2c − 1| within a tenth of 1, the third component above ½.
    bool holdsNormals() const;

  private:
    void look(std::span<const std::byte> row);

    Texture& texture_;
    std::size_t seen_ = 0;
    std::size_t normals_ = 0;
};

}  // namespace specbake::internal
