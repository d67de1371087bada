#pragma once

#include <algorithm>
#include <string>

namespace specbake::internal {

/// A library's message as one line without an end.
inline std::string oneLine(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text.empty() ? "cannot be read" : text;
}

}  // namespace specbake::internal
