#pragma once

#include "methods/method.h"
#include "nature/judged.h"

#include <memory>
#include <vector>

namespace specbake::bench {

/// The methods that rebuild the samples. What they know of measured reflectances is without those
/// that they rebuild: `samples` has nine tenths of the set, `material` all other samples of it.
std::vector<std::unique_ptr<Method>> rivalsFor(const Judged& set, const Options& options);

}  // namespace specbake::bench
