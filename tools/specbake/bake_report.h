#pragma once

#include <specbake/bake/bake.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

/// What is told of a bake, to people and to programs.
namespace specbake::tool {

/// The figures of a bake, for `--stats`.
nlohmann::ordered_json bakeJson(const std::string& input, const std::string& output,
                                const BakeStatistics& statistics);

/// In place of them for one that failed.
nlohmann::ordered_json failureJson(const std::string& input, const std::string& output,
                                   const std::string& reason);

/// As text. What is no UTF-8 in a file's name is replaced, since JSON has no other.
/// `indent`: of its lines; below 0 all is one line.
std::string jsonText(const nlohmann::ordered_json& json, int indent);

/// Remarks on a bake, on stderr: what of the texture was not used, what was outside. `outside`: the
/// rule.
void printRemarks(const std::string& input, const BakeStatistics& statistics,
                  const std::string& outside);

/// What --max-deviation and --max-de came to, as lines; empty without them.
std::string choicesText(const std::string& output, const BakeStatistics& statistics);

/// "a.png -> a.exr: 1024 texels …", a line without its end.
std::string bakeLine(const std::string& input, const std::string& output,
                     const BakeStatistics& statistics);

/// The page of --report about the file as it was written: it is read back and compared with the
/// texture. `options`: of the bake. Throws FileError.
void writePage(const std::string& page, const std::string& input, const std::string& output,
               const BakeOptions& options, const BakeStatistics& statistics);

}  // namespace specbake::tool
