/* Command-line arguments, read by a table. */
#include "options.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "output_file.h"

int options_refuse(const cli_command* command, const char* format, ...) {
    va_list arguments;
    fprintf(stderr, "dragmesh %s: ", command->name);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fprintf(stderr, "\nusage: dragmesh %s %s\n", command->name, command->usage);
    return CLI_USAGE;
}

void name_list_add(name_list* list, const char* name, size_t length) {
    list->names = cli_grow(list->names, (list->count + 1) * sizeof *list->names);
    char* copy = cli_alloc(length + 1);
    memcpy(copy, name, length);
    copy[length] = 0;
    list->names[list->count++] = copy;
}

void name_list_free(name_list* list) {
    for (unsigned i = 0; i < list->count; i++) free(list->names[i]);
    free(list->names);
    *list = (name_list){NULL, 0};
}

static void read_names(name_list* list, const char* text) {
    for (;;) {
        const size_t length = strcspn(text, ",");
        name_list_add(list, text, length);
        if (text[length] == 0) return;
        text += length + 1;
    }
}

/* A finite number that ends at `end`; 0 when there is none. */
static bool read_number(const char* text, char end, double* out, const char** out_rest) {
    char* rest;
    *out = strtod(text, &rest);
    if (rest == text || *rest != end || !isfinite(*out)) return false;
    *out_rest = end ? rest + 1 : rest;
    return true;
}

static bool read_doubles(const char* text, int count, double* out) {
    for (int i = 0; i < count; i++)
        if (!read_number(text, i + 1 < count ? ',' : 0, &out[i], &text)) return false;
    return true;
}

static bool read_numbers(const char* text, int count, float* out) {
    for (int i = 0; i < count; i++) {
        double number;
        if (!read_number(text, i + 1 < count ? ',' : 0, &number, &text)) return false;
        out[i] = (float)number;
    }
    return true;
}

/* 0 when `text` is no value of the option. */
static bool read_value(const option_spec* option, const char* text) {
    const char* rest;
    char* end;
    switch (option->kind) {
    case OPTION_FLAG:
        *(int*)option->value = 1;
        return true;
    case OPTION_TEXT:
    case OPTION_CHOICE:
        *(const char**)option->value = text;
        return true;
    case OPTION_NAMES:
        read_names(option->value, text);
        return true;
    case OPTION_OPTIONAL:
        if (text[0] == 0) return true;
        return read_number(text, 0, option->value, &rest);
    case OPTION_NUMBER:
        return read_number(text, 0, option->value, &rest);
    case OPTION_NUMBERS:
        return read_numbers(text, option->count, option->value);
    case OPTION_DOUBLES:
        return read_doubles(text, option->count, option->value);
    case OPTION_INTEGER:
    case OPTION_SEED:
        break;
    }
    errno = 0;
    const long number = strtol(text, &end, 10);
    if (end == text || *end || errno || number < -1000000000 || number > 1000000000) return false;
    *(int*)option->value = (int)number;
    return true;
}

/* Returns the choice that `text` is, NULL: none; then *out_last is the last one. */
static const char* find_choice(const option_spec* option, const char* text, const char** out_last) {
    for (const char* const* choice = option->choices; *choice != NULL; choice++) {
        if (text != NULL && strcmp(*choice, text) == 0) return *choice;
        *out_last = *choice;
    }
    return NULL;
}

/* What is to be read as the option's value; NULL when it is missing. Steps over the argument that it takes. */
static const char* take_value(const option_spec* option, int argc, char** argv, int* at) {
    if (option->kind == OPTION_FLAG) return "";
    const char* next = *at + 1 < argc ? argv[*at + 1] : NULL;
    int ignored;
    const option_spec integer = {.kind = OPTION_INTEGER, .value = &ignored};
    if (option->kind == OPTION_SEED && !(next != NULL && read_value(&integer, next))) return "1";
    double unread;
    const option_spec number = {.kind = OPTION_NUMBER, .value = &unread};
    if (option->kind == OPTION_OPTIONAL && !(next != NULL && read_value(&number, next))) return "";
    const char* last = "";
    if (option->kind == OPTION_CHOICE && find_choice(option, next, &last) == NULL) return last;
    if (next != NULL) ++*at;
    return next;
}

static bool is_help(const char* text) {
    return strcmp(text, "--help") == 0 || strcmp(text, "-h") == 0;
}

static const option_spec* find_option(const option_spec* options, size_t count, const char* name) {
    for (size_t i = 0; i < count; i++) {
        if (strcmp(options[i].name, name) == 0) return &options[i];
    }
    return NULL;
}

int options_read(const cli_command* command, int argc, char** argv, const option_spec* options, size_t option_count,
                 const char** out_operand) {
    bool reads_options = true;
    int operands = 0;
    for (int i = 1; i < argc; i++) {
        const option_spec* option = reads_options ? find_option(options, option_count, argv[i]) : NULL;
        if (option == NULL && reads_options && is_help(argv[i])) {
            command_print_help(command);
            return CLI_HELPED;
        }
        if (option == NULL && reads_options && strcmp(argv[i], "--") == 0) {
            reads_options = false;
            continue;
        }
        if (option == NULL && reads_options && argv[i][0] == '-' && argv[i][1])
            return options_refuse(command, "no option '%.200s'", argv[i]);
        if (option == NULL) {
            if (out_operand == NULL || operands++)
                return options_refuse(command, "'%.200s' is one argument too many", argv[i]);
            *out_operand = argv[i];
            continue;
        }
        const char* value = take_value(option, argc, argv, &i);
        if (value == NULL) return options_refuse(command, "%s needs a value", option->name);
        if (!read_value(option, value))
            return options_refuse(command, "%s: '%.200s' can't be read", option->name, value);
        if (option->given != NULL) *option->given = 1;
    }
    return CLI_OK;
}

static bool ends_with(const char* path, const char* suffix) {
    const size_t length = strlen(path), end = strlen(suffix);
    if (length <= end) return false;
    for (size_t i = 0; i < end; i++)
        if (tolower((unsigned char)path[length - end + i]) != suffix[i]) return false;
    return true;
}

int options_check_output(const cli_command* command, const char* option, const char* path, const char* suffix) {
    if (ends_with(path, suffix) || output_is_stream(path) || platform_kind_of(path) == PLATFORM_FOLDER) return CLI_OK;
    return options_refuse(command, "%s: it writes %s; '%.200s' has another suffix", option, suffix, path);
}
