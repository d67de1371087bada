#include "texture/openimageio/openimageio_parts.h"

extern "C" const specbake::OpenImageIOParts* specbakeOpenImageIOParts() {
    return &specbake::openImageIOParts({});
}
