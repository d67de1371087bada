#include <specbake/core/adaptation.h>
#include <specbake/core/error.h>
#include <specbake/core/observer.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace specbake;

namespace {

constexpr double kRounding = 16 * 0x1p-52;  // a few operations on numbers of about 1

double largest(const Imath::V3d& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

TEST_CASE("adaptation takes white to white, for all illuminants") {
    for (const std::string& from : illuminantNames()) {
        for (const std::string& to : illuminantNames()) {
            const XYZ a = Observer(from).white();
            const XYZ b = Observer(to).white();
            CHECK(largest(a * adaptation(a, b) - b) < kRounding);
        }
    }
}

TEST_CASE("adaptation from D50 to D65 has the digits that B. Lindbloom publishes") {
    const XYZ d50(0.96422, 1.0, 0.82521);
    const XYZ d65(0.95047, 1.0, 1.08883);
    const Imath::M33d published = Imath::M33d(0.9555766, -0.0230393, 0.0631636,  //
                                              -0.0282895, 1.0099416, 0.0210077,  //
                                              0.0122982, -0.0204830, 1.3299098)
                                      .transposed();  // ours is for row vectors
    CHECK(adaptation(d50, d65).equalWithAbsError(published, 0.5e-7 + 1e-9));
}

TEST_CASE("adaptation from a white without blue is refused") {
    CHECK_THROWS_AS(adaptation(XYZ(1, 1, -0.1), XYZ(1, 1, 1)), ArgumentError);
}
