#pragma once

#include <cstddef>
#include <string>

namespace specbake::tool {

/// Columns of the terminal on stdout, at least 40 and at most 100; where that is no terminal, what
/// $COLUMNS says, or 80.
std::size_t textWidth();

/// `text` in lines of at most `width` columns, broken between words, the first begun at column
/// `first`, the others indented by `indent`. A word that is longer is broken. Ends without a line
/// feed. Columns are counted in characters of UTF-8.
std::string wrapped(const std::string& text, std::size_t width, std::size_t first,
                    std::size_t indent);

}  // namespace specbake::tool
