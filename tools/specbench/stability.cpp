#include "commands.h"
#include "figures.h"
#include "measures.h"
#include "methods/catalog.h"
#include "statistics.h"
#include "tasks.h"

#include <specbake/core/error.h>
#include <specbake/core/solid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace specbake::bench {
namespace {

constexpr double kNearest = 1e-7;  // distance 1 − gauge; the gauge itself is known to 1e-13

/// Failure, residual and continuity at one distance from the boundary.
std::vector<Figure> measureAt(const Method& method, const Solid& solid, double distance,
                              std::size_t count) {
    const std::vector<XYZ> colors = colorsAtGauge(solid, 1 - distance, count);
    std::vector<double> residuals;
    double failed = 0;
    for (const XYZ& color : colors) {
        const Verdict v = judge(method, color, method.reconstruct(color));
        residuals.push_back(v.residual);
        failed += v.failed;
    }
    // Neighbours must be inside as well: a tenth of the way to the boundary at most.
    const auto ratios = continuity(method, colors, std::min(1e-4, distance / 10));
    const auto figure = [&](const char* quantity, double value, const char* unit) {
        return Figure{
            "towards the boundary", method.name(), quantity, value, unit, distance, "1 - gauge"};
    };
    return {figure("failed", failed / double(colors.size()), "share of colours"),
            figure("residual p99", quantile(residuals, 0.99), "XYZ"),
            figure("continuity p99", quantile(ratios, 0.99), "reflectance per RGB")};
}

/// The colours of one luminance that the solid holds, on a lattice of chromaticities.
struct MapPoint {
    double luminance, x, y;
    XYZ color;
};

std::vector<MapPoint> mapPoints(const Solid& solid, double step) {
    std::vector<MapPoint> points;
    for (const double Y : {0.05, 0.2, 0.5, 0.8}) {
        for (int i = 1; i * step < 0.75; ++i) {
            for (int j = 1; j * step < 0.85; ++j) {
                const double x = i * step, y = j * step;
                const XYZ color(Y * x / y, Y, Y * (1 - x - y) / y);
                if (color.z >= 0 && solid.gauge(color) <= 1) points.push_back({Y, x, y, color});
            }
        }
    }
    return points;
}

/// What went wrong, the first of: bounds, colour missed, the method's own word.
const char* verdictOf(const Method& method, const XYZ& color) {
    const Reconstruction r = method.reconstruct(color);
    const Verdict v = judge(method, color, r);
    if (!(v.violation <= kUsableViolation)) return "out of bounds";
    if (!(v.deltaE <= kVisible)) return "missed";
    return r.converged ? "good" : "gave up";
}

/// A method's part of map.csv.
std::string mapOf(const Method& method, const std::vector<MapPoint>& points) {
    std::string lines;
    for (const MapPoint& p : points) {
        lines +=
            fmt::format("{},{:.4f},{:.4f},\"{}\",\"{}\",{}\n", p.luminance, p.x, p.y,
                        method.name().family, method.name().parameters, verdictOf(method, p.color));
    }
    return lines;
}

void measureLines(const Options& options, const Methods& methods, const Solid& solid) {
    std::vector<Task<std::vector<Figure>>> tasks;
    for (double exponent = -std::log10(kNearest); exponent >= 0.5; exponent -= 0.5) {
        for (const auto& method : methods) {
            tasks.push_back({fmt::format("1e-{}: {}", exponent, method->name().full()),
                             [&solid, &options, &method = *method, exponent] {
                                 return measureAt(method, solid, std::pow(10, -exponent),
                                                  options.full ? 5000 : 400);
                             }});
        }
    }
    Progress progress("stability", tasks.size());
    Figures figures("stability", options.commandLine("stability"));
    for (const auto& some : onAllCores(tasks, progress)) {
        for (const Figure& figure : some) figures.add(figure);
    }
    figures.write(options.out);
}

void measureMap(const Options& options, const Methods& methods, const Solid& solid) {
    const auto points = mapPoints(solid, options.full ? 0.005 : 0.01);
    std::vector<Task<std::string>> tasks;
    for (const auto& method : methods) {
        tasks.push_back({method->name().full(),
                         [&points, &method = *method] { return mapOf(method, points); }});
    }
    Progress progress("map", tasks.size());
    const std::string path = options.out + "/map.csv";
    std::ofstream out(path);
    out << "# " << options.commandLine("stability")
        << "\nluminance,x,y,family,parameters,verdict\n";
    for (const std::string& lines : onAllCores(tasks, progress)) out << lines;
    out.flush();
    if (!out) throw FileError(path, "cannot be written");
}

}  // namespace

void runStability(const Options& options) {
    const Methods methods = oneOfEach(options.data);
    for (const auto& method : methods) method->setUp();
    const Solid solid(sRGBFrame().observer);
    measureLines(options, methods, solid);
    measureMap(options, methods, solid);
}

}  // namespace specbake::bench
