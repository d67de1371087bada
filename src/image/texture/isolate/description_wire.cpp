#include "texture/isolate/wire.h"

namespace specbake::internal {
namespace {

void putAttribute(Message& message, const AttributeValue& value) {
    message.put(std::uint8_t(value.index()));
    if (const auto* text = std::get_if<std::string>(&value)) {
        message.putText(*text);
    } else if (const auto* number = std::get_if<int>(&value)) {
        message.put(*number);
    } else if (const auto* real = std::get_if<float>(&value)) {
        message.put(*real);
    } else if (const auto* reals = std::get_if<std::vector<float>>(&value)) {
        message.put(std::uint64_t(reals->size()));
        for (const float component : *reals) message.put(component);
    }
}

AttributeValue takeAttribute(Message& message) {
    switch (message.take<std::uint8_t>()) {
        case 0:
            return message.takeText();
        case 1:
            return message.take<int>();
        case 2:
            return message.take<float>();
        case 3: {
            std::vector<float> reals;
            for (std::size_t left = message.takeCount(); left > 0; --left) {
                reals.push_back(message.take<float>());
            }
            return reals;
        }
        default:
            throw WireError("an attribute of no type");
    }
}

void putTexts(Message& message, const std::vector<std::string>& texts) {
    message.put(std::uint64_t(texts.size()));
    for (const std::string& text : texts) message.putText(text);
}

std::vector<std::string> takeTexts(Message& message) {
    std::vector<std::string> texts;
    for (std::size_t left = message.takeCount(); left > 0; --left) {
        texts.push_back(message.takeText());
    }
    return texts;
}

template <class T>
void putOptional(Message& message, const std::optional<T>& value) {
    message.put(std::uint8_t(value.has_value()));
    message.put(value.value_or(T{}));
}

template <class T>
std::optional<T> takeOptional(Message& message) {
    const bool there = message.take<std::uint8_t>() != 0;
    const T value = message.take<T>();
    return there ? std::optional(value) : std::nullopt;
}

bool takeYes(Message& message) {
    return message.take<std::uint8_t>() != 0;
}

/// One of an enumeration's values, of which `last` is the last.
template <class Enum>
Enum takeEnum(Message& message, Enum last) {
    const int value = message.take<int>();
    if (value < 0 || value > int(last)) throw WireError("no such kind");
    return Enum(value);
}

void putSigns(Message& message, const ColorSigns& signs) {
    message.put(int(signs.model)).putText(signs.icc);
    message.put(std::uint8_t(signs.cicp.has_value()));
    if (const auto& points = signs.cicp) {
        message.put(points->primaries).put(points->transfer).put(points->matrix);
        message.put(std::uint8_t(points->fullRange));
    }
    message.put(std::uint8_t(signs.srgb));
    putOptional(message, signs.gamma);
    putOptional(message, signs.chromaticities);
}

ColorSigns takeSigns(Message& message) {
    ColorSigns signs;
    signs.model = takeEnum(message, ColorModel::iccLab);
    signs.icc = message.takeText();
    if (takeYes(message)) {
        CodePoints points;
        points.primaries = message.take<int>();
        points.transfer = message.take<int>();
        points.matrix = message.take<int>();
        points.fullRange = takeYes(message);
        signs.cicp = points;
    }
    signs.srgb = takeYes(message);
    signs.gamma = takeOptional<double>(message);
    signs.chromaticities = takeOptional<Primaries>(message);
    return signs;
}

void check(const ImageDescription& d) {
    constexpr std::size_t mostChannels = 1024;
    const Window& w = d.data;
    const bool bounded = w.width >= 1 && w.height >= 1 && w.width <= kLargestSide &&
                         w.height <= kLargestSide && !isFarOut(w) && !isFarOut(d.display);
    const bool channels = !d.channels.empty() && d.channels.size() <= mostChannels;
    const bool alpha = !d.alpha || (*d.alpha >= 0 && *d.alpha < int(d.channels.size()));
    const bool turned = d.orientation >= 1 && d.orientation <= 8;
    if (!bounded || !channels || !alpha || !turned) throw WireError("an impossible image");
}

}  // namespace

void putDescription(Message& message, const ImageDescription& d) {
    message.put(d.data).put(d.display).put(d.pixelAspectRatio);
    putTexts(message, d.channels);
    putOptional(message, d.alpha);
    message.put(std::uint8_t(d.associatedAlpha)).put(int(d.sampleType));
    message.put(std::uint8_t(d.integers)).put(d.orientation);
    putSigns(message, d.signs);
    message.put(std::uint64_t(d.attributes.size()));
    for (const auto& [name, value] : d.attributes) {
        message.putText(name);
        putAttribute(message, value);
    }
    message.putText(d.parts);
    putTexts(message, d.notes);
}

ImageDescription takeDescription(Message& message) {
    ImageDescription d;
    d.data = message.take<Window>();
    d.display = message.take<Window>();
    d.pixelAspectRatio = message.take<float>();
    d.channels = takeTexts(message);
    d.alpha = takeOptional<int>(message);
    d.associatedAlpha = takeYes(message);
    d.sampleType = takeEnum(message, TexelType::float32);
    d.integers = takeYes(message);
    d.orientation = message.take<int>();
    d.signs = takeSigns(message);
    for (std::size_t left = message.takeCount(); left > 0; --left) {
        std::string name = message.takeText();
        d.attributes.insert_or_assign(std::move(name), takeAttribute(message));
    }
    d.parts = message.takeText();
    d.notes = takeTexts(message);
    check(d);
    return d;
}

}  // namespace specbake::internal
