#pragma once

#include "frame.h"

#include <specbake/core/spectrum.h>

#include <Imath/ImathVec.h>

#include <span>
#include <string>

namespace specbake::bench {

/// What a method returns for one colour. `converged` is the method's own word; whether the colour
/// was reached is measured, not asked.
struct Reconstruction {
    Spectrum spectrum{};
    bool converged = true;
};

/// How a method is named in a chart.
struct MethodName {
    std::string family;      ///< the paper or the solver: one colour in the charts
    std::string parameters;  ///< the setting within the family; may be empty

    std::string full() const { return parameters.empty() ? family : family + ", " + parameters; }
};

/// A way from three numbers to 81, as the charts see it.
///
/// | quantity             | domain                                            |
/// |----------------------|---------------------------------------------------|
/// | colour               | XYZ under `frame().observer`, Y of white = 1      |
/// | texel                | linear RGB of `frame()`, [0, 1] inside its cube   |
/// | spectrum             | reflectance, 1 = perfect reflector; not clamped   |
class Method {
  public:
    Method(MethodName name, Frame frame) : name_(std::move(name)), frame_(std::move(frame)) {}
    virtual ~Method() = default;

    const MethodName& name() const { return name_; }
    const Frame& frame() const { return frame_; }

    /// Builds the tables that the method needs once. Timed apart from the texels.
    virtual void setUp() {}

    /// Whether it is of interest inside the frame's RGB cube only.
    virtual bool cubeOnly() const { return false; }

    /// One colour. Not before setUp().
    virtual Reconstruction reconstruct(const XYZ& color) const = 0;

    /// The texel path, in the form that the method is used in by a renderer: 81 floats a texel.
    /// spectra.size() = 81 rgb.size(). Unless overridden, one reconstruct() a texel.
    virtual void reconstructTexels(std::span<const Imath::V3f> rgb, std::span<float> spectra) const;

  private:
    MethodName name_;
    Frame frame_;
};

}  // namespace specbake::bench
