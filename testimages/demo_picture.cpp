#include "picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

/// The picture of `./dev demo`. Colours go round the wheel with the angle and from grey to vivid
/// with the distance from the middle, in Björn Ottosson's Oklab (2020).
namespace testimages {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A number in [0, 1) that depends on its arguments alone (a mix of 32-bit integers).
double chance(int i, int j, int what) {
    std::uint32_t h = std::uint32_t(i) * 0x9E3779B1U ^ std::uint32_t(j) * 0x85EBCA77U ^
                      std::uint32_t(what) * 0xC2B2AE3DU;
    h = (h ^ (h >> 15)) * 0x2C1B3C6DU;
    h = (h ^ (h >> 12)) * 0x297A2D39U;
    return (h ^ (h >> 15)) / 4294967296.0;
}

double encoded(double v) {
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

using Color = std::array<double, 3>;

/// Oklab lightness, chroma and hue (radians) to linear sRGB.
Color linearFromOklch(double L, double chroma, double hue) {
    const double a = chroma * std::cos(hue);
    const double b = chroma * std::sin(hue);
    const double l = std::pow(L + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(L - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(L - 0.0894841775 * a - 1.2914855480 * b, 3);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

/// The same with as much of the chroma as sRGB can show.
Color shown(double L, double chroma, double hue) {
    for (;; chroma *= 0.97) {
        const Color c = linearFromOklch(L, chroma, hue);
        if (std::all_of(c.begin(), c.end(), [](double v) { return v >= 0 && v <= 1; })) return c;
    }
}

struct Tile {
    double x, y;     ///< middle, in tiles
    double nearest;  ///< distance from it, in tiles
    double edge;     ///< distance from the grout between it and its neighbour, in tiles
    int i, j;
};

/// The tile of a point: one middle in each unit cell, shaken; the nearest two decide.
Tile tileAt(double u, double v) {
    Tile tile{0, 0, 9, 9, 0, 0};
    double second = 9;
    for (int j = int(std::floor(v)) - 2; j <= int(std::floor(v)) + 2; ++j) {
        for (int i = int(std::floor(u)) - 2; i <= int(std::floor(u)) + 2; ++i) {
            const double x = i + 0.5 + 0.62 * (chance(i, j, 1) - 0.5);
            const double y = j + 0.5 + 0.62 * (chance(i, j, 2) - 0.5);
            const double distance = std::hypot(u - x, v - y);
            if (distance < tile.nearest) {
                second = tile.nearest;
                tile = {x, y, distance, 0, i, j};
            } else {
                second = std::min(second, distance);
            }
        }
    }
    tile.edge = (second - tile.nearest) / 2;
    return tile;
}

/// The glaze of a tile seen at (u, v): a bevel lit from the upper left, on dark grout.
Color colorAt(double u, double v, double middle) {
    const Tile tile = tileAt(u, v);
    const double dx = tile.x - middle;
    const double dy = tile.y - middle;
    const double hue = std::atan2(-dy, dx) + 0.35 * (chance(tile.i, tile.j, 3) - 0.5);
    const double reach = std::hypot(dx, dy) / middle;
    const double chroma = 0.27 * std::clamp(1.25 * reach - 0.22, 0.0, 1.0);
    const double glaze = 0.05 * ((tile.x - u) + (tile.y - v));
    const double bevel = std::clamp(1 - tile.edge / 0.13, 0.0, 1.0) * 2.2 * glaze;
    const double L = 0.66 + 0.30 * (chance(tile.i, tile.j, 4) - 0.5) + glaze + bevel;
    const Color color = shown(std::clamp(L, 0.05, 0.97), chroma, hue + 2 * kPi);
    const Color grout = shown(0.28, 0.01, 1.2);
    const double cover = std::clamp((tile.edge - 0.035) / 0.03, 0.0, 1.0);
    Color mixed;
    for (std::size_t c = 0; c < 3; ++c) mixed[c] = cover * color[c] + (1 - cover) * grout[c];
    return mixed;
}

}  // namespace

Picture mosaic(int width, int height) {
    Picture p(width, height, 3);
    constexpr double tiles = 9;
    constexpr int fine = 3;  // samples a pixel along each axis
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            Color sum{};
            for (int k = 0; k < fine * fine; ++k) {
                const double u = (x + (k % fine + 0.5) / fine) * tiles / width;
                const double v = (y + (k / fine + 0.5) / fine) * tiles / height;
                const Color c = colorAt(u, v, tiles / 2);
                for (std::size_t i = 0; i < 3; ++i) sum[i] += c[i] / (fine * fine);
            }
            for (std::size_t i = 0; i < 3; ++i) p.at(x, y)[i] = float(encoded(sum[i]));
        }
    }
    return p;
}

}  // namespace testimages
