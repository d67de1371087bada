#include "target.h"

#include <specbake/image/table_file.h>

#include <vector>

namespace specbake::fuzz {

void run(std::span<const std::uint8_t> bytes) {
    const auto all = std::as_bytes(bytes);
    const TableFile table("table", std::vector<std::byte>(all.begin(), all.end()));
    static_cast<void>(table.facts());
    static_cast<void>(table.bands());
    static_cast<void>(table.view().intact());
}

}  // namespace specbake::fuzz
