#include "target.h"
#include "texture/plain/exif_block.h"

#include <string>

namespace specbake::fuzz {

void run(std::span<const std::uint8_t> bytes) {
    const std::string block(textOf(bytes));
    static_cast<void>(internal::readExif(block));
}

}  // namespace specbake::fuzz
