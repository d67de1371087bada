#include "solve/samples/with_samples.h"

#include "solve/natural/measured_set.h"
#include "solve/samples/distinct_samples.h"
#include "solve/samples/samples_solver.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

namespace specbake::internal {
namespace {

std::string twoDecimals(double value) {
    const auto hundredths = std::lround(100 * value);
    const std::string cents = std::to_string(hundredths % 100);
    return std::to_string(hundredths / 100) + (cents.size() < 2 ? ".0" : ".") + cents;
}

std::string describe(const ShapeChoice& choice, std::size_t all) {
    const std::string which = choice.samples < all
                                  ? std::to_string(choice.samples) + " of " + std::to_string(all)
                                  : std::to_string(all);
    return which + " samples, each left out: mean CIEDE2000 " + twoDecimals(choice.difference) +
           " under " + choice.light + "; without samples " + twoDecimals(choice.without);
}

}  // namespace

std::shared_ptr<const Solver> withMaterial(const Observer& observer,
                                           std::shared_ptr<const Solver> base,
                                           const std::vector<MeasuredSet>& sets,
                                           std::string_view material) {
    const auto distinct =
        distinctSamples(observer, atKnots(samplesOfMaterial(sets, material), observer.knots()));
    return std::make_shared<const SamplesSolver>(observer, std::move(base), distinct.samples);
}

NotedSolver withSamples(const UpsamplerOptions& options, const Observer& observer,
                        std::shared_ptr<const Solver> base) {
    NotedSolver result{std::move(base), {}};
    if (options.material) {
        result.solver =
            withMaterial(observer, std::move(result.solver), builtInSets(), *options.material);
    }
    if (!options.samples.empty()) {
        DistinctSamples distinct =
            distinctSamples(observer, atKnots(options.samples, observer.knots()));
        const ShapeChoice choice = chooseShape(observer, *result.solver, distinct.samples);
        result.notes = std::move(distinct.notes);
        result.notes.push_back(describe(choice, distinct.samples.size()));
        result.solver = std::make_shared<const SamplesSolver>(observer, result.solver,
                                                              distinct.samples, choice.shape);
    }
    return result;
}

std::string identityOf(const std::vector<MeasuredSample>& samples) {
    std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a, 64 bits
    const auto add = [&](std::uint64_t bits) {
        for (int byte = 0; byte < 8; ++byte) {
            hash = (hash ^ ((bits >> (8 * byte)) & 0xff)) * 0x100000001b3;
        }
    };
    for (const MeasuredSample& sample : samples) {
        for (const double value : sample.reflectance) add(std::bit_cast<std::uint64_t>(value));
    }
    std::array<char, 16> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), hash, 16).ptr;
    return std::to_string(samples.size()) + " samples " + std::string(digits.data(), end);
}

}  // namespace specbake::internal
