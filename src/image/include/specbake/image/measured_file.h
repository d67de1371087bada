#pragma once

#include <specbake/core/api.h>
#include <specbake/core/measured_sample.h>

#include <string>
#include <vector>

namespace specbake {

/// The spectra of a file, in bands, and what was done to get there.
struct MeasuredFile {
    std::vector<MeasuredSample> samples;
    std::vector<std::string> notes;  ///< a line each: extrapolated, in percent, held in [0, 1]
};

/// Measured reflectances from a text file, in any of these layouts:
///
/// - a sample a row: a heading of labels and wavelengths in nm (`name,380,385,…`), then a name and
///   the values;
/// - a wavelength a row, as colour-science and most spreadsheets have it: a heading of names
///   (`wavelength,red,blue`), or none, then wavelength and values;
/// - CGATS.17 / ISO 28178, as spectrometers write it: fields between BEGIN_DATA_FORMAT and
///   END_DATA_FORMAT, whose spectral ones end in the wavelength (SPECTRAL_NM380, nm380, R_380),
///   and rows between BEGIN_DATA and END_DATA.
///
/// Cells are separated by commas, semicolons or tabs, in CGATS by blanks. Lines that begin with #
/// are skipped. The decimal point may be a comma where commas do not separate. Wavelengths ascend
/// or descend; between them values are interpolated linearly, beyond them extended flat, which a
/// note tells. If the largest value is 2 or more, all are percent, which a note tells. Values that
/// leave [0, 1] by 0.05 or less, as noise and white tiles do, are held there, which a note tells.
///
/// Throws FileError: unreadable, larger than 16 MB, no such layout, a cell that is no number, more
/// than kMostSamples samples, a value farther outside (a fluorescent sample is no reflectance).
SPECBAKE_API MeasuredFile readMeasuredFile(const std::string& path);

}  // namespace specbake
