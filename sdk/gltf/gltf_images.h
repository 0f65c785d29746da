/* Images beside a document. */
#ifndef DMI_GLTF_IMAGES_H
#define DMI_GLTF_IMAGES_H

#include "gltf/gltf_edit.h"

/* Puts the images that the host hands over into the buffer. Others keep their URIs. */
void dmi_images_embed(dmi_edit* e);

#endif
