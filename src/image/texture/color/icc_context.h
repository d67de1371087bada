#pragma once

#include <specbake/core/color.h>

#include <lcms2.h>

#include <memory>
#include <string>
#include <vector>

namespace specbake::internal {

/// Little CMS with what it last complained of, and nothing global.
class IccContext {
  public:
    IccContext();

    cmsContext get() const { return context_.get(); }
    /// As one line; `otherwise` if it did not complain.
    std::string complaint(const std::string& otherwise) const;

  private:
    struct Delete {
        void operator()(_cmsContext_struct* context) const { cmsDeleteContext(context); }
    };
    static void onError(cmsContext context, cmsUInt32Number code, const char* text);

    std::string complaint_;
    std::unique_ptr<_cmsContext_struct, Delete> context_;
};

/// An open profile.
class IccProfile {
  public:
    /// Throws ProfileError for what is no profile.
    IccProfile(std::shared_ptr<IccContext> context, const std::string& bytes);
    /// Takes over a profile that Little CMS made. Throws ProfileError for none.
    IccProfile(std::shared_ptr<IccContext> context, cmsHPROFILE profile);

    cmsHPROFILE get() const { return profile_.get(); }
    const std::shared_ptr<IccContext>& context() const { return context_; }
    /// What it calls itself, as one line of ASCII.
    std::string description() const;

  private:
    struct Close {
        void operator()(void* profile) const { cmsCloseProfile(profile); }
    };
    std::shared_ptr<IccContext> context_;
    std::unique_ptr<void, Close> profile_;
};

/// The white of the profile connection space, D50.
XYZ pcsWhite();

/// Values at i / 65535 of a curve. Throws ProfileError where one is not finite.
std::vector<float> sampledCurve(const cmsToneCurve& curve);

/// FNV-1a of 64 bits, in hexadecimal digits.
std::string hashOf(const std::string& bytes);

}  // namespace specbake::internal
