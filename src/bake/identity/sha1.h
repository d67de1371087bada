#pragma once

#include <string>
#include <string_view>

namespace specbake::internal {

/// FIPS 180-4, 6.1: as 40 hexadecimal digits, capital as maketx writes them.
std::string sha1(std::string_view bytes);

}  // namespace specbake::internal
