/* PNG files of a result folder as pictures of the page, with the texts that
 * murk wrote into them as captions; EXR files, which browsers do not show, by
 * name. Files that are no PNG, or are of improbable size, are left out. */
#include "report/pictures.h"

#include "base/file.h"
#include "base/inputs.h"
#include "report/html.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Limit on pixels along an edge: more are taken for a mistake, or for an attack
 * on the browser. */
#define EDGE_MAX 8192

#define NAMED_MAX 40 /* EXR files that are named */

/* ---- PNG: a signature, then chunks of length, type, data and a checksum ----
 */

/* ISO/IEC 15948, 5.2. */
static const unsigned char signature[8] = {0x89, 'P',  'N',  'G',
                                           '\r', '\n', 0x1a, '\n'};

static uint32_t number_at(const unsigned char *bytes)
{
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 |
           (uint32_t)bytes[2] << 8 | bytes[3];
}

/* Bytes of the signature and the header chunk of a file. */
#define HEAD_SIZE 33

static bool read_head(murk_report_picture *p,
                      const unsigned char head[HEAD_SIZE])
{
    if (memcmp(head, signature, 8) != 0 || number_at(head + 8) != 13 ||
        memcmp(head + 12, "IHDR", 4) != 0) {
        return false;
    }
    p->width = number_at(head + 16);
    p->height = number_at(head + 20);
    return p->width >= 1 && p->width <= EDGE_MAX && p->height >= 1 &&
           p->height <= EDGE_MAX;
}

/* The text that a picture has under a name, in an uncompressed iTXt chunk
 * (ISO/IEC 15948, 11.3.4.5), as murk writes it. The caller frees it. NULL if
 * there is none.
 */
static char *text_of(const murk_report_picture *p, const char *name)
{
    const size_t length = strlen(name);
    for (size_t at = 8; p->size - at >= 12;) {
        const size_t n = number_at(p->bytes + at);
        const unsigned char *data = p->bytes + at + 8;
        if (n > p->size - at - 12) {
            return NULL;
        }
        /* name, 0, not compressed, method, no language, 0, no translated name,
         * 0 */
        if (memcmp(p->bytes + at + 4, "iTXt", 4) == 0 && n >= length + 5 &&
            memcmp(data, name, length + 1) == 0 && data[length + 1] == 0 &&
            data[length + 3] == 0 && data[length + 4] == 0) {
            return strndup((const char *)data + length + 5, n - length - 5);
        }
        at += 12 + n;
    }
    return NULL;
}

/* ---- reading ---- */

/* Reads the size of a picture, and its bytes if these are at most max and there
 * is memory. False if it is no picture. */
static bool read_file(murk_report_picture *p, FILE *file, size_t max)
{
    unsigned char head[HEAD_SIZE];
    struct stat known;
    /* the file may change meanwhile: if fewer bytes than its size can be read,
     * it is no picture */
    if (fstat(fileno(file), &known) != 0 || !S_ISREG(known.st_mode) ||
        known.st_size < HEAD_SIZE ||
        fread(head, 1, HEAD_SIZE, file) != HEAD_SIZE || !read_head(p, head)) {
        return false;
    }
    p->size = (size_t)known.st_size;
    if (p->size > max) {
        return true;
    }
    p->bytes = malloc(p->size);
    if (!p->bytes) {
        return true;
    }
    memcpy(p->bytes, head, HEAD_SIZE);
    const size_t rest = p->size - HEAD_SIZE;
    return fread(p->bytes + HEAD_SIZE, 1, rest, file) == rest;
}

static murk_status add_png(murk_report_pictures *out, const char *folder,
                           const char *name, size_t *left, murk_error *err)
{
    murk_report_picture p = {0};
    char *path = murk_path_join(folder, name);
    if (!path) {
        return murk_no_memory(err, "", "for pictures");
    }
    /* only regular files: to open a pipe could wait for ever */
    FILE *file = murk_results_has(folder, name) ? murk_inputs_open(path) : NULL;
    const bool is_full = out->n == MURK_REPORT_PICTURES_MAX;
    if (file && is_full && read_file(&p, file, 0)) {
        ++out->more;
    } else if (file && !is_full && read_file(&p, file, *left)) {
        p.name = name;
        *left -= p.bytes ? p.size : 0;
        out->carried += p.bytes != NULL;
        out->picture[out->n++] = p;
    } else {
        free(p.bytes);
    }
    if (file) {
        fclose(file);
    }
    free(path);
    return MURK_OK;
}

murk_status murk_report_pictures_read(murk_report_pictures *out,
                                      const murk_results_in *results,
                                      murk_error *err)
{
    size_t left = MURK_REPORT_PICTURES_BYTES;
    murk_status status = MURK_OK;
    *out = (murk_report_pictures){.results = results};
    for (int i = 0; i < results->entries && !status; ++i) {
        const char *name = results->entry[i]->d_name;
        out->exr += murk_name_ends(name, ".exr");
        if (murk_name_ends(name, ".png")) {
            status = add_png(out, results->folder, name, &left, err);
        }
    }
    return status;
}

void murk_report_pictures_release(murk_report_pictures *pictures)
{
    for (size_t i = 0; i < pictures->n; ++i) {
        free(pictures->picture[i].bytes);
    }
    *pictures = (murk_report_pictures){0};
}

/* ---- writing ---- */

/* Writes ", WHAT TEXT" (", camera gate"), with the text that the picture has
 * under a name; nothing if it has none. */
static void write_said(FILE *to, const murk_report_picture *p, const char *what,
                       const char *name)
{
    char *text = text_of(p, name);
    if (text) {
        fprintf(to, ", %s ", what);
        murk_html_text(to, text);
    }
    free(text);
}

/* Writes ". Made by murk render ..." with the command in the picture, or "." if
 * it has none. */
static void write_command(FILE *to, const murk_report_picture *p)
{
    char *text = text_of(p, "murkCommand");
    fputs(text ? ". Made by <code>" : ".", to);
    if (text) {
        murk_html_text(to, text);
        fputs("</code>", to);
    }
    free(text);
}

static void write_picture(FILE *to, const murk_report_picture *p)
{
    fprintf(to,
            "<figure class=\"picture\">\n<img width=\"%u\" height=\"%u\" "
            "alt=\"Picture ",
            p->width, p->height);
    murk_html_text(to, p->name);
    write_said(to, p, "camera", "murkCamera");
    fputs("\" src=\"data:image/png;base64,", to);
    murk_html_base64(to, p->bytes, p->size);
    fputs("\">\n<figcaption>", to);
    murk_html_text(to, p->name);
    fprintf(to, ": %u x %u pixels", p->width, p->height);
    write_said(to, p, "of", "murkScene");
    write_said(to, p, "camera", "murkCamera");
    write_said(to, p, "from", "murkFrom");
    write_said(to, p, "by", "murkMethod");
    write_said(to, p, "samples a pixel:", "murkSamples");
    write_said(to, p, "photons:", "murkPhotons");
    write_said(to, p, "exposure", "murkExposure");
    write_said(to, p, "channel", "murkChannel");
    write_said(to, p, "colours", "murkColours");
    write_command(to, p);
    fputs("</figcaption>\n</figure>\n", to);
}

void murk_report_pictures_write(FILE *to, const murk_report_pictures *pictures)
{
    if (pictures->n + pictures->exr == 0) {
        return;
    }
    fputs("<section id=\"pictures\" data-title=\"Pictures\">\n"
          "<h2>Pictures</h2>\n",
          to);
    fputs("<div class=\"plans\">\n", to);
    for (size_t i = 0; i < pictures->n; ++i) {
        if (pictures->picture[i].bytes) {
            write_picture(to, &pictures->picture[i]);
        }
    }
    fputs("</div>\n", to);
    /* pictures that are too large, the number of further ones, EXR files */
    for (size_t i = 0; i < pictures->n; ++i) {
        const murk_report_picture *p = &pictures->picture[i];
        if (!p->bytes) {
            fputs("<p class=\"note\">", to);
            murk_html_text(to, p->name);
            fprintf(to,
                    " (%u x %u pixels, %.2f MB) is too large to be carried in "
                    "this page.</p>\n",
                    p->width, p->height, (double)p->size / 1e6);
        }
    }
    if (pictures->more > 0) {
        fprintf(to, "<p class=\"note\">And %zu more PNG file%s.</p>\n",
                pictures->more, pictures->more > 1 ? "s" : "");
    }
    const char *before =
        "<p class=\"note\">Radiances with their errors are in ";
    size_t named = 0;
    const murk_results_in *results = pictures->results;
    for (int i = 0; i < results->entries && named < NAMED_MAX; ++i) {
        if (murk_name_ends(results->entry[i]->d_name, ".exr")) {
            fputs(before, to);
            murk_html_text(to, results->entry[i]->d_name);
            before = ", ";
            ++named;
        }
    }
    if (pictures->exr > named) {
        fprintf(to, " and %zu more", pictures->exr - named);
    }
    fputs(pictures->exr > 0 ? ".</p>\n" : "", to);
    fputs("</section>\n", to);
}
