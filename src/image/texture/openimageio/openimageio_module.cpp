#include "texture/openimageio/openimageio_parts.h"

extern "C" const specbake::internal::OpenImageIOParts* specbakeOpenImageIOParts() {
    return &specbake::internal::openImageIOParts({});
}
