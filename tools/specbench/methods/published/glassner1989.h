#pragma once

#include "methods/linear_basis.h"

namespace specbake::bench {

/// A. S. Glassner, "How to derive a spectrum from an RGB triplet", IEEE Computer Graphics and
/// Applications 9(4), 1989: choose any three functions of wavelength; the spectrum is the one
/// combination of them that has the colour, from a 3x3 system. Exact, and nothing keeps it in [0,
/// 1].
///
/// | quantity | domain       | scale                                   |
/// |----------|--------------|-----------------------------------------|
/// | RGB      | any          | linear, (1, 1, 1) white                 |
/// | spectrum | unbounded    | 1 = perfect reflector                   |
class Glassner1989 : public LinearMethod {
  public:
    enum class Functions {
        fourier,  ///< the first three of the range: 1, cos 2πu, sin 2πu, u = (λ − 380) / 400 nm
        boxes     ///< 1 on 380-485, 490-585, 590-780 nm: blue, green, red
    };
    Glassner1989(Frame frame, Functions functions);
    void setUp() override;

  private:
    Functions functions_;
};

}  // namespace specbake::bench
