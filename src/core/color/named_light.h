#pragma once

#include <specbake/core/observer.h>

#include <optional>
#include <string>
#include <string_view>

namespace specbake::internal {

struct NamedLight {
    std::string name;  ///< as it is offered, or the whole text of a light of one's own
    LightPower power{};
};

/// An offered illuminant in any case, or a light of one's own in the form of lightText().
std::optional<NamedLight> findLight(std::string_view text);

/// The same. Throws ArgumentError where there is none, and says which name is near.
NamedLight lightNamed(std::string_view text);

}  // namespace specbake::internal
