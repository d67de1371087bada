#include "read_back.h"

#include <stdexcept>

namespace specbake::testing {

ReadBack::ReadBack(const std::string& path, int mipLevel) {
    OIIO::ImageSpec wishes;
    wishes["oiio:UnassociatedAlpha"] = 1;
    auto in = OIIO::ImageInput::open(path, &wishes);
    if (!in) throw std::runtime_error(path + ": " + OIIO::geterror());
    if (!in->seek_subimage(0, mipLevel)) throw std::runtime_error(path + ": no such level");
    spec = in->spec();
    samples.resize(spec.image_pixels() * std::size_t(spec.nchannels));
    if (!in->read_image(0, mipLevel, 0, spec.nchannels, OIIO::TypeFloat, samples.data())) {
        throw std::runtime_error(path + ": " + in->geterror());
    }
}

float ReadBack::at(int x, int y, const std::string& channel) const {
    const int c = spec.channelindex(channel);
    if (c < 0) throw std::runtime_error("no channel " + channel);
    const std::size_t texel = std::size_t(y) * std::size_t(spec.width) + std::size_t(x);
    return samples.at(texel * std::size_t(spec.nchannels) + std::size_t(c));
}

std::array<float, 81> ReadBack::bands(int x, int y) const {
    std::array<float, 81> values{};
    for (int i = 0; i < 81; ++i) values[std::size_t(i)] = at(x, y, bandName(380 + 5 * i));
    return values;
}

std::string bandName(int nm) {
    return "T." + std::to_string(nm) + ",000000nm";
}

void writeImage(const std::string& path, const OIIO::ImageSpec& spec,
                const std::vector<float>& samples) {
    auto out = OIIO::ImageOutput::create(path);
    const bool good = out && out->open(path, spec) &&
                      out->write_image(OIIO::TypeFloat, samples.data()) && out->close();
    if (!good) throw std::runtime_error(path + ": " + (out ? out->geterror() : OIIO::geterror()));
}

}  // namespace specbake::testing
