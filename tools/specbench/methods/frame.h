#pragma once

#include <specbake/core/color_space.h>
#include <specbake/core/observer.h>

#include <Imath/ImathMatrix.h>

#include <string>

namespace specbake::bench {

/// What a colour is asked for in: an observer with its illuminant, and an RGB space whose white is
/// the perfect reflector under it.
struct Frame {
    std::string name;
    ColorSpace space;
    Observer observer;
    Imath::M33d xyzFromRGB;  ///< XYZ(rgb * xyzFromRGB)
    Imath::M33d rgbFromXYZ;

    XYZ xyz(const RGB& rgb) const { return XYZ(rgb * xyzFromRGB); }
    RGB rgb(const XYZ& xyz) const { return RGB(xyz * rgbFromXYZ); }
};

/// A space under its own white.
Frame frameOf(const ColorSpace& space);

/// Linear sRGB under D65: the frame in which all methods are compared.
Frame sRGBFrame();

/// The frame that the spectra of Smits 1999 were made for: the phosphors and the
/// equal-energy white of his paper.
Frame smitsFrame();

}  // namespace specbake::bench
