#pragma once

#include <specbake/core/api.h>
#include <specbake/core/color_space.h>
#include <specbake/core/observer.h>

#include <optional>
#include <span>
#include <string_view>

namespace specbake {

/// How a colour beside one white becomes the colour that looks alike beside another: the cone
/// responses are scaled as those of the whites are.
enum class Adaptation {
    none,
    bradford,  ///< linear Bradford: ICC.1:2010, annex E
    cat16,     ///< Li et al., "Comprehensive color solutions: CAM16, CAT16, and CAM16-UCS", 2017
};

/// All of them, the default of every program first.
SPECBAKE_API std::span<const Adaptation> adaptations();
/// "bradford" and so on.
SPECBAKE_API std::string_view adaptationName(Adaptation adaptation);
SPECBAKE_API std::optional<Adaptation> adaptationFromName(std::string_view name);

/// XYZ(color * matrix) looks beside the white `to` as `color` does beside `from`; `from` itself
/// goes to `to`. The identity for Adaptation::none.
/// Throws ArgumentError if `from` excites one of the three cones not at all.
SPECBAKE_API Imath::M33d adaptation(const XYZ& from, const XYZ& to,
                                    Adaptation adaptation = Adaptation::bradford);

/// Whether linear colours of the space are adapted before they hold under the light: not XYZ,
/// which is the colour under the light, and not where the light is the space's own white. That
/// white and the primaries are what the 2-degree observer of 1931 sees; for one who sees the light
/// as another white, colours are adapted as to another light.
SPECBAKE_API bool isAdapted(const ColorSpace& space, const Observer& light);

/// XYZ under the light from linear RGB of the space, so that XYZ(rgb * matrix), adapted if the
/// light is not the space's own white. (1, 1, 1) goes to the light's white in any case: with
/// Adaptation::none the primaries keep their chromaticities and are scaled so that they do.
/// Throws ArgumentError if the primaries lie on one line.
SPECBAKE_API Imath::M33d xyzFromRGB(const ColorSpace& space, const Observer& light,
                                    Adaptation adaptation);

}  // namespace specbake
