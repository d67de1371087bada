#include <specbake/core/upsampler.h>

#include <cstdio>

/// Prints the reflectance of an ACEScg colour at four wavelengths: a deep green in a cell of the
/// grid that the boundary of the object-colour solid cuts. Its bands must have its luminance.
int main() {
    using namespace specbake;
    const Upsampler upsampler(*findColorSpace("acescg"));
    const Upsampler::Color green = {0.01F, 0.09F, 0.012F};

    const std::array wavelengths = {452.5, 520.0, 580.0, 650.0};
    const auto some = upsampler.sample({&green, 1}, SampleSelection::at(wavelengths));
    for (std::size_t i = 0; i < some.size(); ++i) {
        std::printf("%.1f nm: %.6f\n", wavelengths[i], double(some[i]));
    }
    const auto bands = upsampler.sample({&green, 1}, SampleSelection::bands());
    double luminance = 0;
    for (std::size_t m = 0; m < bands.size(); ++m) {
        luminance += upsampler.observer().weights()[m].y * double(bands[m]);
    }
    const double asked = upsampler.xyz(RGB(double(green[0]), double(green[1]), double(green[2]))).y;
    std::printf("Y: %.9f of %.9f\n", luminance, asked);
    return luminance - asked < 1e-7 && asked - luminance < 1e-7 ? 0 : 1;  // floats near 0.06
}
