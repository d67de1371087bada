#include "batch/input_names.h"

#include "batch/number_token.h"

#include <specbake/core/error.h>

#include <glob.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <string_view>
#include <utility>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;

/// By which a file in a folder is taken for an image: what OpenImageIO's readers are called.
constexpr std::array<std::string_view, 47> kExtensions = {
    "avif", "bmp",  "bw",   "cin", "dds",  "dib", "dpx",  "exr",  "gif",  "hdr",  "heic", "heics",
    "heif", "ico",  "iff",  "int", "inta", "j2c", "j2k",  "jfi",  "jfif", "jif",  "jp2",  "jpe",
    "jpeg", "jpg",  "pbm",  "pdd", "pfm",  "pgm", "pic",  "png",  "pnm",  "ppm",  "psb",  "psd",
    "rgb",  "rgba", "rgbe", "sgi", "tga",  "tif", "tiff", "tpic", "tx",   "webp", "z"};

bool isImageName(const fs::path& path) {
    std::string extension = path.extension().string();
    if (extension.empty()) return false;
    for (char& c : extension) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    return std::binary_search(kExtensions.begin(), kExtensions.end(), extension.substr(1));
}

bool isHidden(const fs::path& path) {
    return path.filename().string().starts_with('.');
}

std::vector<Input> inFolder(const std::string& folder) {
    std::vector<std::string> paths;
    using Walk = fs::recursive_directory_iterator;
    for (auto at = Walk(folder, fs::directory_options::skip_permission_denied); at != Walk();
         ++at) {
        if (isHidden(at->path())) {
            at.disable_recursion_pending();
        } else if (at->is_regular_file() && isImageName(at->path())) {
            paths.push_back(at->path().string());
        }
    }
    if (paths.empty()) throw ArgumentError(folder + ": there are no images in this folder");
    std::sort(paths.begin(), paths.end());
    std::vector<Input> inputs;
    for (const std::string& path : paths) {
        const fs::path below = fs::path(path).lexically_relative(folder).parent_path();
        inputs.push_back({path, below.string(), "", true});
    }
    return inputs;
}

class Matches {
  public:
    explicit Matches(const std::string& pattern) {
        glob(pattern.c_str(), GLOB_BRACE | GLOB_TILDE, nullptr, &found_);
    }
    ~Matches() { globfree(&found_); }
    Matches(const Matches&) = delete;
    Matches& operator=(const Matches&) = delete;

    std::vector<std::string> paths() const {
        return {found_.gl_pathv, found_.gl_pathv + found_.gl_pathc};
    }

  private:
    glob_t found_{};
};

std::vector<Input> matching(const std::string& pattern) {
    std::vector<Input> inputs;
    for (const std::string& path : Matches(pattern).paths()) {
        if (fs::is_directory(path)) {
            for (Input& input : inFolder(path)) inputs.push_back(std::move(input));
        } else {
            inputs.push_back({path, "", "", true});
        }
    }
    return inputs;
}

bool hasWildcards(const std::string& text) {
    return text.find_first_of("*?[{") != std::string::npos;
}

/// The files of a pattern with a token for a number; those of fewer digits first.
std::vector<Input> numbered(const std::string& word, const NumberToken& token) {
    const std::string before = word.substr(0, token.begin);
    const std::string after = word.substr(token.begin + token.length);
    std::vector<Input> inputs;
    for (const std::string& number : token.globs) {
        for (Input& input : matching(before + number + after)) inputs.push_back(std::move(input));
    }
    if (hasWildcards(before) || hasWildcards(after)) return inputs;
    for (Input& input : inputs) {
        input.number =
            input.path.substr(before.size(), input.path.size() - before.size() - after.size());
    }
    return inputs;
}

std::vector<Input> expandWord(const std::string& word) {
    std::error_code ignored;
    if (fs::is_directory(word, ignored)) return inFolder(word);
    if (fs::exists(fs::symlink_status(word, ignored))) return {{word, "", "", false}};
    std::vector<Input> inputs;
    if (const auto token = findNumberToken(word)) {
        inputs = numbered(word, *token);
    } else if (hasWildcards(word)) {
        inputs = matching(word);
    } else {
        return {{word, "", "", false}};
    }
    if (inputs.empty()) throw ArgumentError(word + ": no file matches");
    return inputs;
}

std::vector<std::string> linesOf(std::istream& in, const std::string& name) {
    if (!in) throw FileError(name, "it cannot be read");
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) {
        if (line.ends_with('\r')) line.pop_back();
        if (!line.empty() && line.front() != '#') lines.push_back(line);
    }
    return lines;
}

std::vector<std::string> listed(const std::string& name) {
    if (name == "-") return linesOf(std::cin, "standard input");
    std::ifstream in(name);
    return linesOf(in, name);
}

}  // namespace

Inputs expandInputs(const std::vector<std::string>& words) {
    Inputs inputs;
    std::set<fs::path> known;
    const auto add = [&](const std::string& word) {
        for (Input& input : expandWord(word)) {
            const bool isNew = known.insert(fs::absolute(input.path).lexically_normal()).second;
            if (isNew) inputs.all.push_back(std::move(input));
        }
    };
    for (const std::string& word : words) {
        if (word.size() > 1 && word.front() == '@') {
            for (const std::string& line : listed(word.substr(1))) add(line);
        } else {
            add(word);
        }
    }
    const bool list = words.size() == 1 && words.front().starts_with('@');
    inputs.single = words.size() == 1 && !list && !inputs.all.front().found;
    return inputs;
}

}  // namespace specbake::tool
