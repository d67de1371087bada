#pragma once

#include "batch/input_names.h"

#include <string>

namespace specbake::tool {

/// What results are called, as `-o` has it:
///
///     OUT                            OUT/STEM.exr; below a folder that was named, in like folders
///     '{dir}/{stem}.spectral.exr'    by a pattern
///     'out/wood.<UDIM>.exr'          the input's tile or frame in its place
///
/// Of `tex/hull/wood.1001.png`, found in the folder `tex`: {dir} tex/hull, {tree} hull, {name}
/// wood.1001.png, {stem} wood.1001, {ext} png; {number} is 1001 if the input was
/// `wood.<UDIM>.png`. {{ and }} are braces.
class OutputNames {
  public:
    /// `extension`: of results in a folder; `option`: whose words these are, for messages.
    /// Throws ArgumentError for a name that would be the same for all.
    explicit OutputNames(std::string output, std::string extension = ".exr",
                         std::string option = "--output");

    /// Throws ArgumentError for what a pattern names and the input has not.
    std::string nameFor(const Input& input) const;

    /// The folder that all results are below: what stands before fields and numbers.
    std::string folder() const;

  private:
    bool namesMany() const;
    std::string numberOf(const Input& input) const;
    std::string fieldOf(const Input& input, const std::string& field) const;
    std::string filled(const Input& input) const;

    std::string output_;
    std::string extension_;
    std::string option_;
};

}  // namespace specbake::tool
