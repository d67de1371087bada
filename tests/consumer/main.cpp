#include <specbake/core/observer.h>
#include <specbake/core/spectrum.h>

#include <cstdio>

/// The perfect reflector's luminance is 1 by the observer's scaling: 81 products that sum to 1,
/// each rounded once or twice, so within 81 * 2^-52 < 2e-14.
int main() {
    const specbake::Observer observer("D65");
    const double luminance = observer.color(specbake::constantSpectrum(1)).y;
    std::printf("luminance of the perfect reflector: %.17g\n", luminance);
    return luminance > 1 - 2e-14 && luminance < 1 + 2e-14 ? 0 : 1;
}
