#pragma once

#include "texture/image_file.h"

#include <cstddef>
#include <string>
#include <vector>

namespace specbake::testing {

/// Rows as they are stored.
std::vector<std::byte> rowsOf(ImageFile& file, int first, int count);
std::vector<std::byte> allOf(ImageFile& file);

/// OpenImageIO is the oracle: every field of the description and every byte are the same.
void checkSameAsOpenImageIO(ImageFile& file, const std::string& path);

}  // namespace specbake::testing
