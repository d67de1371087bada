#include "refusal.h"

#include <specbake/core/error.h>

#include <string>
#include <utility>

namespace specbake::internal {
namespace {

/// "FILE: pixel (x, y) is …; N in all", with the window's coordinates.
[[noreturn]] void refuse(const TextureInfo& info, const ColorCensus::Kind& kind, const char* what) {
    const auto width = std::size_t(info.data.width);
    const std::string x = std::to_string(info.data.x + int(*kind.first % width));
    const std::string y = std::to_string(info.data.y + int(*kind.first / width));
    throw FileError(info.path, "pixel (" + x + ", " + y + ") " + what + "; " +
                                   std::to_string(kind.count) + " such in all");
}

}  // namespace

void refuseIncomplete(const TextureInfo& info, const ColorCensus& census) {
    const std::pair<Fate, const char*> reasons[] = {
        {Fate::notFinite, "is not a finite number"},
        {Fate::refused, "has a colour that no reflectance has"},
        {Fate::failed, "was not solved"}};
    for (const auto& [fate, what] : reasons) {
        if (census.of(fate).count > 0) refuse(info, census.of(fate), what);
    }
}

}  // namespace specbake::internal
