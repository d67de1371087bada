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

/// That of `names` which is fewest edits (one letter more, less or another) from the text, if it is
/// near enough to be meant: a third of its letters.
std::optional<std::string> nearestName(std::string_view text, std::span<const std::string> names);

/// "; did you mean 'D65'?", or nothing if no name is near.
std::string suggestion(std::string_view text, std::span<const std::string> names);

/// The shortest decimal that reads back as the same number.
std::string decimal(double value);
/// With commas between them.
std::string decimals(std::span<const double> values);

/// Finite numbers with commas between them; nothing for any other text.
std::optional<std::vector<double>> numbersOf(std::string_view text);

}  // namespace specbake::internal
