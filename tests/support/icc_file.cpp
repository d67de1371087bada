#include "support/icc_file.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace specbake::testing {
namespace {

std::string savedAndClosed(void* profile) {
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(profile, nullptr, &size);
    std::string bytes(size, '\0');
    const bool saved = cmsSaveProfileToMem(profile, bytes.data(), &size) != 0;
    cmsCloseProfile(profile);
    if (!saved) throw std::runtime_error("no profile");
    return bytes;
}

using Color = std::function<Lab(const float* device)>;

struct Sampling {
    const Color& color;
    cmsUInt32Number channels;
};

/// Lab of version 4 in 16 bits: ICC.1:2010, 10.8 and table 12.
cmsUInt16Number code(double share) {
    return cmsUInt16Number(std::lround(std::clamp(share, 0.0, 1.0) * 65535));
}

int sampleNode(const cmsUInt16Number* in, cmsUInt16Number* out, void* cargo) {
    const auto& sampling = *static_cast<const Sampling*>(cargo);
    float device[4] = {};
    for (cmsUInt32Number i = 0; i < sampling.channels; ++i) device[i] = float(in[i]) / 65535.0F;
    const Lab lab = sampling.color(device);
    out[0] = code(lab.L / 100);
    out[1] = code((lab.a + 128) / 255);
    out[2] = code((lab.b + 128) / 255);
    return 1;
}

}  // namespace

std::string matrixProfile(const Primaries& p, double gamma) {
    const cmsCIExyY white{p.white.x, p.white.y, 1};
    const cmsCIExyYTRIPLE rgb{
        {p.red.x, p.red.y, 1}, {p.green.x, p.green.y, 1}, {p.blue.x, p.blue.y, 1}};
    cmsToneCurve* curve = cmsBuildGamma(nullptr, gamma);
    cmsToneCurve* curves[] = {curve, curve, curve};
    std::string bytes = savedAndClosed(cmsCreateRGBProfile(&white, &rgb, curves));
    cmsFreeToneCurve(curve);
    return bytes;
}

std::string greyProfile(double gamma) {
    cmsToneCurve* curve = cmsBuildGamma(nullptr, gamma);
    std::string bytes = savedAndClosed(cmsCreateGrayProfile(cmsD50_xyY(), curve));
    cmsFreeToneCurve(curve);
    return bytes;
}

std::string tableProfile(cmsColorSpaceSignature space, unsigned grid, const Color& color) {
    const cmsUInt32Number channels = cmsChannelsOf(space);
    void* profile = cmsCreateProfilePlaceholder(nullptr);
    cmsSetProfileVersion(profile, 4.4);
    cmsSetDeviceClass(profile, cmsSigOutputClass);
    cmsSetColorSpace(profile, space);
    cmsSetPCS(profile, cmsSigLabData);
    cmsPipeline* pipeline = cmsPipelineAlloc(nullptr, channels, 3);
    Sampling sampling{color, channels};
    cmsStage* table = cmsStageAllocCLut16bit(nullptr, grid, channels, 3, nullptr);
    cmsStageSampleCLut16bit(table, sampleNode, &sampling, 0);
    // Between curves that do nothing, as lutAToBType wants them.
    cmsPipelineInsertStage(pipeline, cmsAT_END,
                           cmsStageAllocToneCurves(nullptr, channels, nullptr));
    cmsPipelineInsertStage(pipeline, cmsAT_END, table);
    cmsPipelineInsertStage(pipeline, cmsAT_END, cmsStageAllocToneCurves(nullptr, 3, nullptr));
    cmsWriteTag(profile, cmsSigAToB0Tag, pipeline);
    cmsWriteTag(profile, cmsSigMediaWhitePointTag, cmsD50_XYZ());
    cmsPipelineFree(pipeline);
    return savedAndClosed(profile);
}

}  // namespace specbake::testing
