#include "identity/identity.h"

#include <specbake/bake/model_cache.h>
#include <specbake/bake/up_to_date.h>
#include <specbake/image/exr_text.h>
#include <specbake/image/file_fingerprint.h>

namespace specbake {

using namespace internal;

namespace {

namespace fs = std::filesystem;

/// The next part of an identity; what remains of it begins behind the separator.
std::string takePart(std::string& identity) {
    const std::string separator = kIdentitySeparator;
    const std::size_t end = identity.find(separator);
    std::string part = identity.substr(0, end);
    identity = end == std::string::npos ? "" : identity.substr(end + separator.size());
    return part;
}

/// The first part in which two identities differ.
std::string differenceOf(std::string made, std::string wanted) {
    while (!made.empty() || !wanted.empty()) {
        const std::string was = takePart(made);
        const std::string now = takePart(wanted);
        if (was == now) continue;
        return std::string("made of '")
            .append(was)
            .append("', which is '")
            .append(now)
            .append("' now");
    }
    return "made otherwise";
}

/// What stands for the texture's bytes: of such that are not read, what the result says of them, if
/// there are as many.
std::optional<std::string> sourceNow(const std::string& input, std::string made,
                                     SourceCheck check) {
    std::error_code error;
    const auto size = fs::file_size(input, error);
    if (check == SourceCheck::bytes || error) return fileFingerprint(input);
    const std::string length = std::to_string(size) + " bytes";
    std::string source = takePart(made);
    return source.starts_with(length + ", ") ? source : length;
}

/// `source`: what stands for the texture's bytes; nothing for what is no file.
std::optional<std::string> wantedIdentity(const std::string& input,
                                          const std::optional<std::string>& source,
                                          const BakeOptions& options) {
    if (!source) return {};
    const TextureReader texture(input, options.read);
    const auto models = options.models ? options.models : std::make_shared<ModelCache>();
    std::vector<std::string> unused;
    const ColorMeaning meaning = chosenMeaning(texture.info(), options.color, unused);
    return bakeIdentity(*source, *models->model(meaning.space, options.model), meaning, options);
}

}  // namespace

std::optional<std::string> outdated(const std::string& input, const fs::path& output,
                                    const BakeOptions& options, SourceCheck check) {
    std::error_code error;
    const auto made = fs::last_write_time(output, error);
    if (error) return "not there";
    const auto changed = fs::last_write_time(input, error);
    if (!error && made < changed) return "older than its texture";
    const auto identity = exrText(output.string(), kIdentityAttribute);
    if (!identity) return "it does not say how it was made";
    const auto wanted = wantedIdentity(input, sourceNow(input, *identity, check), options);
    if (!wanted) return "its texture is not a file that could be compared";
    if (*wanted != *identity) return differenceOf(*identity, *wanted);
    return {};
}

}  // namespace specbake
