#include "solid/solid_data.h"

#include <specbake/core/solid.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace specbake {

using namespace internal;

namespace {

/// α w_m + β w_k, 0 <= α, β <= 1.
struct OnParallelogram {
    double alpha = 0, beta = 0;
    double error2 = std::numeric_limits<double>::infinity();  ///< squared distance from d
};

OnParallelogram withAlpha(const Imath::V3d& d, const Imath::V3d& wm, const Imath::V3d& wk,
                          double alpha) {
    const Imath::V3d rest = d - alpha * wm;
    const double beta = std::clamp(rest.dot(wk) / wk.length2(), 0.0, 1.0);
    return {alpha, beta, (rest - beta * wk).length2()};
}

OnParallelogram withBeta(const Imath::V3d& d, const Imath::V3d& wm, const Imath::V3d& wk,
                         double beta) {
    const OnParallelogram swapped = withAlpha(d, wk, wm, beta);
    return {swapped.beta, beta, swapped.error2};
}

/// The point of a parallelogram nearest to d. β follows from the rounded α, so that the sum is
/// exact to rounding however nearly parallel w_m and w_k are.
OnParallelogram nearestOnParallelogram(const Imath::V3d& d, const Imath::V3d& wm,
                                       const Imath::V3d& wk, const Imath::V3d& normal) {
    const double alpha = d.cross(wk).dot(normal) / wm.cross(wk).dot(normal);
    const double beta = (d - alpha * wm).dot(wk) / wk.length2();
    if (alpha >= 0 && alpha <= 1 && beta >= 0 && beta <= 1) return withAlpha(d, wm, wk, alpha);
    OnParallelogram best;
    for (const double bound : {0.0, 1.0}) {
        for (const auto& edge : {withAlpha(d, wm, wk, bound), withBeta(d, wm, wk, bound)}) {
            if (edge.error2 < best.error2) best = edge;
        }
    }
    return best;
}

}  // namespace

Solid::Data::Data(const Observer& observer)
    : generators(generatorsOf(observer)), white(observer.white()), center(white * 0.5) {
    const Generators& g = *generators;
    for (const auto& bands : g.bands) {
        Imath::V3d sum(0.0);
        for (const int band : bands) sum += observer.weights()[std::size_t(band)];
        vectors.push_back(sum);
    }
    std::vector<Imath::V2d> edges;
    Imath::V3d redSum(0.0);
    for (const int j : g.red) {
        const Imath::V3d& w = vectors[std::size_t(j)];
        edges.emplace_back(w.x, w.y);
        redSum += w;
    }
    base = BasePolygon(std::move(edges));
    const Imath::V3d top = white - redSum / 2;
    topCenter = {top.x, top.y};
    rates = ReleaseRates(vectors);
    makeFaces();
}

const FromBlack& Solid::Data::fromBlack() const {
    return fromBlack_.get([this] { return FromBlack(*generators, vectors); });
}

const std::vector<ExactSum>& Solid::Data::corners() const {
    return corners_.get([this] {
        std::vector<ExactSum> corners;
        for (const SidePair& side : generators->sides) corners.push_back(sumOf(side.above));
        return corners;
    });
}

ExactSum Solid::Data::sumOf(const GeneratorSet& set) const {
    ExactSum sum;
    for (std::size_t j = 0; j < vectors.size(); ++j) {
        if (set[j]) sum.add(vectors[j]);
    }
    return sum;
}

void Solid::Data::makeFaces() {
    all = sumOf(GeneratorSet().set());
    std::vector<Imath::V3d> directions;
    for (const SidePair& side : generators->sides) {
        const bool dark = vectors[std::size_t(side.first)].length2() == 0 ||
                          vectors[std::size_t(side.second)].length2() == 0;
        // A band without light makes no faces: a normal of 0 is never the largest.
        directions.push_back(dark ? Imath::V3d(0.0) : side.normal);
    }
    directions.emplace_back(0, 0, 1);
    double inscribed = std::numeric_limits<double>::infinity();
    for (Imath::V3d& n : directions) {
        long double h = 0;
        for (const Imath::V3d& w : vectors) h += std::abs(n.dot(w)) / 2;
        if (h == 0) continue;
        inscribed = std::min(inscribed, double(h));
        n /= double(h);
    }
    faces = FaceLevels(directions);
    constexpr double u = std::numeric_limits<double>::epsilon() / 2;
    gaugeError = (8 + 6 + 81) * u * center.length() / inscribed;
}

Solid::Data::FacePoint Solid::Data::onSide(std::size_t face, const XYZ& point) const {
    const SidePair& side = generators->sides[face];
    FacePoint result;
    for (std::size_t j = 0; j < vectors.size(); ++j) result.values[j] = side.above[j] ? 1 : 0;
    const auto first = std::size_t(side.first);
    const auto second = std::size_t(side.second);
    const OnParallelogram p = nearestOnParallelogram(point - corners()[face].high(), vectors[first],
                                                     vectors[second], side.normal);
    result.values[first] = p.alpha;
    result.values[second] = p.beta;
    result.error = std::sqrt(p.error2);
    return result;
}

Solid::Data::FacePoint Solid::Data::onTopBase(const XYZ& point) const {
    const Generators& g = *generators;
    const BasePolygon::Point inPlane = base.at(Imath::V2d(point.x, point.y) - topCenter);
    FacePoint result;
    result.error = inPlane.overshoot;
    result.values.fill(1);
    for (std::size_t i = 0; i < g.red.size(); ++i) {
        result.values[std::size_t(g.red[i])] = inPlane.values[i];
    }
    return result;
}

/// The face is the one of the largest level. Where two faces nearly share a plane, rounding can
/// prefer the wrong one, and the point is then outside its parallelogram: so every face whose level
/// ties within the gauge's error is tried.
Solid::Data::FacePoint Solid::Data::onBoundary(const XYZ& boundary) const {
    const Generators& g = *generators;
    const Imath::V3d d = boundary - center;
    FacePoint best;
    best.error = std::numeric_limits<double>::infinity();
    for (const std::size_t face : faces.atLeast(1 - 2 * gaugeError, d)) {
        const double v = faces.level(face, d);
        const XYZ point = v > 0 ? boundary : XYZ(white - boundary);
        FacePoint found = face == g.sides.size() ? onTopBase(point) : onSide(face, point);
        if (found.error >= best.error) continue;
        if (v < 0) found.values = opposite(found.values);
        best = found;
    }
    return best;
}

Imath::V3d internal::colorOf(const std::vector<Imath::V3d>& vectors,
                             const GeneratorValues& values) {
    Imath::V3d sum(0.0);
    for (std::size_t j = 0; j < vectors.size(); ++j) sum += values[j] * vectors[j];
    return sum;
}

Spectrum Solid::Data::expand(const GeneratorValues& values) const {
    Spectrum spectrum;
    for (std::size_t m = 0; m < spectrum.size(); ++m) spectrum[m] = values[generators->ofBand[m]];
    return spectrum;
}

GeneratorValues internal::opposite(const GeneratorValues& values) {
    GeneratorValues result;
    for (std::size_t j = 0; j < values.size(); ++j) result[j] = 1 - values[j];
    return result;
}

Solid::Solid(const Observer& observer) : data_(std::make_shared<const Data>(observer)) {}

const XYZ& Solid::white() const {
    return data_->white;
}

XYZ Solid::center() const {
    return data_->center;
}

double Solid::gauge(const XYZ& color) const {
    return data_->faces.largest(color - data_->center);
}

double Solid::gaugeError() const {
    return data_->gaugeError;
}

double Solid::gaugeFromBlack(const XYZ& color) const {
    return data_->fromBlack().gauge(color);
}

double Solid::depthInCone(const XYZ& color) const {
    return data_->fromBlack().depth(color);
}

Solid::Boundary Solid::boundary(const XYZ& color) const {
    if (color == XYZ(0, 0, 0)) return {1, color, constantSpectrum(0)};
    if (color == data_->white) return {1, color, constantSpectrum(1)};
    const Imath::V3d d = color - data_->center;
    const double r = data_->faces.largest(d);
    if (r == 0) return {0, data_->center, constantSpectrum(0.5)};
    const XYZ boundary(data_->center + d / r);
    return {r, boundary, data_->expand(data_->onBoundary(boundary).values)};
}

double Solid::support(const Imath::V3d& direction) const {
    double sum = 0;
    for (const Imath::V3d& w : data_->vectors) sum += std::max(0.0, direction.dot(w));
    return sum;
}

double Solid::volume() const {
    const auto& w = data_->vectors;
    double sum = 0;
    for (std::size_t i = 0; i < w.size(); ++i) {
        for (std::size_t j = i + 1; j < w.size(); ++j) {
            const Imath::V3d normal = w[i].cross(w[j]);
            for (std::size_t k = j + 1; k < w.size(); ++k) sum += std::abs(normal.dot(w[k]));
        }
    }
    return sum;
}

}  // namespace specbake
