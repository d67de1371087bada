#include "spectrum_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace specbake::tool {
namespace {

// Of the drawing, in its own units; y grows downwards.
constexpr double kWidth = 720, kHeight = 420;
constexpr double kLeft = 62, kRight = 560, kTop = 44, kBottom = 362;

/// Colours after M. Okabe and K. Ito, which the colour-blind tell apart too; all of them stand out
/// from white and from black.
constexpr std::array kStrokes = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};

constexpr const char* kStyle =
    "<style>\n"
    "  text { font: 13px sans-serif; fill: #222 }\n"
    "  .title { font-size: 15px; font-weight: bold }\n"
    "  .grid { stroke: #888; stroke-opacity: 0.3 }\n"
    "  .axis { stroke: #888; fill: none }\n"
    "  .curve { fill: none; stroke-width: 2; stroke-linejoin: round }\n"
    "  .page { fill: #fff }\n"
    "  @media (prefers-color-scheme: dark) { text { fill: #ddd } .page { fill: #16181c } }\n"
    "</style>\n";

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    }
    return result;
}

std::string label(double x, double y, const char* anchor, const std::string& text) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">", x, y, anchor) +
           escaped(text) + "</text>\n";
}

/// From data to drawing.
struct Frame {
    double first = 380, last = 780;  ///< nm
    double least = 0, largest = 1;   ///< of the reflectance axis

    double x(double nm) const { return kLeft + (nm - first) / (last - first) * (kRight - kLeft); }
    double y(double reflectance) const {
        return kBottom - (reflectance - least) / (largest - least) * (kBottom - kTop);
    }
};

/// Fifths, so that every tick of the axis is a number with one decimal.
Frame frameOf(const std::vector<double>& wavelengths, const std::vector<Curve>& curves) {
    Frame frame;
    frame.first = wavelengths.front();
    frame.last = wavelengths.back();
    for (const Curve& curve : curves) {
        for (const double value : curve.spectrum) {
            if (!std::isfinite(value)) continue;
            frame.least = std::min(frame.least, std::floor(value * 5) / 5);
            frame.largest = std::max(frame.largest, std::ceil(value * 5) / 5);
        }
    }
    return frame;
}

/// Multiples of 50 nm, some ten of them at most.
double tickStep(const Frame& frame) {
    return 50 * std::ceil((frame.last - frame.first) / 500);
}

std::string axes(const Frame& frame) {
    std::string svg;
    for (double nm = std::ceil(frame.first / 50) * 50; nm <= frame.last; nm += tickStep(frame)) {
        const double x = frame.x(nm);
        svg +=
            fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", x, kTop, kBottom);
        svg += label(x, kBottom + 20, "middle", fmt::format("{:g}", nm));
    }
    const int ticks = std::min(int(std::lround((frame.largest - frame.least) * 5)), 20);
    for (int i = 0; i <= ticks; ++i) {
        const double value = frame.least + (frame.largest - frame.least) * i / ticks;
        const double y = frame.y(value);
        svg +=
            fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n", kLeft, y, kRight);
        svg += label(kLeft - 8, y + 4.5, "end", fmt::format("{:.1f}", value));
    }
    svg += fmt::format("<path class=\"axis\" d=\"M{:.1f} {:.1f}V{:.1f}H{:.1f}\"/>\n", kLeft, kTop,
                       kBottom, kRight);
    svg += label((kLeft + kRight) / 2, kBottom + 44, "middle", "wavelength (nm)");
    svg +=
        fmt::format("<text transform=\"translate(18 {:.1f}) rotate(-90)\" text-anchor=\"middle\">",
                    (kTop + kBottom) / 2);
    return svg + "reflectance</text>\n";
}

std::string polyline(const Frame& frame, const std::vector<double>& wavelengths, const Curve& curve,
                     const char* stroke) {
    std::string svg = fmt::format("<polyline class=\"curve\" stroke=\"{}\" points=\"", stroke);
    for (std::size_t band = 0; band < wavelengths.size(); ++band) {
        const double value = curve.spectrum[band];
        if (!std::isfinite(value)) continue;
        svg += fmt::format("{:.1f},{:.1f} ", frame.x(wavelengths[band]), frame.y(value));
    }
    return svg + "\"/>\n";
}

}  // namespace

std::string spectrumPlot(const std::string& title, const std::vector<double>& wavelengths,
                         const std::vector<Curve>& curves) {
    const Frame frame = frameOf(wavelengths, curves);
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" width=\"{}\" "
        "height=\"{}\">\n",
        kWidth, kHeight, kWidth, kHeight);
    svg += kStyle;
    svg += fmt::format("<rect class=\"page\" width=\"{}\" height=\"{}\"/>\n", kWidth, kHeight);
    svg += "<text class=\"title\" x=\"62\" y=\"26\">" + escaped(title) + "</text>\n";
    svg += axes(frame);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const char* stroke = kStrokes[i % kStrokes.size()];
        svg += polyline(frame, wavelengths, curves[i], stroke);
        const double y = kTop + 12 + 22 * double(i);
        svg += fmt::format("<path class=\"curve\" stroke=\"{}\" d=\"M{:.1f} {:.1f}h22\"/>\n",
                           stroke, kRight + 14, y - 4.5);
        svg += label(kRight + 42, y, "start", curves[i].name);
    }
    return svg + "</svg>\n";
}

}  // namespace specbake::tool
