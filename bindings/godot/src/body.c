#include "body.h"

#include <math.h>
#include <stdlib.h>

#include "library.h"

enum { MOUSE_BUTTON_LEFT = 1 };

/* PropertyHint, PropertyUsageFlags. 24/17: an object that is a resource. */
enum { HINT_TYPE_STRING = 23, USAGE_STORAGE = 2, USAGE_DEFAULT = 6 };

const gd_property_row body_properties[PROPERTIES] = {
    [PROPERTY_PARTS] = {"parts", GDEXTENSION_VARIANT_TYPE_ARRAY, HINT_TYPE_STRING, "24/17:DragMeshPart", USAGE_DEFAULT},
    [PROPERTY_BODY] = {"body", GDEXTENSION_VARIANT_TYPE_NODE_PATH, 0, "", USAGE_DEFAULT},
    [PROPERTY_DMO] = {"dmo", GDEXTENSION_VARIANT_TYPE_PACKED_BYTE_ARRAY, 0, "", USAGE_STORAGE},
    [PROPERTY_DMO_PARTS] = {"dmo_parts", GDEXTENSION_VARIANT_TYPE_PACKED_STRING_ARRAY, 0, "", USAGE_STORAGE},
    [PROPERTY_PREPARE] = {"prepare_when_ready", GDEXTENSION_VARIANT_TYPE_BOOL, 0, "", USAGE_DEFAULT},
    [PROPERTY_NAMES] = {"use_names", GDEXTENSION_VARIANT_TYPE_BOOL, 0, "", USAGE_DEFAULT},
    [PROPERTY_PIVOTS] = {"use_pivots", GDEXTENSION_VARIANT_TYPE_BOOL, 0, "", USAGE_DEFAULT},
    [PROPERTY_MOUSE] = {"mouse", GDEXTENSION_VARIANT_TYPE_BOOL, 0, "", USAGE_DEFAULT},
    [PROPERTY_BY_RULE] = {"release_by_rule", GDEXTENSION_VARIANT_TYPE_BOOL, 0, "", USAGE_DEFAULT},
};

static body* first_body;

body* body_new(GDExtensionObjectPtr object) {
    body* b = calloc(1, sizeof *b);
    if (!b) return NULL;
    b->object = object;
    b->mouse = gd_nil();
    for (int i = 0; i < PROPERTIES; i++) b->properties[i] = gd_new(body_properties[i].type);
    const int on[] = {PROPERTY_PREPARE, PROPERTY_NAMES, PROPERTY_PIVOTS, PROPERTY_MOUSE};
    for (size_t i = 0; i < sizeof on / sizeof *on; i++) b->properties[on[i]] = gd_of_bool(true);
    b->next = first_body;
    if (first_body) first_body->previous = b;
    first_body = b;
    return b;
}

void body_free(body* b) {
    body_unload(b);
    if (b->next) b->next->previous = b->previous;
    if (b->previous)
        b->previous->next = b->next;
    else
        first_body = b->next;
    for (int i = 0; i < PROPERTIES; i++) gd_free(&b->properties[i]);
    gd_free(&b->mouse);
    free(b);
}

static void emit(const body* b, const char* signal, gd_value argument) {
    gd_value self = body_self(b), arguments[2] = {gd_of_text(signal), argument};
    gd_do(&self, "emit_signal", 2, arguments);
    gd_free(&arguments[1]);
    gd_free(&arguments[0]);
    gd_free(&self);
}

static void set_process(const body* b, bool on) {
    gd_value self = body_self(b), argument = gd_of_bool(on);
    gd_do(&self, "set_process", 1, &argument);
    gd_free(&argument);
    gd_free(&self);
}

static bool in_editor(void) {
    gd_value engine = gd_singleton("Engine"), answer = gd_call(&engine, "is_editor_hint", 0, NULL);
    const bool editor = gd_bool(&answer);
    gd_free(&answer);
    gd_free(&engine);
    return editor;
}

void body_unload(body* b) {
    preparation* running = b->preparation;
    b->preparation = NULL;
    if (running) {
        preparation_stop(running);
        if (running->object) dm_object_destroy(library_context(), running->object);
        preparation_free(running);
    }
    body_forget_parts(b);
    if (b->scene) dm_scene_destroy(library_context(), b->scene);
    if (b->prepared) dm_object_destroy(library_context(), b->prepared);
    b->scene = 0, b->prepared = 0;
}

/* The parts as they are marked; else all nodes, of which some will turn out to be parts. */
static void find_nodes(body* b) {
    if (body_is_marked(b))
        body_find_parts(b);
    else
        whole_find_members(b);
}

/* Puts a prepared object into use, and the host's joints in force. */
static dm_result take(body* b, dm_object object) {
    dm_object_info info = dm_object_info_default();
    const dm_scene_desc scene = dm_scene_desc_default();
    b->prepared = object;
    dm_result result = dm_object_get_info(library_context(), object, &info);
    if (result == DM_OK && info.part_count != b->part_count) result = DM_ERROR_NOT_FOUND;
    for (uint32_t i = 0; result == DM_OK && i < b->part_count; i++) {
        const settings* s = &b->parts[i].settings;
        if (s->has_joint) result = dm_object_set_joint(library_context(), object, b->parts[i].id, &s->joint);
    }
    if (result == DM_OK) result = dm_scene_create(library_context(), &scene, &b->scene);
    if (result == DM_OK) result = dm_scene_add(library_context(), b->scene, object, NULL, &b->instance);
    if (result == DM_OK) result = dm_scene_commit(library_context(), b->scene);
    return result;
}

/* Keeps the bytes of a .dmo, so that the scene loads them next time. */
static void keep(body* b) {
    size_t size = 0;
    dm_object_save(library_context(), b->prepared, NULL, 0, &size);
    unsigned char* bytes = malloc(size);
    if (bytes && dm_object_save(library_context(), b->prepared, bytes, size, &size) == DM_OK) {
        gd_free(&b->properties[PROPERTY_DMO]);
        gd_free(&b->properties[PROPERTY_DMO_PARTS]);
        b->properties[PROPERTY_DMO] = gd_of_bytes(bytes, size);
        b->properties[PROPERTY_DMO_PARTS] = body_part_paths(b);
    }
    free(bytes);
}

/* Ends a preparation that has run. */
static dm_result finish(body* b) {
    preparation* p = b->preparation;
    b->preparation = NULL;
    dm_result result = p->result;
    const dm_object object = p->object;
    if (result == DM_OK && b->whole) result = whole_take_answer(b, p, object);
    preparation_free(p);
    if (result == DM_OK)
        result = take(b, object);
    else if (object)
        dm_object_destroy(library_context(), object);
    if (result == DM_OK)
        keep(b);
    else
        body_unload(b);
    return result;
}

static bool begin(body* b) {
    if (b->walking) return false;
    body_unload(b);
    find_nodes(b);
    b->preparation = b->whole ? whole_collect(b) : body_collect(b);
    if (!b->preparation) return false;
    b->preparation->model = library_model();
    b->told_progress = -1;
    return true;
}

void body_prepare(body* b) {
    if (!begin(b)) return;
    preparation_start(b->preparation);
    set_process(b, true);
}

dm_result body_prepare_now(body* b) {
    if (!begin(b)) return b->walking ? DM_ERROR_UNSUPPORTED : DM_ERROR_OUT_OF_MEMORY;
    preparation_run(b->preparation);
    return finish(b);
}

/* Whether the parts are those that the .dmo was made of. */
static bool parts_are_known(const body* b) {
    gd_value now = body_part_paths(b);
    const bool known = gd_equal(&now, &b->properties[PROPERTY_DMO_PARTS]);
    gd_free(&now);
    return known;
}

/* Gives the nodes of an asset the parts of a loaded object. */
static dm_result load_whole(body* b, dm_object object) {
    whole_find_members(b);
    const dm_result result = whole_take_paths(b, object);
    return result == DM_OK && !parts_are_known(b) ? DM_ERROR_NOT_FOUND : result;
}

dm_result body_load(body* b) {
    if (b->walking) return DM_ERROR_UNSUPPORTED;
    body_unload(b);
    body_find_parts(b); /* until 0.2 every mesh was a part where none was marked */
    const bool known = parts_are_known(b);
    if (!known && body_is_marked(b)) return DM_ERROR_NOT_FOUND;
    const gd_value* dmo = &b->properties[PROPERTY_DMO];
    dm_object object = 0;
    dm_result result =
        dm_object_load(library_context(), gd_bytes(dmo), (size_t)gd_count(dmo), library_model(), &object);
    if (result != DM_OK) return result;
    if (!known) result = load_whole(b, object);
    if (result == DM_OK)
        result = take(b, object);
    else
        dm_object_destroy(library_context(), object);
    if (result != DM_OK) body_unload(b);
    return result;
}

void body_ready(body* b) {
    set_process(b, true);
    if (b->prepared || b->preparation) return;
    if (gd_count(&b->properties[PROPERTY_DMO]) > 0 && body_load(b) == DM_OK) return;
    if (gd_bool(&b->properties[PROPERTY_PREPARE]) && !in_editor()) body_prepare(b);
}

/* False: the node is gone, for a script has freed it. */
static bool advance_preparation(body* b) {
    if (!b->preparation) return true;
    const GDObjectInstanceID id = gd.object_get_instance_id(b->object);
    const float progress = atomic_load(&b->preparation->progress);
    if (progress > b->told_progress) {
        b->told_progress = progress;
        emit(b, "progress", gd_of_float((double)progress));
        if (!gd.object_get_instance_from_id(id)) return false;
    }
    if (!b->preparation || !atomic_load(&b->preparation->finished)) return true; /* it may be another one by now */
    const dm_result result = finish(b);
    emit(b, "prepared", gd_of_text(result == DM_OK ? "" : dm_result_string(result)));
    return gd.object_get_instance_from_id(id) != NULL;
}

/* The camera's ray through the pointer; false: no camera. */
static bool mouse_ray(const body* b, const gd_value* position, double origin[3], double direction[3]) {
    gd_value self = body_self(b), viewport = gd_call(&self, "get_viewport", 0, NULL);
    gd_value camera = gd_object(&viewport) ? gd_call(&viewport, "get_camera_3d", 0, NULL) : gd_nil();
    const bool found = gd_object(&camera) != NULL;
    if (found) {
        gd_value from = gd_call(&camera, "project_ray_origin", 1, position);
        gd_value along = gd_call(&camera, "project_ray_normal", 1, position);
        gd_vector3(&from, origin);
        gd_vector3(&along, direction);
        gd_free(&along);
        gd_free(&from);
    }
    gd_free(&camera);
    gd_free(&viewport);
    gd_free(&self);
    return found;
}

static void advance_part(body* b, part* p, double seconds) {
    dm_drag_input input = dm_drag_input_default();
    dm_drag_state state;
    double origin[3], direction[3];
    if (!p->drag || (p->held && !p->by_mouse)) return;
    if (p->by_mouse && mouse_ray(b, &b->mouse, origin, direction)) {
        input.hand.kind = DM_HAND_RAY;
        input.hand.ray = body_ray(b, p, origin, direction);
    }
    if (part_step(b, p, &input, seconds, &state) == DM_OK && state.phase == DM_DRAG_AT_REST) part_end(p);
}

void body_advance(body* b, double seconds) {
    if (!advance_preparation(b) || !b->prepared) return;
    for (uint32_t i = 0; i < b->part_count; i++) advance_part(b, &b->parts[i], seconds);
    body_tell(b);
}

void body_process(body* b) {
    gd_value self = body_self(b), delta = gd_call(&self, "get_process_delta_time", 0, NULL);
    const double seconds = gd_float(&delta);
    gd_free(&delta);
    gd_free(&self);
    body_advance(b, seconds);
}

static void set_handled(const body* b) {
    gd_value self = body_self(b), viewport = gd_call(&self, "get_viewport", 0, NULL);
    gd_do(&viewport, "set_input_as_handled", 0, NULL);
    gd_free(&viewport);
    gd_free(&self);
}

static GDExtensionObjectPtr viewport_of(const body* b) {
    gd_value self = body_self(b), viewport = gd_call(&self, "get_viewport", 0, NULL);
    const GDExtensionObjectPtr object = gd_object(&viewport);
    gd_free(&viewport);
    gd_free(&self);
    return object;
}

/* Grabs the nearest part under the pointer, of all bodies that this viewport shows. */
static void grab_nearest(body* b, const gd_value* position) {
    double origin[3], direction[3], nearest = INFINITY, distance;
    dm_hit hit, best = dm_hit_default();
    body* found = NULL;
    const GDExtensionObjectPtr viewport = viewport_of(b);
    if (!mouse_ray(b, position, origin, direction)) return;
    for (body* other = first_body; other; other = other->next) {
        if (viewport_of(other) != viewport || !body_pick(other, origin, direction, &hit, &distance)) continue;
        if (distance < nearest) nearest = distance, best = hit, found = other;
    }
    part* p = found && gd_bool(&found->properties[PROPERTY_MOUSE]) ? body_part(found, best.part_id) : NULL;
    if (!p || part_grab(found, p, &best.object_point, true) != DM_OK) return;
    gd_free(&found->mouse);
    found->mouse = gd_copy(position);
    set_handled(b);
}

void body_input(body* b, const gd_value* event) {
    gd_value type = gd_of_text("InputEventMouse"), is_mouse = gd_call(event, "is_class", 1, &type);
    const bool mouse = gd_bool(&is_mouse) && !in_editor();
    gd_free(&is_mouse);
    gd_free(&type);
    if (!mouse) return;
    gd_value position = gd_get(event, "position"), button = gd_get(event, "button_index"),
             pressed = gd_get(event, "pressed");
    if (gd_int(&button) == MOUSE_BUTTON_LEFT && gd_bool(&pressed)) grab_nearest(b, &position);
    for (uint32_t i = 0; i < b->part_count; i++) {
        part* p = &b->parts[i];
        if (!p->by_mouse) continue;
        gd_free(&b->mouse);
        b->mouse = gd_copy(&position);
        if (gd_int(&button) == MOUSE_BUTTON_LEFT && !gd_bool(&pressed)) part_release(b, p, DM_GO_AUTO, NULL);
    }
    gd_free(&pressed);
    gd_free(&button);
    gd_free(&position);
}
