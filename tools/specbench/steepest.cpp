#include "steepest.h"

#include "colors/random_colors.h"
#include "measures.h"
#include "statistics.h"

#include <algorithm>

namespace specbake::bench {
namespace {

constexpr int kTrials = 200;  ///< of one climb
constexpr double kFirstStep = 0.1, kLastStep = 1e-4;

struct Pair {
    RGB middle, half;  ///< middle − half and middle + half

    RGB low() const { return RGB(middle - half); }
    RGB high() const { return RGB(middle + half); }
    double distance() const { return 2 * half.length(); }
};

RGB inDirection(Generator& random, double length) {
    RGB step;
    do {
        step = uniformRGB(random, -1, 1);
    } while (step.length() > 1 || step.length() < 0.01);
    return RGB(step * (length / step.length()));
}

/// Moved into the cube as far as it must be.
Pair inCube(Pair pair) {
    for (int i = 0; i < 3; ++i) {
        const double reach = std::abs(pair.half[i]);
        pair.middle[i] = std::clamp(pair.middle[i], reach, 1 - reach);
    }
    return pair;
}

class Search {
  public:
    using SpectrumOf = std::function<Spectrum(const RGB&)>;
    explicit Search(const SpectrumOf& spectrumOf) : spectrumOf_(spectrumOf) {}

    double slope(const Pair& pair) const {
        return maxDifference(spectrumOf_(pair.low()), spectrumOf_(pair.high())) / pair.distance();
    }

    Pair climb(Generator& random) const {
        const double reach = kNarrowing.front() / 2;
        Pair best = inCube({uniformRGB(random, 0, 1), inDirection(random, reach)});
        double steep = slope(best);
        const double shrink = std::pow(kLastStep / kFirstStep, 1.0 / kTrials);
        double step = kFirstStep;
        for (int i = 0; i < kTrials; ++i, step *= shrink) {
            const RGB turned = RGB(best.half / reach + inDirection(random, step / kFirstStep));
            const Pair trial = inCube({RGB(best.middle + inDirection(random, step)),
                                       RGB(turned * (reach / turned.length()))});
            const double found = slope(trial);
            if (found <= steep) continue;
            best = trial;
            steep = found;
        }
        return best;
    }

    /// The half of it that changes more.
    Pair halved(const Pair& pair) const {
        const Pair low{RGB(pair.middle - pair.half / 2), RGB(pair.half / 2)};
        const Pair high{RGB(pair.middle + pair.half / 2), RGB(pair.half / 2)};
        return slope(low) > slope(high) ? low : high;
    }

  private:
    const SpectrumOf& spectrumOf_;
};

}  // namespace

std::array<double, kNarrowing.size()> steepest(
    const std::function<Spectrum(const RGB&)>& spectrumOf, std::size_t starts) {
    const Search search(spectrumOf);
    Generator random(4);
    std::array<double, kNarrowing.size()> most{};
    for (std::size_t i = 0; i < starts; ++i) {
        Pair pair = search.climb(random);
        for (std::size_t k = 0; k < kNarrowing.size(); ++k) {
            while (pair.distance() > 1.01 * kNarrowing[k]) pair = search.halved(pair);
            most[k] = std::max(most[k], search.slope(pair));
        }
    }
    return most;
}

}  // namespace specbake::bench
