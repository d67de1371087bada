/// Writes the images of this folder (README.md):  make_testimages FOLDER
/// The same bytes each time, for one version of OpenImageIO and its libraries.
#include "palette_png.h"
#include "picture.h"

#include <specbake/core/observer.h>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <cstdio>
#include <stdexcept>

using namespace testimages;

namespace {

std::string folder;

/// Formats that hold a date get this one, else they would hold today's.
constexpr const char* kDate = "2000:01:01 00:00:00";

OIIO::ImageSpec specOf(const Picture& p, OIIO::TypeDesc type) {
    OIIO::ImageSpec spec(p.width, p.height, p.channels, type);
    if (p.channels == 2) spec.channelnames = {"Y", "A"};
    if (p.channels == 2) spec.alpha_channel = 1;
    spec.attribute("DateTime", kDate);
    return spec;
}

/// Values above 255/256 of an integer type go to its largest: OpenImageIO rounds.
void write(const std::string& name, const Picture& p, const OIIO::ImageSpec& spec) {
    auto out = OIIO::ImageOutput::create(name);
    const std::string path = folder + "/" + name;
    const bool good = out && out->open(path, spec) &&
                      out->write_image(OIIO::TypeFloat, p.values.data()) && out->close();
    if (!good) throw std::runtime_error(path + ": " + (out ? out->geterror() : OIIO::geterror()));
}

void write(const std::string& name, const Picture& p, OIIO::TypeDesc type = OIIO::TypeUInt8) {
    write(name, p, specOf(p, type));
}

/// With colours that the file does not hold multiplied by alpha.
OIIO::ImageSpec unassociated(OIIO::ImageSpec spec) {
    spec.attribute("oiio:UnassociatedAlpha", 1);
    return spec;
}

OIIO::ImageSpec tiled(OIIO::ImageSpec spec, int side) {
    spec.tile_width = spec.tile_height = side;
    return spec;
}

void writePng() {
    const Picture rgb = wheel(24, 16, 0.8);
    write("rgb8.png", rgb);
    write("rgb16.png", rgb, OIIO::TypeUInt16);
    write("grey8.png", greyOf(rgb));
    write("grey16.png", greyOf(rgb), OIIO::TypeUInt16);
    const Picture greyAlpha = withAlpha(greyOf(rgb));
    write("grey_alpha8.png", greyAlpha, unassociated(specOf(greyAlpha, OIIO::TypeUInt8)));
    const Picture rgba = withAlpha(rgb);
    write("rgba8.png", rgba, unassociated(specOf(rgba, OIIO::TypeUInt8)));
    write("rgba16.png", rgba, unassociated(specOf(rgba, OIIO::TypeUInt16)));
    writePalettePng(folder + "/palette.png");
    write("1x1.png", wheel(1, 1, 0.6, false));
    write("1x37.png", wheel(1, 37, 0.8, false));
    write("41x1.png", wheel(41, 1, 0.8));
    write("17x33.png", wheel(17, 33, 1.0));
    write("demo.png", mosaic(256, 256));
}

void writeOtherIntegers() {
    const Picture rgb = wheel(24, 16, 0.8);
    OIIO::ImageSpec jpeg = specOf(rgb, OIIO::TypeUInt8);
    jpeg.attribute("Compression", "jpeg:95");
    write("rgb8.jpg", rgb, jpeg);
    write("grey8.jpg", greyOf(rgb));
    jpeg.attribute("Orientation", 6);
    write("orientation6.jpg", rgb, jpeg);
    write("rgb8.tga", rgb);
    write("rgba8.tga", withAlpha(rgb), unassociated(specOf(withAlpha(rgb), OIIO::TypeUInt8)));
    write("rgb8.bmp", rgb);
}

/// Tile by tile, those at the edge filled up with 0 (write_image leaves there what memory held).
void writeTiledTiff(const std::string& name, const Picture& p, int side) {
    Picture padded(p.width + side, p.height + side, p.channels);
    Picture source = p;
    for (int y = 0; y < p.height; ++y) {
        std::copy_n(source.at(0, y), p.width * p.channels, padded.at(0, y));
    }
    const std::string path = folder + "/" + name;
    auto out = OIIO::ImageOutput::create(name);
    bool good = out && out->open(path, tiled(specOf(p, OIIO::TypeUInt16), side));
    const auto texel = OIIO::stride_t(std::size_t(p.channels) * sizeof(float));
    for (int y = 0; y < p.height; y += side) {
        for (int x = 0; x < p.width; x += side) {
            good = good && out->write_tile(x, y, 0, OIIO::TypeFloat, padded.at(x, y), texel,
                                           texel * padded.width);
        }
    }
    if (!good || !out->close()) throw std::runtime_error(path + ": cannot be written");
}

void writeSubimages(const std::string& name) {
    const Picture first = wheel(12, 8, 0.8);
    const Picture second = wheel(6, 4, 0.2);
    const std::vector<OIIO::ImageSpec> specs = {specOf(first, OIIO::TypeUInt8),
                                                specOf(second, OIIO::TypeUInt8)};
    const std::string path = folder + "/" + name;
    auto out = OIIO::ImageOutput::create(name);
    const bool good = out && out->open(path, 2, specs.data()) &&
                      out->write_image(OIIO::TypeFloat, first.values.data()) &&
                      out->open(path, specs[1], OIIO::ImageOutput::AppendSubimage) &&
                      out->write_image(OIIO::TypeFloat, second.values.data()) && out->close();
    if (!good) throw std::runtime_error(path + ": " + (out ? out->geterror() : OIIO::geterror()));
}

void writeTiff() {
    const Picture rgb = wheel(24, 16, 0.8);
    OIIO::ImageSpec described = specOf(rgb, OIIO::TypeUInt8);
    described.attribute("ImageDescription", "a colour wheel");
    described.attribute("Artist", "testimages");
    write("rgb8.tif", rgb, described);
    write("rgb_float.tif", rgb, OIIO::TypeFloat);
    OIIO::ImageSpec half = specOf(rgb, OIIO::TypeHalf);
    half.attribute("tiff:half", 1);
    write("rgb_half.tif", rgb, half);
    writeTiledTiff("rgb16_tiled.tif", wheel(40, 35, 0.8), 16);
    const Picture rgba = withAlpha(rgb);
    write("rgba16_associated.tif", associated(rgba), OIIO::TypeUInt16);
    write("rgba8_unassociated.tif", rgba, unassociated(specOf(rgba, OIIO::TypeUInt8)));
    writeSubimages("two_subimages.tif");
}

void writeExrStorage() {
    const Picture rgb = wheel(24, 16, 0.8);
    write("rgb_half.exr", rgb, OIIO::TypeHalf);
    OIIO::ImageSpec described = specOf(rgb, OIIO::TypeFloat);
    described.attribute("owner", "testimages");
    described.attribute("comments", "a colour wheel");
    described.attribute("FocalLength", 35.0F);
    described.attribute("PixelAspectRatio", 2.0F);
    write("rgb_float.exr", rgb, described);
    write("rgba_half.exr", associated(withAlpha(rgb)), OIIO::TypeHalf);
    OIIO::ImageSpec offset = specOf(rgb, OIIO::TypeHalf);
    offset.x = -7;
    offset.y = 5;
    offset.full_x = -10;
    offset.full_y = -20;
    offset.full_width = 64;
    offset.full_height = 48;
    write("offset.exr", rgb, offset);
    const Picture larger = wheel(40, 35, 0.8);
    OIIO::ImageSpec shifted = tiled(specOf(larger, OIIO::TypeHalf), 16);
    shifted.x = 3;
    shifted.y = -9;
    write("tiled_offset.exr", larger, shifted);
    write("grey_float.exr", greyOf(rgb), [&] {
        OIIO::ImageSpec spec = specOf(greyOf(rgb), OIIO::TypeFloat);
        spec.channelnames = {"Y"};
        return spec;
    }());
}

void writeMipmaps(const std::string& name) {
    const Picture p = wheel(32, 32, 0.8);
    OIIO::ImageBuf buffer(specOf(p, OIIO::TypeFloat));
    buffer.set_pixels(buffer.roi(), OIIO::TypeFloat, p.values.data());
    OIIO::ImageSpec config(p.width, p.height, p.channels, OIIO::TypeHalf);
    config.tile_width = config.tile_height = 16;
    config.attribute("DateTime", kDate);
    const std::string path = folder + "/" + name;
    if (!OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, buffer, path,
                                          config)) {
        throw std::runtime_error(path + ": " + OIIO::geterror());
    }
}

OIIO::ImageSpec withChromaticities(OIIO::ImageSpec spec, const std::string& space) {
    const specbake::Primaries p = *specbake::findColorSpace(space)->primaries;
    std::vector<float> values;
    for (const auto& c : {p.red, p.green, p.blue, p.white}) {
        values.push_back(float(c.x));
        values.push_back(float(c.y));
    }
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), values.data());
    return spec;
}

/// Linear Rec.709 to XYZ beside E's white.
std::array<std::array<double, 3>, 3> xyzFromRec709() {
    const auto m = specbake::xyzFromRGB(*specbake::findColorSpace("lin_rec709"),
                                        specbake::Observer("E").white());
    std::array<std::array<double, 3>, 3> rows{};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) rows[std::size_t(i)][std::size_t(j)] = m[i][j];
    }
    return rows;
}

void writeExrSpaces() {
    const Picture soft = wheel(24, 16, 0.35);
    write("acescg_half.exr", soft, withChromaticities(specOf(soft, OIIO::TypeHalf), "acescg"));
    write("rec2020_float.exr", soft,
          withChromaticities(specOf(soft, OIIO::TypeFloat), "lin_rec2020"));
    const Picture xyz = transformed(wheel(24, 16, 0.8, false), xyzFromRec709());
    OIIO::ImageSpec spec = specOf(xyz, OIIO::TypeFloat);
    spec.channelnames = {"X", "Y", "Z"};
    write("xyz_float.exr", xyz, spec);
    write("rgb.hdr", wheel(24, 16, 0.8), OIIO::TypeFloat);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc != 2) throw std::runtime_error("usage: make_testimages FOLDER");
        folder = argv[1];
        writePng();
        writeOtherIntegers();
        writeTiff();
        writeExrStorage();
        writeMipmaps("mipmap.exr");
        writeExrSpaces();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_testimages: %s\n", error.what());
        return 1;
    }
}
