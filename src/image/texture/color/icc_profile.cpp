#include "texture/color/icc_profile.h"

#include "texture/color/icc_context.h"
#include "texture/color/icc_matrix.h"
#include "texture/color/png_signs.h"

#include <specbake/core/adaptation.h>

#include <cmath>

namespace specbake::internal {
namespace {

cmsColorSpaceSignature signatureOf(ColorModel model, int channels) {
    if (model != ColorModel::rgb) return cmsSigCmykData;
    return channels == 1 ? cmsSigGrayData : cmsSigRgbData;
}

bool isTableBased(cmsHPROFILE profile) {
    return cmsIsTag(profile, cmsSigAToB0Tag) || cmsIsTag(profile, cmsSigAToB1Tag) ||
           cmsIsTag(profile, cmsSigDToB0Tag) || cmsIsTag(profile, cmsSigDToB1Tag);
}

// A header may hold any numbers, which variables of the library's enumerations may not.
cmsUInt32Number colorsOf(const IccProfile& profile) {
    return cmsUInt32Number(cmsGetColorSpace(profile.get()));
}
cmsUInt32Number classOf(const IccProfile& profile) {
    return cmsUInt32Number(cmsGetDeviceClass(profile.get()));
}

/// Pixels through a table.
class ProfileTransform : public PixelTransform {
  public:
    ProfileTransform(const IccProfile& profile, ColorModel model)
        : context_(profile.context()), channels_(4), onPaper_(model == ColorModel::cmykOnPaper) {
        cmsUInt32Number format = TYPE_CMYK_FLT;
        const cmsUInt32Number space = colorsOf(profile);
        if (space == cmsSigRgbData) format = TYPE_RGB_FLT;
        if (space == cmsSigGrayData) format = TYPE_GRAY_FLT;
        if (space == cmsSigRgbData) channels_ = 3;
        if (space == cmsSigGrayData) channels_ = 1;
        const IccProfile xyz(context_, cmsCreateXYZProfileTHR(context_->get()));
        transform_.reset(cmsCreateTransformTHR(context_->get(), profile.get(), format, xyz.get(),
                                               TYPE_XYZ_DBL, INTENT_RELATIVE_COLORIMETRIC,
                                               cmsFLAGS_NOOPTIMIZE | cmsFLAGS_NOCACHE));
        if (!transform_) throw ProfileError(context_->complaint("no transform can be made of it"));
        linearFromXYZ_ = xyzFromRGB(*findColorSpace("lin_prophoto"), pcsWhite()).inverse();
        scaleToWhite();
    }

    void run(const float* stored, std::size_t count, std::array<float, 3>* linear) const override {
        std::array<float, 4 * kRun> device{};
        std::array<double, 3 * kRun> xyz{};
        for (std::size_t done = 0; done < count; done += kRun) {
            const std::size_t some = std::min(kRun, count - done);
            for (std::size_t i = 0; i < some * channels_; ++i) {
                device[i] = deviceValue(stored[done * channels_ + i]);
            }
            cmsDoTransform(transform_.get(), device.data(), xyz.data(), cmsUInt32Number(some));
            for (std::size_t i = 0; i < some; ++i) {
                const Imath::V3d color =
                    Imath::V3d(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]) * linearFromXYZ_;
                linear[done + i] = {finite(color.x), finite(color.y), finite(color.z)};
            }
        }
    }

  private:
    static constexpr std::size_t kRun = 64;

    /// Damaged tables may lead beyond all numbers: to black.
    static float finite(double value) { return std::isfinite(value) ? float(value) : 0.0F; }

    /// Little CMS counts inks in percent.
    float deviceValue(float stored) const {
        if (channels_ != 4) return stored;
        return 100 * (onPaper_ ? 1 - stored : stored);
    }

    /// Tables have their white to 16 bits: the rest is made good, lest white paper be grey.
    void scaleToWhite() {
        constexpr double roundings = 2e-3;
        std::array<float, 4> device{};  // no ink
        if (channels_ != 4) device.fill(1);
        std::array<double, 3> xyz{};
        cmsDoTransform(transform_.get(), device.data(), xyz.data(), 1);
        const Imath::V3d white = Imath::V3d(xyz[0], xyz[1], xyz[2]) * linearFromXYZ_;
        Imath::M33d gains;
        for (int c = 0; c < 3; ++c) {
            if (!(std::abs(white[c] - 1) < roundings)) return;
            gains[c][c] = 1 / white[c];
        }
        linearFromXYZ_ = linearFromXYZ_ * gains;
    }

    struct Delete {
        void operator()(void* transform) const { cmsDeleteTransform(transform); }
    };
    std::shared_ptr<IccContext> context_;
    std::size_t channels_;
    bool onPaper_;
    std::unique_ptr<void, Delete> transform_;
    Imath::M33d linearFromXYZ_;
};

ColorMeaning meaningOfGrey(const IccProfile& profile) {
    const auto* curve =
        static_cast<const cmsToneCurve*>(cmsReadTag(profile.get(), cmsSigGrayTRCTag));
    if (curve == nullptr) throw ProfileError("a profile of grey without its curve");
    ColorMeaning meaning;
    meaning.space = *findColorSpace("lin_rec709");
    meaning.curves = std::make_shared<SampledCurves>(
        SampledCurves{sampledCurve(*curve), sampledCurve(*curve), sampledCurve(*curve)});
    return meaning;
}

ColorMeaning meaningOf(const IccProfile& profile, ColorModel model) {
    const bool tables = isTableBased(profile.get()) || cmsGetPCS(profile.get()) != cmsSigXYZData;
    const cmsUInt32Number space = colorsOf(profile);
    if (!tables && space == cmsSigGrayData) return meaningOfGrey(profile);
    if (!tables && space == cmsSigRgbData) return meaningOfMatrix(profile);
    ColorMeaning meaning;
    meaning.space = *findColorSpace("lin_prophoto");
    meaning.transform = std::make_shared<ProfileTransform>(profile, model);
    return meaning;
}

void checkUse(const IccProfile& profile, ColorModel model, int channels) {
    const cmsUInt32Number kind = classOf(profile);
    if (kind != cmsSigInputClass && kind != cmsSigDisplayClass && kind != cmsSigOutputClass &&
        kind != cmsSigColorSpaceClass) {
        throw ProfileError("a profile of no device");
    }
    const cmsUInt32Number wanted = signatureOf(model, channels);
    const cmsUInt32Number there = colorsOf(profile);
    const bool greyAsRGB =
        wanted == cmsSigGrayData && there == cmsSigRgbData && !isTableBased(profile.get());
    if (there != wanted && !greyAsRGB) throw ProfileError("a profile of other colours");
}

}  // namespace

ColorMeaning meaningOfProfile(const std::string& bytes, ColorModel model, int channels) {
    if (bytes.size() > kLargestProfile) throw ProfileError("a profile of more than 16 MB");
    const auto context = std::make_shared<IccContext>();
    const IccProfile profile(context, bytes);
    checkUse(profile, model, channels);
    ColorMeaning meaning = meaningOf(profile, model);
    meaning.source = ColorSource::icc;
    meaning.reason = "ICC profile '" + profile.description() + "'";
    if (meaning.curves || meaning.transform) meaning.profile = hashOf(bytes);
    return meaning;
}

}  // namespace specbake::internal
