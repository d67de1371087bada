#include "target.h"
#include "texture/plain/exif_block.h"

namespace specbake::fuzz {

void run(std::span<const std::uint8_t> bytes) {
    static_cast<void>(internal::readExif(textOf(bytes)));
}

}  // namespace specbake::fuzz
