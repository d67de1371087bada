#include <specbake/bake/bake.h>
#include <specbake/core/observer.h>
#include <specbake/core/spectrum.h>

#include <cstdio>

/// consumer TEXTURE SPECTRAL: bakes a texture, and checks that the mathematics is there.
/// The perfect reflector's luminance is 1 by the observer's scaling: 81 products that sum to 1,
/// each rounded once or twice, so within 81 * 2^-52 < 2e-14.
int main(int argc, char** argv) {
    if (argc != 3) return 2;
    const auto statistics = specbake::bake(argv[1], argv[2], {});
    const specbake::Observer observer("D65");
    const double luminance = observer.color(specbake::constantSpectrum(1)).y;
    std::printf("%zu texels; luminance of the perfect reflector: %.17g\n", statistics.texels,
                luminance);
    return luminance > 1 - 2e-14 && luminance < 1 + 2e-14 ? 0 : 1;
}
