#include "texture/color/icc_context.h"

#include "texture/color/icc_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace specbake::internal {

IccContext::IccContext() : context_(cmsCreateContext(nullptr, this)) {
    if (!context_) throw ProfileError("Little CMS cannot be used");
    cmsSetLogErrorHandlerTHR(context_.get(), onError);
}

void IccContext::onError(cmsContext context, cmsUInt32Number /*code*/, const char* text) {
    auto* self = static_cast<IccContext*>(cmsGetContextUserData(context));
    if (self->complaint_.empty()) self->complaint_ = text;
}

std::string IccContext::complaint(const std::string& otherwise) const {
    if (complaint_.empty()) return otherwise;
    std::string line = complaint_;
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line;
}

IccProfile::IccProfile(std::shared_ptr<IccContext> context, const std::string& bytes)
    : context_(std::move(context)),
      profile_(
          cmsOpenProfileFromMemTHR(context_->get(), bytes.data(), cmsUInt32Number(bytes.size()))) {
    if (!profile_) throw ProfileError(context_->complaint("no ICC profile"));
}

IccProfile::IccProfile(std::shared_ptr<IccContext> context, cmsHPROFILE profile)
    : context_(std::move(context)), profile_(profile) {
    if (!profile_) throw ProfileError(context_->complaint("no ICC profile"));
}

std::string IccProfile::description() const {
    std::array<char, 128> text{};
    cmsGetProfileInfoASCII(profile_.get(), cmsInfoDescription, "en", "US", text.data(),
                           cmsUInt32Number(text.size() - 1));
    std::string line(text.data());
    std::erase_if(line, [](char c) { return c < ' ' || c > '~' || c == '\''; });
    return line.empty() ? "without a name" : line;
}

XYZ pcsWhite() {
    const cmsCIEXYZ* white = cmsD50_XYZ();
    return {white->X, white->Y, white->Z};
}

std::vector<float> sampledCurve(const cmsToneCurve& curve) {
    std::vector<float> values(kCurveSize);
    for (std::size_t i = 0; i < kCurveSize; ++i) {
        values[i] = cmsEvalToneCurveFloat(&curve, float(double(i) / double(kCurveSize - 1)));
        if (!std::isfinite(values[i])) throw ProfileError("a curve that leads beyond all numbers");
    }
    return values;
}

std::string hashOf(const std::string& bytes) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char byte : bytes) hash = (hash ^ std::uint8_t(byte)) * 0x100000001b3;
    std::string digits(16, '0');
    for (std::size_t i = 0; i < digits.size(); ++i) {
        digits[i] = "0123456789abcdef"[hash >> (60 - 4 * i) & 15];
    }
    return digits;
}

}  // namespace specbake::internal
