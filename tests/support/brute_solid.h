#pragma once

#include <specbake/core/observer.h>

#include <string>
#include <vector>

namespace specbake::testing {

/// The object-colour solid without any cleverness, as the oracle of specbake::Solid: vectors merged
/// by the printed table, every pair a face, every question put to every face.
class BruteSolid {
  public:
    /// `table`: the file of the observer's colour-matching functions, every 5 nm.
    explicit BruteSolid(const Observer& observer,
                        const std::string& table = "data/cie1931_2deg_5nm.csv");

    /// Triples of generators, not all with Z = 0, that lie in one plane.
    int coplanarTriples() const { return coplanarTriples_; }
    std::size_t faceCount() const { return faces_.size(); }

    double gauge(const XYZ& color) const;

    /// The distance of a colour outside to the nearest point of any face, and that point.
    double distance(const XYZ& color, XYZ* nearest = nullptr) const;

  private:
    struct Face {
        Imath::V3d outward;  ///< unit normal
        Imath::V3d scaled;   ///< normal / h
        Imath::V3d corner;   ///< the vertex from which a and b span the parallelogram
        Imath::V3d a, b;
    };
    bool aboveBase(const XYZ& color) const;

    std::vector<Imath::V3d> vectors_;
    std::vector<Face> faces_;  ///< both parallelograms of every pair
    std::vector<Imath::V3d> red_;
    XYZ white_;
    int coplanarTriples_ = 0;
};

}  // namespace specbake::testing
