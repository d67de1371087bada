#pragma once

#include "texture/image_file.h"
#include "texture/plain/exr_input.h"

#include <map>
#include <optional>
#include <string>

namespace specbake::internal {

/// A plain EXR's header, and its string attributes under OpenImageIO's names.
struct ExrDescription {
    ImageDescription image;
    std::map<std::string, std::string> texts;
};

/// Nothing if the file is not plain, as openPlainExr() says. Throws FileError.
std::optional<ExrDescription> describePlain(const ExrInput& input);

}  // namespace specbake::internal
