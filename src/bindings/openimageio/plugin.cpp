#include "spectral_input.h"

#include <OpenImageIO/plugin.h>

/// The names by which OpenImageIO finds a reader in spectral.imageio.so.
OIIO_PLUGIN_EXPORTS_BEGIN

OIIO_EXPORT int spectral_imageio_version = OIIO_PLUGIN_VERSION;

OIIO_EXPORT const char* spectral_imageio_library_version() {
    return nullptr;
}

OIIO_EXPORT OIIO::ImageInput* spectral_input_imageio_create() {
    return new specbake::openimageio::SpectralInput;
}

OIIO_EXPORT const char* spectral_input_extensions[] = {"spectral", nullptr};

OIIO_PLUGIN_EXPORTS_END
