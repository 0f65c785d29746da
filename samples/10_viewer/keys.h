/* Key bindings. */
#ifndef VIEWER_KEYS_H
#define VIEWER_KEYS_H

#include "app.h"

typedef struct key_binding {
    const char* key; /* as SDL names it */
    const char* label;
    const char* help;
    void (*act)(app* app);
} key_binding;

extern const key_binding key_bindings[];
extern const int key_binding_count;

void keys_press(app* app, const char* key);

/* Aims the camera at the whole object. */
void keys_frame(app* app);

#endif
