/* Writes a picture as an OpenEXR file through the OpenEXR core library, which
 * hands bytes to a file that is renamed once it is whole. */
#include "render/exr.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <openexr.h>

#include "base/file.h"
#include "render/channels.h"

/* ---- callbacks of the library ---- */

/* Ignores error messages: errors are reported by the results of calls. The
 * library calls this handler with the file locked, so that a call of the
 * library from here would wait forever. */
static void ignore(exr_const_context_t context, exr_result_t code,
                   const char *message)
{
    (void)context;
    (void)code;
    (void)message;
}

static int64_t put(exr_const_context_t context, void *data, const void *bytes,
                   uint64_t size, uint64_t offset,
                   exr_stream_error_func_ptr_t fail)
{
    FILE *stream = murk_file_stream(data);
    (void)context;
    (void)fail;
    if (fseeko(stream, (off_t)offset, SEEK_SET) != 0 ||
        fwrite(bytes, 1, (size_t)size, stream) != size) {
        return -1;
    }
    return (int64_t)size;
}

/* ---- the file ---- */

static exr_result_t write_header(exr_context_t file, const murk_exr *exr,
                                 const murk_channel *list, size_t n)
{
    /* One part of scanlines, compressed by ZIP. */
    int part = 0;
    exr_result_t result =
        exr_add_part(file, "murk", EXR_STORAGE_SCANLINE, &part);
    if (!result) {
        result = exr_initialize_required_attr_simple(
            file, part, (int32_t)exr->picture->width,
            (int32_t)exr->picture->height, EXR_COMPRESSION_ZIP);
    }
    /* Projection and shape of the pixels. */
    if (!result && exr->is_all_round) {
        result = exr_attr_set_envmap(file, part, "envmap", EXR_ENVMAP_LATLONG);
    }
    if (!result) {
        result =
            exr_set_pixel_aspect_ratio(file, part, (float)exr->pixel_aspect);
    }
    /* The channels, and the texts about the picture. */
    for (size_t i = 0; i < n && !result; ++i) {
        result = exr_add_channel(file, part, list[i].name, EXR_PIXEL_FLOAT,
                                 EXR_PERCEPTUALLY_LINEAR, 1, 1);
    }
    for (size_t i = 0; i < exr->n_header && !result; ++i) {
        result = exr_attr_set_string(file, part, exr->header[i].name,
                                     exr->header[i].text);
    }
    return result ? result : exr_write_header(file);
}

static const float *rows_of(const murk_channel *list, size_t n,
                            const char *name)
{
    for (size_t i = 0; i < n; ++i) {
        if (strcmp(list[i].name, name) == 0) {
            return list[i].value;
        }
    }
    return NULL;
}

/* Writes the rows of one chunk, from row y on. */
static exr_result_t write_rows(exr_context_t file, const murk_exr *exr,
                               const murk_channel *list, size_t n, int y,
                               exr_encode_pipeline_t *encoder, bool is_first)
{
    exr_chunk_info_t chunk;
    exr_result_t result = exr_write_scanline_chunk_info(file, 0, y, &chunk);
    if (result) {
        return result;
    }
    result = is_first ? exr_encoding_initialize(file, 0, &chunk, encoder)
                      : exr_encoding_update(file, 0, &chunk, encoder);
    /* Each channel reads its rows from the picture. */
    const size_t width = exr->picture->width;
    for (int c = 0; c < encoder->channel_count && !result; ++c) {
        exr_coding_channel_info_t *of = &encoder->channels[c];
        const float *rows = rows_of(list, n, of->channel_name);
        of->user_bytes_per_element = sizeof(float);
        of->user_data_type = EXR_PIXEL_FLOAT;
        of->user_pixel_stride = sizeof(float);
        of->user_line_stride = (int32_t)(width * sizeof(float));
        of->encode_from_ptr = (const uint8_t *)(rows + (size_t)y * width);
    }
    if (is_first && !result) {
        result = exr_encoding_choose_default_routines(file, 0, encoder);
    }
    return result ? result : exr_encoding_run(file, 0, encoder);
}

static exr_result_t write_all(exr_context_t file, const murk_exr *exr,
                              const murk_channel *list, size_t n)
{
    exr_result_t result = write_header(file, exr, list, n);
    int32_t step = 1;
    if (!result) {
        result = exr_get_scanlines_per_chunk(file, 0, &step);
    }
    exr_encode_pipeline_t encoder = EXR_ENCODE_PIPELINE_INITIALIZER;
    const int height = (int)exr->picture->height;
    for (int y = 0; y < height && !result; y += step) {
        result = write_rows(file, exr, list, n, y, &encoder, y == 0);
    }
    exr_encoding_destroy(file, &encoder);
    return result;
}

murk_status murk_exr_write(const murk_exr *exr, const char *path,
                           murk_error *err)
{
    murk_channel *list = calloc(MURK_CHANNELS_MAX, sizeof *list);
    if (!list) {
        return murk_no_memory(err, path, "for an image");
    }
    /* The channels of the picture, and the file that receives them. */
    const murk_image *p = exr->picture;
    const size_t n =
        murk_channels_list(p, p->bands, exr->band_nm, p->seen_by != NULL, list);
    murk_file *out = NULL;
    murk_status status = murk_file_create(&out, path, err);
    if (status) {
        free(list);
        return status;
    }
    /* Write through the library, and discard the file after a failure. */
    exr_context_initializer_t setup = EXR_DEFAULT_CONTEXT_INITIALIZER;
    setup.error_handler_fn = ignore;
    setup.user_data = out;
    setup.write_fn = put;
    exr_context_t file = NULL;
    exr_result_t result =
        exr_start_write(&file, path, EXR_WRITE_FILE_DIRECTLY, &setup);
    if (!result) {
        result = write_all(file, exr, list, n);
        const exr_result_t closed = exr_finish(&file);
        result = result ? result : closed;
    }
    free(list);
    if (result) {
        murk_file_discard(out);
        return murk_fail(err, MURK_RUN_FAILED, path, "cannot be written: %s",
                         exr_get_default_error_message(result));
    }
    status = murk_file_commit(&out, err);
    murk_file_discard(out);
    return status;
}
