#include "brute_solid.h"

#include "csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace specbake::testing {
namespace {

__extension__ typedef __int128 Exact;
using ExactVector = std::array<Exact, 3>;

ExactVector cross(const ExactVector& a, const ExactVector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Exact dot(const ExactVector& a, const ExactVector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Imath::V3d unit(const ExactVector& v) {
    return Imath::V3d(double(v[0]), double(v[1]), double(v[2])).normalized();
}

struct Merged {
    ExactVector exact;
    Imath::V3d weight;
};

/// Rows of 5 nm from 380 to 780, whatever rows there are between.
bool isBand(const std::string& nm) {
    const double at = std::stod(nm);
    return at >= 380 && at <= 780 && std::fmod(at, 5) == 0;
}

std::vector<Merged> mergeBands(const Observer& observer, const std::string& table) {
    std::vector<Merged> merged;
    std::size_t band = 0;
    for (const auto& row : readCsv(table)) {
        if (!isBand(row[0])) continue;
        ExactVector v;
        for (std::size_t i = 0; i < 3; ++i) v[i] = std::llround(std::stod(row[i + 1]) * 1e10);
        const Imath::V3d w = observer.weights()[band++];
        const auto same = std::find_if(merged.begin(), merged.end(), [&](const Merged& m) {
            return cross(m.exact, v) == ExactVector{};
        });
        if (same == merged.end()) {
            merged.push_back({v, w});
        } else {
            same->weight += w;
        }
    }
    return merged;
}

/// Of a + α (b − a) over 0 <= α <= 1, the point nearest to p.
Imath::V3d nearestOnSegment(const Imath::V3d& p, const Imath::V3d& a, const Imath::V3d& b) {
    return a + (b - a) * std::clamp((p - a).dot(b - a) / (b - a).length2(), 0.0, 1.0);
}

}  // namespace

BruteSolid::BruteSolid(const Observer& observer, const std::string& table)
    : white_(observer.white()) {
    const std::vector<Merged> merged = mergeBands(observer, table);
    for (const Merged& m : merged) {
        vectors_.push_back(m.weight);
        if (m.exact[2] == 0) red_.push_back(m.weight);
    }
    for (std::size_t m = 0; m < merged.size(); ++m) {
        for (std::size_t k = 0; k < m; ++k) {
            if (merged[m].exact[2] == 0 && merged[k].exact[2] == 0) continue;
            const ExactVector n = cross(merged[m].exact, merged[k].exact);
            const Imath::V3d normal = unit(n);
            double h = 0;
            std::array<Imath::V3d, 2> corner{Imath::V3d(0.0), Imath::V3d(0.0)};
            for (std::size_t j = 0; j < merged.size(); ++j) {
                h += std::abs(normal.dot(vectors_[j])) / 2;
                if (j == m || j == k) continue;
                const Exact side = dot(n, merged[j].exact);
                if (side == 0) ++coplanarTriples_;
                corner[side > 0 ? 0 : 1] += vectors_[j];
            }
            for (const int sign : {1, -1}) {
                faces_.push_back({normal * sign, normal * (sign / h), corner[sign > 0 ? 0 : 1],
                                  vectors_[m], vectors_[k]});
            }
        }
    }
}

double BruteSolid::gauge(const XYZ& color) const {
    const Imath::V3d d = color - white_ / 2;
    double largest = std::abs(d.z) / (white_.z / 2);
    for (const Face& face : faces_) largest = std::max(largest, face.scaled.dot(d));
    return largest;
}

/// Whether the foot of the perpendicular to the nearer base's plane lies in the base.
bool BruteSolid::aboveBase(const XYZ& color) const {
    Imath::V3d red(0.0);
    for (const Imath::V3d& w : red_) red += w;
    const Imath::V3d center = color.z < 0 ? red / 2 : white_ - red / 2;
    return std::all_of(red_.begin(), red_.end(), [&](const Imath::V3d& w) {
        const Imath::V3d n(-w.y, w.x, 0);
        double h = 0;
        for (const Imath::V3d& other : red_) h += std::abs(n.dot(other)) / 2;
        return std::abs(n.dot(color - center)) <= h;
    });
}

double BruteSolid::distance(const XYZ& color, XYZ* nearest) const {
    double smallest = std::numeric_limits<double>::infinity();
    const auto consider = [&](const Imath::V3d& p) {
        const double d = (color - p).length();
        if (d >= smallest) return;
        smallest = d;
        if (nearest) *nearest = XYZ(p);
    };
    if ((color.z < 0 || color.z > white_.z) && aboveBase(color)) {
        consider({color.x, color.y, color.z < 0 ? 0 : white_.z});
    }
    for (const Face& f : faces_) {
        const Imath::V3d d = color - f.corner;
        if (f.outward.dot(d) <= 0) continue;
        const double area = f.a.cross(f.b).dot(f.outward);
        const double alpha = d.cross(f.b).dot(f.outward) / area;
        const double beta = f.a.cross(d).dot(f.outward) / area;
        if (alpha >= 0 && alpha <= 1 && beta >= 0 && beta <= 1) {
            consider(f.corner + alpha * f.a + beta * f.b);
            continue;
        }
        const Imath::V3d far = f.corner + f.a + f.b;
        consider(nearestOnSegment(color, f.corner, f.corner + f.a));
        consider(nearestOnSegment(color, f.corner, f.corner + f.b));
        consider(nearestOnSegment(color, far, far - f.a));
        consider(nearestOnSegment(color, far, far - f.b));
    }
    return smallest;
}

}  // namespace specbake::testing
