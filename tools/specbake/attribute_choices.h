#pragma once

#include "cli_declared.h"

#include <specbake/image/image_types.h>

#include <string>

/// Metadata as words of the command line, as maketx takes them.
namespace specbake::tool {

/// An int if the text is one, else a float if it is one, else the text.
AttributeValue attributeValue(const std::string& text);

/// "periodic,mirror" of that, and "periodic,periodic" of "periodic".
std::string wrapModes(const std::string& text);

/// Whether wrapModes() takes it.
CLI::Validator wrapCheck();

}  // namespace specbake::tool
