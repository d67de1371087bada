#include "color/names.h"

#include <specbake/core/transfer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace specbake {

using namespace internal;

namespace {

struct NamedTransfer {
    std::string_view name;
    Transfer transfer;
};

constexpr std::array<NamedTransfer, 5> kNamed = {{{"linear", Transfer::linear},
                                                  {"srgb", Transfer::sRGB},
                                                  {"rec709", Transfer::rec709},
                                                  {"romm", Transfer::romm},
                                                  {"prophoto", Transfer::romm}}};

constexpr std::string_view kGamma = "gamma:";
constexpr std::string_view kCurve = "curve:";

/// Exponents beyond these are slips of the keyboard.
bool isRising(const Transfer& t) {
    return t.gamma >= 0.1 && t.gamma <= 10 && t.divisor > 0 && t.slope > 0 && t.offset >= 0 &&
           t.knee >= 0 && t.knee < 1;
}

std::optional<Transfer> checked(const Transfer& transfer) {
    return isRising(transfer) ? std::optional(transfer) : std::nullopt;
}

std::optional<Transfer> fromNumbers(std::string_view text) {
    const auto numbers = numbersOf(text);
    if (!numbers) return {};
    if (numbers->size() == 1) return checked(Transfer::power(numbers->front()));
    if (numbers->size() != 5) return {};
    const std::vector<double>& n = *numbers;
    return checked({n[0], n[1], n[2], n[3], n[4]});
}

}  // namespace

double linearFrom(double encoded, const Transfer& t) {
    if (t == Transfer::linear) return encoded;
    const double v = std::abs(encoded);
    const double linear = v <= t.knee ? v / t.slope : std::pow((v + t.offset) / t.divisor, t.gamma);
    return std::copysign(linear, encoded);
}

double linearFromSRGB(double encoded) {
    return linearFrom(encoded, Transfer::sRGB);
}

double sRGBFromLinear(double linear) {
    const double v = std::abs(linear);
    const double encoded = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
    return std::copysign(encoded, linear);
}

std::string transferName(const Transfer& transfer) {
    for (const NamedTransfer& named : kNamed) {
        if (named.transfer == transfer) return std::string(named.name);
    }
    if (transfer == Transfer::power(transfer.gamma)) {
        return std::string(kGamma) + decimal(transfer.gamma);
    }
    return std::string(kCurve) +
           decimals(std::array{transfer.gamma, transfer.offset, transfer.divisor, transfer.slope,
                               transfer.knee});
}

std::optional<Transfer> transferFromName(std::string_view name) {
    const std::string text = lowerCase(name);
    for (const NamedTransfer& named : kNamed) {
        if (named.name == text) return named.transfer;
    }
    for (const std::string_view prefix : {kGamma, kCurve, std::string_view("gamma")}) {
        if (text.starts_with(prefix))
            return fromNumbers(std::string_view(text).substr(prefix.size()));
    }
    return {};
}

}  // namespace specbake
