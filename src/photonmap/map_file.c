/* Writes and reads light.murk (photonmap/map_file.h). Everything that is read
 * is checked before it is used: header, table and each section have checksums,
 * and sizes must add up to the size of the file. */
#include "photonmap/map_file.h"

#include "base/file.h"
#include "base/ranks.h"
#include "base/scratch_file.h"
#include "photonmap/photon.h"

#include <assert.h>
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The structs below have the layout of the file on all supported machines. */
_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
               "light.murk is little-endian");

/* The byte order mark as read from a little-endian file and from a big-endian
 * one. */
#define BYTE_ORDER_MARK    0x01020304u
#define BYTE_ORDER_SWAPPED 0x04030201u

/* The magic contains a byte above 127, a carriage return and a line feed, so
 * that a transfer in text mode, which changes them, is noticed, and 0x1a, the
 * end-of-file character of DOS. */
static const unsigned char magic[8] = {0x8d, 'm',  'u',  'r',
                                       'k',  '\r', '\n', 0x1a};

typedef struct header {
    unsigned char magic[8];
    uint32_t version, byte_order, record_size, n_sections;
    uint64_t file_size;
    uint64_t table_checksum[2];
    uint64_t header_checksum[2]; /* of the preceding members */
} header;

typedef struct entry {
    char name[16];
    uint64_t size, zero;
    uint64_t checksum[2];
} entry;

_Static_assert(sizeof(header) == 64 && sizeof(entry) == 48,
               "the layout of light.murk");

/* The member `bytes` is not const, so the pointer is
 * copied by memcpy(); the writer only reads the bytes. */
murk_section murk_section_of(const char *name, const void *bytes, size_t size)
{
    murk_section section = {.size = size};
    snprintf(section.name, sizeof section.name, "%s", name);
    memcpy(&section.bytes, &bytes, sizeof bytes);
    return section;
}

static bool is_name(const char name[16])
{
    size_t length = 0;
    while (length < 16 && name[length] > ' ' && name[length] <= '~') {
        ++length;
    }
    if (length == 0) {
        return false;
    }
    while (length < 16 && name[length] == '\0') {
        ++length;
    }
    return length == 16 && name[15] == '\0';
}

static bool is_checked(const void *bytes, size_t size,
                       const uint64_t checksum[2])
{
    uint64_t now[2];
    murk_checksum(bytes, size, now);
    return now[0] == checksum[0] && now[1] == checksum[1];
}

/* ---- writing ---- */

murk_status murk_map_file_write(const char *path, const murk_section *sections,
                                size_t n, murk_error *err)
{
    assert(path && (sections || n == 0) && n <= MURK_MAP_FILE_SECTIONS);
    entry table[MURK_MAP_FILE_SECTIONS] = {0};
    header head = {.version = MURK_MAP_FILE_VERSION,
                   .byte_order = BYTE_ORDER_MARK,
                   .record_size = sizeof(murk_photon),
                   .n_sections = (uint32_t)n,
                   .file_size = sizeof head + n * sizeof *table};
    memcpy(head.magic, magic, sizeof magic);
    /* Fill the table, then the checksums. */
    for (size_t i = 0; i < n; ++i) {
        const size_t length = strnlen(sections[i].name, 15);
        memcpy(table[i].name, sections[i].name, length);
        assert(is_name(table[i].name) &&
               !murk_map_file_find(sections, i, table[i].name));
        table[i].size = sections[i].size;
        murk_checksum(sections[i].bytes, sections[i].size, table[i].checksum);
        head.file_size += sections[i].size;
    }
    murk_checksum(table, n * sizeof *table, head.table_checksum);
    murk_checksum(&head, offsetof(header, header_checksum),
                  head.header_checksum);

    /* Write everything; errors are reported by the commit. */
    murk_file *file = NULL;
    murk_status status = murk_file_create(&file, path, err);
    if (status) {
        return status;
    }
    FILE *stream = murk_file_stream(file); /* murk_file_commit() asks
                                            * ferror() */
    (void)fwrite(&head, sizeof head, 1, stream);
    (void)fwrite(table, sizeof *table, n, stream);
    for (size_t i = 0; i < n && !ferror(stream); ++i) {
        if (sections[i].size > 0) {
            (void)fwrite(sections[i].bytes, 1, sections[i].size, stream);
        }
    }
    return murk_file_commit(&file, err);
}

/* ---- reading ---- */

static murk_status cut_short(const char *path, uint64_t size, uint64_t wanted,
                             murk_error *err)
{
    return murk_fail(err, MURK_BAD_FILE, path,
                     "cut short: %llu bytes, must be %llu",
                     (unsigned long long)size, (unsigned long long)wanted);
}

static murk_status read_header(header *head, int fd, uint64_t size,
                               const char *path, murk_error *err)
{
    *head = (header){0};
    const size_t there = size < sizeof *head ? (size_t)size : sizeof *head;
    murk_status status = murk_file_read_bytes(fd, head, there, path, err);
    if (status) {
        return status;
    }
    /* Checks in the order in which they give the most helpful message. */
    if (there < sizeof magic || memcmp(head->magic, magic, sizeof magic) != 0) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "not a light.murk file or a part of a run%s",
                         size == 0 ? ": it is empty" : "");
    }
    if (there < sizeof *head) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "cut short: %zu bytes, must be at least %zu", there,
                         sizeof *head);
    }
    if (head->byte_order == BYTE_ORDER_SWAPPED) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "written in the other byte order, must be "
                         "little-endian");
    }
    if (head->version != MURK_MAP_FILE_VERSION) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "version %lu, this murk reads %d",
                         (unsigned long)head->version, MURK_MAP_FILE_VERSION);
    }
    if (!is_checked(head, offsetof(header, header_checksum),
                    head->header_checksum) ||
        head->byte_order != BYTE_ORDER_MARK) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "changed bytes in the header");
    }
    if (head->record_size != sizeof(murk_photon)) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "records of %lu bytes, this murk reads %zu",
                         (unsigned long)head->record_size, sizeof(murk_photon));
    }
    if (head->n_sections > MURK_MAP_FILE_SECTIONS) {
        return murk_fail(
            err, MURK_BAD_FILE, path, "%lu sections, must be at most %d",
            (unsigned long)head->n_sections, MURK_MAP_FILE_SECTIONS);
    }
    if (size < head->file_size) {
        return cut_short(path, size, head->file_size, err);
    }
    if (size > head->file_size) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "%llu bytes, must be %llu: something stands behind "
                         "its end",
                         (unsigned long long)size,
                         (unsigned long long)head->file_size);
    }
    return MURK_OK;
}

/* Reads the table of sections. Fails if the checksum is wrong, if a name is
 * invalid or given twice, if a member `zero` is not 0, or if the sizes do not
 * add up to the size of the file. */
static murk_status read_table(entry table[MURK_MAP_FILE_SECTIONS], int fd,
                              const header *head, const char *path,
                              murk_error *err)
{
    const size_t n = head->n_sections;
    const uint64_t start = sizeof *head + n * sizeof *table;
    if (head->file_size < start) {
        return cut_short(path, head->file_size, start, err);
    }
    murk_status status =
        murk_file_read_bytes(fd, table, n * sizeof *table, path, err);
    if (status) {
        return status;
    }
    /* Names must be valid and different, and sizes must add up to the file. */
    bool is_good = is_checked(table, n * sizeof *table, head->table_checksum);
    uint64_t left = head->file_size - start;
    for (size_t i = 0; is_good && i < n; ++i) {
        is_good = is_name(table[i].name) && table[i].size <= left &&
                  table[i].zero == 0;
        for (size_t j = 0; is_good && j < i; ++j) {
            is_good = memcmp(table[i].name, table[j].name, 16) != 0;
        }
        left -= table[i].size;
    }
    if (!is_good || left != 0) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "changed bytes in the table of sections");
    }
    return MURK_OK;
}

/* The sections to read: one name, or all but some. */
typedef struct selection {
    const char *only;            /* NULL: not one name */
    const char *const *left_out; /* ends with NULL; NULL: none */
} selection;

static bool is_wanted(const entry *section, const selection *s)
{
    const size_t size = sizeof section->name;
    bool is_left_out = false;
    for (size_t i = 0; s->left_out && s->left_out[i]; ++i) {
        is_left_out |= strncmp(section->name, s->left_out[i], size) == 0;
    }
    return !is_left_out &&
           (!s->only || strncmp(section->name, s->only, size) == 0);
}

/* Sections from this size on may lie in a scratch file [bytes]: smaller ones
 * are not worth a file (a choice). */
#define LARGE ((size_t)1 << 16)

/* Refuses a section for which neither memory nor disk suffice. */
static murk_status check_disk(size_t size, const char *path, murk_error *err)
{
    const double have = murk_scratch_free_bytes();
    return (double)size <= have
               ? MURK_OK
               : murk_fail(err, MURK_NO_MEMORY, path,
                           "needs %.4g GB, more than this machine has free "
                           "memory; and %s has %.4g GB free for a scratch file",
                           (double)size / 1e9, murk_scratch_folder(),
                           have / 1e9);
}

/* The memory of a section. *memory_left is what blocks may still take. */
static murk_status take_memory(murk_section *section, double *memory_left,
                               const char *path, murk_error *err)
{
    murk_status status = MURK_OK;
    murk_block *block = &section->block;
    const size_t size = section->size;
    const bool is_large = size >= LARGE;
    block->is_for_ranks = is_large && murk_ranks_on_machine().count > 1;
    /* In a scratch file, where ranks share it, or on the heap. */
    if (is_large && (double)size > *memory_left) {
        status = check_disk(size, path, err);
        if (!status) {
            status = murk_block_resize(block, size, 0, err);
        }
    } else if (block->is_for_ranks) {
        status = murk_block_resize(block, size, INFINITY, err);
        *memory_left -= (double)size;
    } else {
        const size_t padded = (size / 64 + 1) * 64;
        *block = murk_block_of(aligned_alloc(64, padded), padded);
        *memory_left -= (double)padded;
    }
    section->bytes = section->block.bytes;
    return status || section->bytes
               ? status
               : murk_no_memory(err, path, "for section %s, %.4g MB",
                                section->name, (double)section->size / 1e6);
}

static murk_status read_section(murk_section *section, const entry *from,
                                int fd, double *memory_left, const char *path,
                                murk_error *err)
{
    const size_t size = (size_t)from->size;
    memcpy(section->name, from->name, sizeof section->name);
    section->size = size;
    murk_status status = take_memory(section, memory_left, path, err);
    if (!status) {
        status = murk_file_read_bytes(fd, section->bytes, size, path, err);
    }
    if (!status && !is_checked(section->bytes, size, from->checksum)) {
        status = murk_fail(err, MURK_BAD_FILE, path,
                           "changed bytes in section %s", from->name);
    }
    return status;
}

/* Reads the selected sections; *n is their number. */
static murk_status read_sections(murk_section **out, size_t *n,
                                 const char *path, const selection *which,
                                 murk_error *err)
{
    assert(out && n && path);
    size_t taken = 0;
    int fd = -1;
    uint64_t size = 0;
    header head = {0};
    entry table[MURK_MAP_FILE_SECTIONS];
    murk_section *sections = NULL;
    murk_status status = murk_file_open(&fd, &size, path, err);
    if (status || (status = read_header(&head, fd, size, path, err)) ||
        (status = read_table(table, fd, &head, path, err))) {
        goto done;
    }
    /* All ranks of a machine may read the file. */
    double memory_left =
        murk_block_memory_bytes() / murk_ranks_on_machine().count;
    /* Read or skip one section after the other. */
    sections = calloc(head.n_sections + 1, sizeof *sections);
    if (!sections) {
        status = murk_no_memory(err, path, "to read it");
        goto done;
    }
    for (size_t i = 0; i < head.n_sections; ++i) {
        if (!is_wanted(&table[i], which)) {
            if (lseek(fd, (off_t)table[i].size, SEEK_CUR) < 0) {
                status = murk_fail(err, MURK_BAD_FILE, path, "cannot read: %s",
                                   strerror(errno));
                goto done;
            }
            continue;
        }
        status = read_section(&sections[taken++], &table[i], fd, &memory_left,
                              path, err);
        if (status) {
            goto done;
        }
    }
    *out = sections;
    *n = taken;
    sections = NULL;
done:
    if (fd >= 0) {
        close(fd);
    }
    murk_map_file_release(sections, head.n_sections);
    return status;
}

murk_status murk_map_file_read(murk_section **out, size_t *n, const char *path,
                               murk_error *err)
{
    const selection all = {NULL, NULL};
    return read_sections(out, n, path, &all, err);
}

murk_status murk_map_file_read_without(murk_section **out, size_t *n,
                                       const char *path,
                                       const char *const *left_out,
                                       murk_error *err)
{
    const selection some = {NULL, left_out};
    return read_sections(out, n, path, &some, err);
}

murk_status murk_map_file_read_one(murk_section **out, const char *path,
                                   const char *name, murk_error *err)
{
    size_t n = 0;
    murk_section *sections = NULL;
    const selection one = {name, NULL};
    const murk_status status = read_sections(&sections, &n, path, &one, err);
    if (status) {
        return status;
    }
    if (n == 0) {
        murk_map_file_release(sections, n);
        return murk_fail(err, MURK_BAD_FILE, path,
                         "section %s is missing or of the wrong size", name);
    }
    *out = sections;
    return MURK_OK;
}

void murk_map_file_release(murk_section *sections, size_t n)
{
    if (sections) {
        for (size_t i = 0; i < n; ++i) {
            murk_block_release(&sections[i].block);
        }
        free(sections);
    }
}

const murk_section *murk_map_file_find(const murk_section *sections, size_t n,
                                       const char *name)
{
    for (size_t i = 0; i < n; ++i) {
        if (strncmp(sections[i].name, name, sizeof sections[i].name) == 0) {
            return &sections[i];
        }
    }
    return NULL;
}
