#include "texture/color/lab_and_inks.h"

#include "texture/color/icc_context.h"

namespace specbake::internal {
namespace {

/// The inverse of CIE 15, (8.7).
double fromLabResponse(double f) {
    constexpr double delta = 6.0 / 29.0;
    return f > delta ? f * f * f : 3 * delta * delta * (f - 4.0 / 29.0);
}

XYZ xyzFromLab(const Lab& lab, const XYZ& white) {
    const double fy = (lab.L + 16) / 116;
    return {white.x * fromLabResponse(fy + lab.a / 500), white.y * fromLabResponse(fy),
            white.z * fromLabResponse(fy - lab.b / 200)};
}

class LabTransform : public PixelTransform {
  public:
    LabTransform(ColorModel model, TexelType type)
        : signed_(model == ColorModel::cieLab),
          eightBits_(type == TexelType::uint8),
          linearFromXYZ_(xyzFromRGB(*findColorSpace("lin_prophoto"), pcsWhite()).inverse()) {}

    void run(const float* stored, std::size_t count, std::array<float, 3>* linear) const override {
        for (std::size_t i = 0; i < count; ++i) {
            const float* at = stored + 3 * i;
            const XYZ xyz =
                xyzFromLab({lightness(at[0]), opponent(at[1]), opponent(at[2])}, pcsWhite());
            const Imath::V3d color = xyz * linearFromXYZ_;
            linear[i] = {float(color.x), float(color.y), float(color.z)};
        }
    }

  private:
    /// The integer that is stored, counted in steps of 8 bits.
    double code(float stored) const {
        return double(stored) * (eightBits_ ? 255.0 : 65535.0 / 256);
    }
    /// ICC's 16 bits have 100 at 0xff00.
    double lightness(float stored) const {
        const bool full = signed_ || eightBits_;
        return 100 * (full ? double(stored) : double(stored) * 65535 / 65280);
    }
    double opponent(float stored) const {
        const double value = code(stored);
        if (!signed_) return value - 128;
        return value < 128 ? value : value - 256;
    }

    bool signed_;
    bool eightBits_;
    Imath::M33d linearFromXYZ_;
};

class InkTransform : public PixelTransform {
  public:
    InkTransform(bool onPaper, const Transfer& transfer) : onPaper_(onPaper), transfer_(transfer) {}

    void run(const float* stored, std::size_t count, std::array<float, 3>* linear) const override {
        const auto left = [this](float s) { return double(onPaper_ ? s : 1 - s); };
        for (std::size_t i = 0; i < count; ++i) {
            const float* at = stored + 4 * i;
            for (std::size_t c = 0; c < 3; ++c) {
                linear[i][c] = float(linearFrom(left(at[c]) * left(at[3]), transfer_));
            }
        }
    }

  private:
    bool onPaper_;
    Transfer transfer_;
};

}  // namespace

bool isLab(ColorModel model) {
    return model == ColorModel::cieLab || model == ColorModel::iccLab;
}

bool isInks(ColorModel model) {
    return model == ColorModel::cmyk || model == ColorModel::cmykOnPaper;
}

const std::vector<std::string>& colorNames(ColorModel model) {
    static const std::vector<std::string> lab = {"L*", "a*", "b*"};
    static const std::vector<std::string> inks = {"C", "M", "Y", "K"};
    static const std::vector<std::string> others;
    if (isLab(model)) return lab;
    return isInks(model) ? inks : others;
}

std::shared_ptr<const PixelTransform> transformOfLab(ColorModel model, TexelType type) {
    return std::make_shared<LabTransform>(model, type);
}

std::shared_ptr<const PixelTransform> transformOfInks(ColorModel model, const Transfer& transfer) {
    return std::make_shared<InkTransform>(model == ColorModel::cmykOnPaper, transfer);
}

}  // namespace specbake::internal
