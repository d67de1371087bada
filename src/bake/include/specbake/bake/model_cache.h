#pragma once

#include <specbake/core/api.h>
#include <specbake/core/upsampler.h>

#include <memory>
#include <mutex>
#include <vector>

namespace specbake {

/// Models for bakes to share: one for all that are of the same colour space and options, so that
/// what stands at a grid's nodes is solved once and not per texture. Results do not depend on who
/// shares. Any number of threads may use it.
class SPECBAKE_API ModelCache {
  public:
    /// Made when it is first asked for. Throws ArgumentError for options that are not valid.
    std::shared_ptr<const Upsampler> model(const ColorSpace& space,
                                           const UpsamplerOptions& options);

  private:
    struct Entry {
        ColorSpace space;
        UpsamplerOptions options;
        std::shared_ptr<const Upsampler> model;
    };
    std::mutex mutex_;
    std::vector<Entry> entries_;
};

}  // namespace specbake
