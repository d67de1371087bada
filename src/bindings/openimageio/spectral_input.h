#pragma once

#include <specbake/bake/baked_image.h>

#include <OpenImageIO/imageio.h>

#include <memory>
#include <string>
#include <vector>

namespace specbake::openimageio {

/// What a bake of a texture would write, as an image of OpenImageIO's: tiles and mip levels are
/// computed when they are read, channels that are not read are not computed. The host's settings
/// are neither looked at nor changed. Any number of threads may read at once.
class SpectralInput final : public OIIO::ImageInput {
  public:
    const char* format_name() const override { return "spectral"; }
    int supports(OIIO::string_view feature) const override;
    bool valid_file(const std::string& name) const override;
    bool open(const std::string& name, OIIO::ImageSpec& spec) override;
    /// Hints named "spectral:" and an option override the text file's.
    bool open(const std::string& name, OIIO::ImageSpec& spec,
              const OIIO::ImageSpec& config) override;
    bool close() override;
    int current_subimage() const override { return 0; }
    int current_miplevel() const override { return level_; }
    bool seek_subimage(int subimage, int miplevel) override;
    OIIO::ImageSpec spec(int subimage, int miplevel) override;
    OIIO::ImageSpec spec_dimensions(int subimage, int miplevel) override;
    /// Where the image's edge cuts tiles, OpenImageIO's own would read all their channels.
    bool read_tiles(int subimage, int miplevel, int xbegin, int xend, int ybegin, int yend,
                    int zbegin, int zend, int chbegin, int chend, OIIO::TypeDesc format, void* data,
                    OIIO::stride_t xstride, OIIO::stride_t ystride,
                    OIIO::stride_t zstride) override;
    bool read_native_scanline(int subimage, int miplevel, int y, int z, void* data) override;
    bool read_native_tile(int subimage, int miplevel, int x, int y, int z, void* data) override;
    bool read_native_tiles(int subimage, int miplevel, int xbegin, int xend, int ybegin, int yend,
                           int zbegin, int zend, void* data) override;
    bool read_native_tiles(int subimage, int miplevel, int xbegin, int xend, int ybegin, int yend,
                           int zbegin, int zend, int chbegin, int chend, void* data) override;

  private:
    struct Region {
        Window at;  ///< in the level's pixels, from its corner
        int firstChannel = 0;
        int endChannel = 0;
    };

    bool exists(int subimage, int miplevel) const;
    void readRegion(int miplevel, const Region& region, std::byte* data) const;

    std::unique_ptr<const BakedImage> image_;
    std::vector<OIIO::ImageSpec> specs_;  ///< of each level
    std::vector<int> channels_;           ///< numbers in the file, in OpenImageIO's order
    int level_ = 0;
};

}  // namespace specbake::openimageio
