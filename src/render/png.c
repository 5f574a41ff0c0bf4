/* Writes a raster as a PNG file through libpng, with texts about the picture,
 * to a file that is renamed once it is whole. */
#include "render/png.h"

#include <setjmp.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include <png.h>

#include "base/file.h"

typedef struct writer {
    png_structp png;
    png_infop info;
    png_textp text;
    char message[128]; /* error message of libpng */
} writer;

murk_status murk_raster_create(murk_raster *out, size_t width, size_t height,
                               murk_error *err)
{
    *out = (murk_raster){width, height, calloc(width * height, 3)};
    return out->rgb ? MURK_OK
                    : murk_no_memory(err, "render",
                                     "for an image of %zu x %zu pixels", width,
                                     height);
}

void murk_raster_fill(murk_raster *raster, size_t left, size_t top,
                      size_t width, size_t height, const uint8_t rgb[3])
{
    for (size_t y = top; y < top + height && y < raster->height; ++y) {
        uint8_t *row = raster->rgb + y * raster->width * 3;
        for (size_t x = left; x < left + width && x < raster->width; ++x) {
            memcpy(row + 3 * x, rgb, 3);
        }
    }
}

/* Error handler of libpng: it must not return, so it jumps to setjmp() in
 * write_all(). */
static void fail(png_structp png, png_const_charp message)
{
    writer *w = png_get_error_ptr(png);
    snprintf(w->message, sizeof w->message, "%s", message);
    png_longjmp(png, 1);
}

static void ignore(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

static bool set_up(writer *w, size_t n_text)
{
    w->png = png_create_write_struct(PNG_LIBPNG_VER_STRING, w, fail, ignore);
    w->info = w->png ? png_create_info_struct(w->png) : NULL;
    w->text = calloc(n_text + 1, sizeof *w->text);
    return w->info && w->text;
}

static void put_text(writer *w, const murk_image_text *text, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        w->text[i] = (png_text){.compression = PNG_ITXT_COMPRESSION_NONE,
                                .key = (char *)(uintptr_t)text[i].name,
                                .text = (char *)(uintptr_t)text[i].text,
                                .itxt_length = strlen(text[i].text)};
    }
    png_set_text(w->png, w->info, w->text, (int)n);
}

/* Writes the whole image. Returns false with a reason in w->message. No
 * variable that is read after a jump is changed after setjmp(). */
static bool write_all(writer *w, const murk_raster *raster,
                      const murk_image_text *text, size_t n_text, FILE *stream)
{
    if (setjmp(png_jmpbuf(w->png))) {
        return false;
    }
    png_init_io(w->png, stream);
    png_set_IHDR(w->png, w->info, (png_uint_32)raster->width,
                 (png_uint_32)raster->height, 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(w->png, w->info, PNG_sRGB_INTENT_PERCEPTUAL);
    put_text(w, text, n_text);
    png_write_info(w->png, w->info);
    for (size_t y = 0; y < raster->height; ++y) {
        png_write_row(w->png, raster->rgb + y * raster->width * 3);
    }
    png_write_end(w->png, NULL);
    return true;
}

murk_status murk_png_write(const murk_raster *raster,
                           const murk_image_text *text, size_t n_text,
                           const char *path, murk_error *err)
{
    writer w = {0};
    murk_file *file = NULL;
    murk_status status = murk_file_create(&file, path, err);
    if (!status && !set_up(&w, n_text)) {
        status = murk_no_memory(err, path, "to write an image");
    }
    if (!status &&
        !write_all(&w, raster, text, n_text, murk_file_stream(file))) {
        status = murk_fail(err, MURK_RUN_FAILED, path, "cannot be written: %s",
                           w.message);
    }
    if (!status) {
        status = murk_file_commit(&file, err);
    }
    png_destroy_write_struct(&w.png, &w.info);
    free(w.text);
    murk_file_discard(file);
    return status;
}
