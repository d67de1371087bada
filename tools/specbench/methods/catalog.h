#pragma once

#include "method.h"

#include <memory>
#include <string>
#include <vector>

namespace specbake::bench {

using Methods = std::vector<std::unique_ptr<Method>>;

/// Every method and setting of the speed-accuracy charts, not yet set up. `data` is the folder of
/// the tables.
Methods everyMethod(const std::string& data);

/// One setting a family, for the charts with a line or a curve a method.
Methods oneOfEach(const std::string& data);

}  // namespace specbake::bench
