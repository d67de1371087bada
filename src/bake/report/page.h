#pragma once

#include <string_view>

namespace specbake::internal {

/// The page of a report: HTML with the places {{style}}, {{script}} and {{data}}, and what stands
/// in the first two. The third is the JSON of page_data.h.
extern const std::string_view kPageFrame;
extern const std::string_view kPageStyle;
extern const std::string_view kPageScript;

}  // namespace specbake::internal
