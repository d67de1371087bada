#pragma once

#include "methods/linear_basis.h"

#include <string>

namespace specbake::bench {

/// I. Mallett, C. Yuksel, "Spectral Primary Decomposition for Rendering with sRGB Reflectance",
/// Eurographics Symposium on Rendering, DL-only track, 2019: one bounded spectrum a primary,
/// summing to 1, so that every mixture inside the sRGB cube is bounded; the spectra are their
/// table.
///
/// | quantity | domain       | scale                                       |
/// |----------|--------------|---------------------------------------------|
/// | RGB      | [0, 1]       | linear sRGB, D65 white                      |
/// | spectrum | [0, 1]       | 1 = perfect reflector                       |
class Mallett2019 : public LinearMethod {
  public:
    /// `table`: data/mallett2019.csv.
    Mallett2019(Frame frame, std::string table);
    /// Throws FileError.
    void setUp() override;

  private:
    std::string table_;
};

}  // namespace specbake::bench
