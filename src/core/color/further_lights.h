#pragma once

#include <string_view>

namespace specbake::internal::tables {

/// data/illuminants_further_5nm.csv as it is.
extern const std::string_view kFurtherLights;

}  // namespace specbake::internal::tables
