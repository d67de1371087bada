#include "picture.h"

#include <algorithm>
#include <cmath>

namespace testimages {

Picture::Picture(int w, int h, int c)
    : width(w), height(h), channels(c), values(std::size_t(w) * std::size_t(h) * std::size_t(c)) {}

float* Picture::at(int x, int y) {
    return values.data() +
           (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(channels);
}

Picture wheel(int width, int height, double saturation, bool patches) {
    Picture p(width, height, 3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double lightness = 0.1 + 0.85 * (y + 0.5) / height;
            for (int c = 0; c < 3; ++c) {
                // 1 at the channel's own hue, falling to 0 at a third of the wheel.
                const double turn = (x + 0.5) / width - c / 3.0;
                const double away = std::abs(turn - std::round(turn));
                const double pure = std::clamp(2 - 6 * away, 0.0, 1.0);
                p.at(x, y)[c] = float(lightness * (1 - saturation + saturation * pure));
            }
        }
    }
    const std::array<float, 4> greys = {1.0F, 0.0F, 0.5F, 0.18F};
    for (int x = 0; patches && x < std::min(width, int(greys.size())); ++x) {
        std::fill_n(p.at(x, 0), 3, greys[std::size_t(x)]);
    }
    return p;
}

Picture greyOf(const Picture& rgb) {
    Picture source = rgb;
    Picture grey(rgb.width, rgb.height, 1);
    for (int y = 0; y < rgb.height; ++y) {
        for (int x = 0; x < rgb.width; ++x) *grey.at(x, y) = source.at(x, y)[1];
    }
    return grey;
}

Picture withAlpha(const Picture& picture) {
    Picture source = picture;
    Picture result(picture.width, picture.height, picture.channels + 1);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            std::copy_n(source.at(x, y), picture.channels, result.at(x, y));
            result.at(x, y)[picture.channels] = float((5 - y % 6) / 5.0);
        }
    }
    return result;
}

Picture associated(const Picture& picture) {
    Picture result = picture;
    const int color = picture.channels - 1;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            float* texel = result.at(x, y);
            for (int c = 0; c < color; ++c) texel[c] *= texel[color];
        }
    }
    return result;
}

Picture transformed(const Picture& rgb, const std::array<std::array<double, 3>, 3>& matrix) {
    Picture source = rgb;
    Picture result = rgb;
    for (int y = 0; y < rgb.height; ++y) {
        for (int x = 0; x < rgb.width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                double sum = 0;
                for (std::size_t i = 0; i < 3; ++i)
                    sum += double(source.at(x, y)[i]) * matrix[i][c];
                result.at(x, y)[c] = float(sum);
            }
        }
    }
    return result;
}

}  // namespace testimages
