#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// Tables of numbers in text, as people and instruments write them.
namespace specbake::internal {

/// All of a file of at most 16 MiB. Throws FileError.
std::string textOfTable(const std::string& path);

/// The numbers of a line, wherever they stand in it.
std::vector<double> numbersIn(const std::string& line);

/// The lines of that many numbers of which the first is a wavelength, from 200 to 3000 nm; at most
/// `most`. Lines that begin with # and all others are passed over.
std::vector<std::vector<double>> rowsOfTable(const std::string& text, std::size_t columns,
                                             std::size_t most);

}  // namespace specbake::internal
