#pragma once

#include <specbake/bake/bake.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

/// What options offer, the same in every command.
namespace specbake::tool {

/// The names that `--space` and `--illuminant` take, "auto" first.
std::vector<std::string> spaceChoices();
std::vector<std::string> illuminantChoices();

/// Nothing for "auto".
std::optional<std::string> unlessAuto(const std::string& name);

const std::map<std::string, Method>& methodChoices();
const std::map<std::string, Outside>& outsideChoices();

}  // namespace specbake::tool
