#pragma once

#include <specbake/core/api.h>
#include <specbake/core/solid.h>
#include <specbake/core/solver.h>

#include <optional>
#include <span>
#include <string_view>

namespace specbake {

/// What is given where a colour is asked for that no reflectance has.
enum class Outside {
    nearest,  ///< the nearest colour of the object-colour solid, in XYZ (the paper's rule)
    scale,    ///< the brightest of the same chromaticity, the nearest where there is none; (M17)
    error     ///< nothing: the colour is refused
};

/// Every rule, the default first.
SPECBAKE_API std::span<const Outside> outsideRules();
SPECBAKE_API std::string_view outsideName(Outside rule);
SPECBAKE_API std::optional<Outside> outsideFromName(std::string_view name);

/// A colour that a reflectance can have, in place of one asked for.
struct Attainable {
    XYZ color;                         ///< the colour asked for, if it is inside
    bool outside = false;              ///< the colour asked for is outside the solid
    std::optional<Spectrum> spectrum;  ///< where it came along with the colour
};

/// The colour that is given for `asked`. With Outside::error it is `asked` itself.
SPECBAKE_API Attainable attainable(const Solid& solid, const XYZ& asked, Outside rule);

/// Solves any finite colour: those of the solid by a solver, those outside by a rule.
class SPECBAKE_API ColorResolver {
  public:
    /// The solid and the solver must outlive it.
    ColorResolver(const Solid& solid, const Solver& solver, Outside rule)
        : solid_(solid), solver_(solver), rule_(rule) {}

    struct Resolved {
        Solution solution;     ///< status `outside` where the rule is `error`
        XYZ given;             ///< the colour that the spectrum has
        bool outside = false;  ///< another colour than was asked for
    };
    Resolved resolve(const XYZ& asked) const;

    /// Resolves `asked[i]` into `resolved[i]`, to the bits that resolve() gives, and much faster:
    /// see Solver::solveMany().
    void resolveMany(std::span<const XYZ> asked, std::span<Resolved> resolved) const;

    const Solid& solid() const { return solid_; }
    const Solver& solver() const { return solver_; }

  private:
    const Solid& solid_;
    const Solver& solver_;
    Outside rule_;
};

}  // namespace specbake
