#include "frame.h"

namespace specbake::bench {

Frame frameOf(const ColorSpace& space) {
    Observer observer(space.illuminant);
    const Imath::M33d matrix = xyzFromRGB(space, observer.white());
    return {space.name + " under " + space.illuminant, space, std::move(observer), matrix,
            matrix.inverse()};
}

Frame sRGBFrame() {
    return frameOf(*findColorSpace("lin_rec709"));
}

Frame smitsFrame() {
    constexpr Primaries phosphors{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {1 / 3.0, 1 / 3.0}};
    return frameOf({"Smits' phosphors", Transfer::linear, phosphors, "E"});
}

}  // namespace specbake::bench
