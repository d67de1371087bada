#include "solid/base_polygon.h"

#include <algorithm>
#include <cmath>

namespace specbake::internal {

BasePolygon::BasePolygon(std::vector<Imath::V2d> edges) : edges_(std::move(edges)) {
    for (const Imath::V2d& edge : edges_) center_ += edge / 2;
    for (const Imath::V2d& edge : edges_) {
        const Imath::V2d normal(-edge.y, edge.x);
        double h = 0;
        for (const Imath::V2d& other : edges_) h += std::abs(normal.dot(other)) / 2;
        if (h > 0) normals_.push_back(normal / h);
    }
}

BasePolygon::Point BasePolygon::at(const Imath::V2d& p) const {
    if (edges_.size() < 2) return onSegment(p);
    const double gauge = signedGauge(p);
    const double rho = std::min(std::abs(gauge), 1.0);
    if (rho == 0) return {std::vector<double>(edges_.size(), 0.5), 0};
    // The lower chain is the upper one turned about the centre, with 1 - s.
    std::vector<double> values = upperChain(center_.x + p.x / gauge);
    for (double& s : values) {
        if (gauge < 0) s = 1 - s;
        s = (1 - rho) * 0.5 + rho * s;
    }
    return {values, p.length() * std::max(0.0, 1 - 1 / std::abs(gauge))};
}

BasePolygon::Point BasePolygon::onSegment(const Imath::V2d& p) const {
    if (edges_.empty()) return {{}, p.length()};
    const Imath::V2d fromStart = p + center_;
    const double s = std::clamp(fromStart.dot(edges_[0]) / edges_[0].length2(), 0.0, 1.0);
    return {{s}, (fromStart - s * edges_[0]).length()};
}

double BasePolygon::signedGauge(const Imath::V2d& p) const {
    double gauge = 0;
    for (const Imath::V2d& normal : normals_) {
        const double v = normal.dot(p);
        if (std::abs(v) > std::abs(gauge)) gauge = v;
    }
    return gauge;
}

/// The upper chain runs from the origin along the steepest edge first. x grows along it, so that x
/// alone tells the edge, however near to each other two edges' directions are.
std::vector<double> BasePolygon::upperChain(double x) const {
    std::vector<double> values(edges_.size());
    for (std::size_t i = edges_.size(); i-- > 0;) {
        if (edges_[i].x > 0) values[i] = std::clamp(x / edges_[i].x, 0.0, 1.0);
        x -= edges_[i].x;
    }
    return values;
}

}  // namespace specbake::internal
