#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Names and numbers as people write them.
namespace specbake::internal {

std::string lowerCase(std::string_view text);

/// Letters and digits in lower case: what counts when names are compared.
std::string bareName(std::string_view name);

/// The shortest decimal that reads back as the same number.
std::string decimal(double value);
/// With commas between them.
std::string decimals(std::span<const double> values);

/// Finite numbers with commas between them; nothing for any other text.
std::optional<std::vector<double>> numbersOf(std::string_view text);

}  // namespace specbake::internal
