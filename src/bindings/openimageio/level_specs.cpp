#include "level_specs.h"

#include <specbake/image/spectral_layout.h>

#include <algorithm>
#include <string>

namespace specbake::openimageio {
namespace {

void addAttribute(OIIO::ImageSpec& spec, const std::string& name, const std::string& value) {
    spec.attribute(name, value);
}

void addAttribute(OIIO::ImageSpec& spec, const std::string& name, int value) {
    spec.attribute(name, value);
}

void addAttribute(OIIO::ImageSpec& spec, const std::string& name, float value) {
    spec.attribute(name, value);
}

void addAttribute(OIIO::ImageSpec& spec, const std::string& name, const std::vector<float>& value) {
    using Type = OIIO::TypeDesc;
    const std::size_t size = value.size();
    const auto aggregate = size == 2    ? Type::VEC2
                           : size == 3  ? Type::VEC3
                           : size == 9  ? Type::MATRIX33
                           : size == 16 ? Type::MATRIX44
                                        : Type::SCALAR;
    const int length = aggregate == Type::SCALAR ? int(size) : 0;
    spec.attribute(name, Type(Type::FLOAT, aggregate, Type::NOSEMANTICS, length), value.data());
}

OIIO::ImageSpec firstSpec(const BakedImage& image) {
    const SpectralHeader& header = image.header();
    const std::vector<std::string> names = channelNames(header.alpha, header.bands);
    const bool half = image.sampleType() == SampleType::half;
    OIIO::ImageSpec spec(header.data.width, header.data.height, int(names.size()),
                         half ? OIIO::TypeHalf : OIIO::TypeFloat);
    spec.x = header.data.x;
    spec.y = header.data.y;
    spec.full_x = header.display.x;
    spec.full_y = header.display.y;
    spec.full_width = header.display.width;
    spec.full_height = header.display.height;
    spec.tile_width = image.levels().front().chunkWidth;
    spec.tile_height = image.levels().front().chunkHeight;
    spec.tile_depth = 1;
    spec.channelnames.clear();
    for (const int channel : readersOrder(header.alpha, header.bands.count)) {
        spec.channelnames.push_back(names[std::size_t(channel)]);
    }
    spec.alpha_channel = header.alpha ? 3 : -1;
    for (const auto& [name, value] : header.attributes) {
        std::visit([&, &key = name](const auto& v) { addAttribute(spec, key, v); }, value);
    }
    spec.attribute("PixelAspectRatio", header.pixelAspectRatio);
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("oiio:subimages", 1);
    return spec;
}

}  // namespace

std::vector<int> readersOrder(bool alpha, int bands) {
    const int first = alpha ? 1 : 0;  // B, G, R and the bands come behind A
    std::vector<int> order = {first + 2, first + 1, first};
    if (alpha) order.push_back(0);
    for (int band = 0; band < bands; ++band) {
        order.push_back(first + int(kPreviewSamples) + band);
    }
    return order;
}

std::vector<OIIO::ImageSpec> levelSpecs(const BakedImage& image) {
    std::vector<OIIO::ImageSpec> specs = {firstSpec(image)};
    for (std::size_t i = 1; i < image.levels().size(); ++i) {
        OIIO::ImageSpec spec = specs.back();
        spec.width = image.levels()[i].width;
        spec.height = image.levels()[i].height;
        spec.full_x = spec.x;  // the EXR reader says so: a level's display window is its data
        spec.full_y = spec.y;
        spec.full_width = spec.width;
        spec.full_height = spec.height;
        specs.push_back(std::move(spec));
    }
    return specs;
}

}  // namespace specbake::openimageio
