#include <specbake/bake/model_cache.h>

#include <algorithm>
#include <tuple>

namespace specbake {
namespace {

/// All members: one that is added does not compile until it is compared.
auto allOf(const UpsamplerOptions& options) {
    const auto& [illuminant, observer, adapt, method, material, samples, quadrature, bands, outside,
                 grid] = options;
    return std::tie(illuminant, observer, adapt, method, material, samples, quadrature, bands,
                    outside, grid);
}

auto allOf(const ColorSpace& space) {
    const auto& [name, transfer, primaries, illuminant] = space;
    return std::tie(name, transfer, primaries, illuminant);
}

}  // namespace

std::shared_ptr<const Upsampler> ModelCache::model(const ColorSpace& space,
                                                   const UpsamplerOptions& options) {
    const std::lock_guard lock(mutex_);
    const auto known = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
        return allOf(entry.space) == allOf(space) && allOf(entry.options) == allOf(options);
    });
    if (known != entries_.end()) return known->model;
    auto made = std::make_shared<const Upsampler>(space, options);
    entries_.push_back({space, options, made});
    return made;
}

}  // namespace specbake
