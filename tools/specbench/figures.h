#pragma once

#include "methods/method.h"

#include <optional>
#include <string>
#include <vector>

namespace specbake::bench {

/// One measured number, and all that one must know to read it.
struct Figure {
    std::string set;  ///< the colours or the file it was measured on
    MethodName method;
    std::string quantity;
    double value = 0;
    std::string unit;          ///< "1" for a plain number
    std::optional<double> at;  ///< the abscissa, where the figure belongs to a curve
    std::string atUnit;
};

/// What a command measured. Written as NAME.csv and NAME.json, the same rows in both.
class Figures {
  public:
    /// `command` is the command line that repeats it.
    Figures(std::string name, std::string command);

    void add(Figure figure) { figures_.push_back(std::move(figure)); }
    /// A figure for each band.
    void addSpectrum(const std::string& set, const MethodName& method, const Spectrum& spectrum);
    /// Throws FileError.
    void write(const std::string& folder) const;

  private:
    std::string name_, command_;
    std::vector<Figure> figures_;
};

}  // namespace specbake::bench
