#include <specbake/sampler.h>

/// What a renderer writes: it must compile as C++17, by this header alone.
float reflectanceAt(const specbake::SpectralTable& table, float r, float g, float b, float nm);

float reflectanceAt(const specbake::SpectralTable& table, float r, float g, float b, float nm) {
    const auto place = table.locate(r, g, b);
    float four[4];
    table.eval(place, table.wavelengths<4>({nm, nm + 90, nm + 180, nm + 270}), four);
    return table.eval(place, nm) + four[3];
}
