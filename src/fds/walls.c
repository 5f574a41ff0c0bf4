/* Finds the surfaces of an FDS run (fds/walls.h): marks the solid cells of all
 * meshes, then looks at each plane of faces of each mesh. */
#include "fds/walls.h"

#include "base/interval.h"

#include <stdlib.h>
#include <string.h>

#define GAS     0 /* no obstruction */
#define OUTSIDE UINT32_MAX
#define NO_WALL 0 /* light passes a face */

/* A point this share of a cell beyond a face lies in the cell beyond. */
#define BEYOND 1e-3

/* Areas of faces that are equal but for the rounding of grid lines. */
#define SAME_AREA 1e-3

typedef struct finder {
    const murk_fds_run *run;
    double time_s;
    uint32_t **owner;      /* [meshes][cells, x fastest]: the number of the
                            * obstruction in a cell, from 1 on, or GAS */
    unsigned char **state; /* [meshes]: states_of() */
    murk_fds_walls *out;
    size_t capacity;
} finder;

/* ---- items at a time ---- */

/* Of each item: not mentioned by an event so far, or there or away. */
enum { NOT_SEEN, THERE, AWAY };

/* The states of all obstructions of a mesh, then of all vents; NULL without
 * memory. An item that appears first was not there before. */
static unsigned char *states_of(const finder *f, size_t number)
{
    const murk_fds_mesh *mesh = &f->run->mesh[number];
    unsigned char *state = calloc(mesh->obstructions + mesh->vents + 1, 1);
    for (size_t i = 0; state && i < f->run->events; ++i) {
        const murk_fds_event *event = &f->run->event[i];
        if (event->mesh != number) {
            continue;
        }
        unsigned char *of =
            &state[(event->is_vent ? mesh->obstructions : 0) + event->item];
        if (event->time_s <= f->time_s) {
            *of = event->is_there ? THERE : AWAY;
        } else if (*of == NOT_SEEN) {
            *of = event->is_there ? AWAY : THERE;
        }
    }
    return state;
}

static bool is_there(const finder *f, size_t mesh, size_t item, bool is_vent)
{
    const size_t first = is_vent ? f->run->mesh[mesh].obstructions : 0;
    return f->state[mesh][first + item] != AWAY;
}

static size_t cell_at(const murk_fds_mesh *mesh, const size_t cell[3])
{
    return (cell[2] * mesh->cells[1] + cell[1]) * mesh->cells[0] + cell[0];
}

static void fill_cells(finder *f, size_t number, uint32_t item)
{
    const murk_fds_mesh *mesh = &f->run->mesh[number];
    const murk_fds_nodes *n = &mesh->obstruction[item].nodes;
    size_t cell[3];
    for (cell[2] = (size_t)n->low[2]; cell[2] < (size_t)n->high[2]; ++cell[2]) {
        for (cell[1] = (size_t)n->low[1]; cell[1] < (size_t)n->high[1];
             ++cell[1]) {
            for (cell[0] = (size_t)n->low[0]; cell[0] < (size_t)n->high[0];
                 ++cell[0]) {
                f->owner[number][cell_at(mesh, cell)] = item + 1;
            }
        }
    }
}

static bool mark_cells(finder *f)
{
    bool has_memory = true;
    for (size_t i = 0; i < f->run->meshes && has_memory; ++i) {
        const murk_fds_mesh *mesh = &f->run->mesh[i];
        f->owner[i] = calloc(mesh->cells[0] * mesh->cells[1] * mesh->cells[2],
                             sizeof **f->owner);
        f->state[i] = states_of(f, i);
        has_memory = f->owner[i] && f->state[i];
        for (size_t k = 0; k < mesh->obstructions && has_memory; ++k) {
            if (is_there(f, i, k, false)) {
                fill_cells(f, i, (uint32_t)k);
            }
        }
    }
    return has_memory;
}

/* What is at a place: GAS, OUTSIDE of all meshes, or another number if a cell
 * there is solid; and the cell, if there is one. */
typedef struct place_state {
    uint32_t owner;
    size_t mesh, cell[3];
} place_state;

static place_state state_at(const finder *f, const double p[3])
{
    for (size_t i = 0; i < f->run->meshes; ++i) {
        const murk_fds_mesh *mesh = &f->run->mesh[i];
        place_state out = {.mesh = i};
        bool holds = true;
        for (int axis = 0; axis < 3; ++axis) {
            const double *edge = mesh->edge[axis];
            const size_t n = mesh->cells[axis];
            holds = holds && p[axis] >= edge[0] && p[axis] < edge[n];
            out.cell[axis] = murk_interval_of(edge, 1, n + 1, p[axis]);
        }
        if (holds) {
            out.owner = f->owner[i][cell_at(mesh, out.cell)];
            return out;
        }
    }
    return (place_state){.owner = OUTSIDE};
}

/* The area of a cell of a mesh across an axis. */
static double face_area(const murk_fds_mesh *mesh, const size_t cell[3],
                        int axis)
{
    double area = 1;
    for (int i = 0; i < 3; ++i) {
        const double *edge = &mesh->edge[i][cell[i]];
        area *= i == axis ? 1 : edge[1] - edge[0];
    }
    return area;
}

/* ---- one plane of faces ---- */

/* What a face is: between cells without obstruction, an outer wall beside such
 * a cell, or at a solid cell. */
typedef enum face_kind { FREE, OUTER, AT_SOLID } face_kind;

/* The faces of a mesh at the grid line `at` of the axis; u and v are the other
 * two axes. */
typedef struct plane {
    size_t mesh;
    int axis, u, v;
    size_t at;
    uint32_t *face; /* [cells along v][cells along u]: the surface, from 1 on,
                     * or NO_WALL */
    unsigned char *kind; /* the same: a face_kind */
} plane;

/* The state of the cell before (side 0) or behind (1) a face. */
static place_state state_beside(const finder *f, const plane *p,
                                const size_t at[3], int side)
{
    const murk_fds_mesh *mesh = &f->run->mesh[p->mesh];
    place_state out = {.mesh = p->mesh, .cell = {at[0], at[1], at[2]}};
    if (side == 0 ? at[p->axis] > 0 : at[p->axis] < mesh->cells[p->axis]) {
        out.cell[p->axis] -= side == 0;
        out.owner = f->owner[p->mesh][cell_at(mesh, out.cell)];
        return out;
    }
    /* Beyond the mesh: a point behind the middle of the face. */
    double point[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double *edge = mesh->edge[axis];
        point[axis] = axis == p->axis
                          ? edge[at[axis]]
                          : (edge[at[axis]] + edge[at[axis] + 1]) / 2;
    }
    const double *edge = mesh->edge[p->axis];
    const size_t n = mesh->cells[p->axis];
    point[p->axis] += side == 0 ? -BEYOND * (edge[1] - edge[0])
                                : BEYOND * (edge[n] - edge[n - 1]);
    return state_at(f, point);
}

/* True if another mesh draws a face at the border of two meshes: the one of the
 * smaller faces, or, of equal ones, that of the solid cell. */
static bool is_of_other(const finder *f, const plane *p, const size_t at[3],
                        const place_state *before, const place_state *behind)
{
    const bool is_first = at[p->axis] == 0;
    const place_state *own = is_first ? behind : before,
                      *other = is_first ? before : behind;
    if (other->owner == OUTSIDE || other->mesh == p->mesh) {
        return false;
    }
    const double mine = face_area(&f->run->mesh[p->mesh], own->cell, p->axis),
                 theirs = face_area(&f->run->mesh[other->mesh], other->cell,
                                    p->axis);
    return theirs < mine * (1 - SAME_AREA) ||
           (theirs <= mine * (1 + SAME_AREA) && own->owner == GAS);
}

/* The surface of a face, from 1 on; NO_WALL if light passes. */
static uint32_t face_at(const finder *f, const plane *p, const size_t at[3],
                        unsigned char *kind)
{
    const murk_fds_mesh *mesh = &f->run->mesh[p->mesh];
    const size_t n = mesh->cells[p->axis];
    const place_state before = state_beside(f, p, at, 0),
                      behind = state_beside(f, p, at, 1);
    const bool is_outer =
        (at[p->axis] == 0 && before.owner == OUTSIDE && behind.owner == GAS) ||
        (at[p->axis] == n && behind.owner == OUTSIDE && before.owner == GAS);
    *kind = is_outer                                     ? OUTER
            : before.owner == GAS && behind.owner == GAS ? FREE
                                                         : AT_SOLID;
    if (is_outer) {
        return 1 + f->run->usual_surface; /* vents may give another one */
    }
    const bool is_before = before.owner != GAS && behind.owner == GAS;
    const bool is_behind = behind.owner != GAS && before.owner == GAS;
    if ((!is_before && !is_behind) || is_of_other(f, p, at, &before, &behind)) {
        return NO_WALL;
    }
    /* The face of the obstruction that makes the cell solid. */
    const place_state *solid = is_before ? &before : &behind;
    if (solid->owner == OUTSIDE) {
        return NO_WALL;
    }
    return 1 + f->run->mesh[solid->mesh]
                   .obstruction[solid->owner - 1]
                   .surface[2 * p->axis + (is_before ? 1 : 0)];
}

/* True if an item without thickness lies in the plane; then low[] and high[]
 * are its cells along u and v. */
static bool covers(const plane *p, const murk_fds_nodes *nodes, size_t low[2],
                   size_t high[2])
{
    low[0] = (size_t)nodes->low[p->u];
    low[1] = (size_t)nodes->low[p->v];
    high[0] = (size_t)nodes->high[p->u];
    high[1] = (size_t)nodes->high[p->v];
    return nodes->low[p->axis] == nodes->high[p->axis] &&
           (size_t)nodes->low[p->axis] == p->at;
}

/* True if the plane is the last of its mesh and another mesh, which begins
 * behind the cell (u, v), has a plate in its own first plane: FDS lists a plate
 * on the border of two meshes in both. */
static bool has_next_plate(const finder *f, const plane *p, size_t u, size_t v)
{
    const murk_fds_mesh *mesh = &f->run->mesh[p->mesh];
    if (p->at < mesh->cells[p->axis]) {
        return false;
    }
    size_t at[3];
    at[p->axis] = p->at;
    at[p->u] = u;
    at[p->v] = v;
    const place_state behind = state_beside(f, p, at, 1);
    if (behind.owner == OUTSIDE) {
        return false;
    }
    /* Plates of the other mesh that cover the cell. */
    const murk_fds_mesh *next = &f->run->mesh[behind.mesh];
    bool found = false;
    for (size_t i = 0; i < next->obstructions && !found; ++i) {
        const murk_fds_nodes *n = &next->obstruction[i].nodes;
        found = is_there(f, behind.mesh, i, false) && n->high[p->axis] == 0 &&
                (size_t)n->low[p->u] <= behind.cell[p->u] &&
                (size_t)n->high[p->u] > behind.cell[p->u] &&
                (size_t)n->low[p->v] <= behind.cell[p->v] &&
                (size_t)n->high[p->v] > behind.cell[p->v];
    }
    return found;
}

/* True if light passes an outer wall of this surface. */
static bool is_passed(const murk_fds_run *run, uint32_t surface)
{
    const char *name = run->surface[surface];
    return murk_fds_is_open(run, surface) || strcmp(name, "MIRROR") == 0 ||
           strncmp(name, "PERIODIC", 8) == 0;
}

/* Adds plates, and gives faces that vents cover their surfaces. */
static void cover(const finder *f, const plane *p)
{
    const murk_fds_mesh *mesh = &f->run->mesh[p->mesh];
    const size_t row = mesh->cells[p->u];
    size_t low[2], high[2];
    /* Plates. */
    for (size_t i = 0; i < mesh->obstructions; ++i) {
        const murk_fds_item *item = &mesh->obstruction[i];
        if (!covers(p, &item->nodes, low, high) ||
            !is_there(f, p->mesh, i, false)) {
            continue;
        }
        for (size_t v = low[1]; v < high[1]; ++v) {
            for (size_t u = low[0]; u < high[0]; ++u) {
                uint32_t *face = &p->face[v * row + u];
                const bool is_seen = p->kind[v * row + u] != AT_SOLID &&
                                     !has_next_plate(f, p, u, v);
                *face = is_seen ? 1 + item->surface[2 * p->axis + 1] : *face;
                p->kind[v * row + u] = AT_SOLID;
            }
        }
    }
    /* Vents. */
    for (size_t i = 0; i < mesh->vents; ++i) {
        const murk_fds_item *item = &mesh->vent[i];
        if (!covers(p, &item->nodes, low, high) ||
            !is_there(f, p->mesh, i, true)) {
            continue;
        }
        for (size_t v = low[1]; v < high[1]; ++v) {
            for (size_t u = low[0]; u < high[0]; ++u) {
                uint32_t *face = &p->face[v * row + u];
                const bool passes = p->kind[v * row + u] == OUTER &&
                                    is_passed(f->run, item->surface[0]);
                *face =
                    passes || *face == NO_WALL ? NO_WALL : 1 + item->surface[0];
            }
        }
    }
}

/* ---- rectangles ---- */

static bool add_wall(finder *f, const plane *p, const size_t low[2],
                     const size_t high[2], uint32_t surface)
{
    murk_fds_walls *out = f->out;
    if (out->n == f->capacity) {
        const size_t more = f->capacity ? 2 * f->capacity : 256;
        murk_fds_wall *larger = realloc(out->wall, more * sizeof *larger);
        if (!larger) {
            return false;
        }
        out->wall = larger;
        f->capacity = more;
    }
    const murk_fds_mesh *mesh = &f->run->mesh[p->mesh];
    murk_fds_wall *wall = &out->wall[out->n++];
    wall->surface = surface;
    for (int corner = 0; corner < 4; ++corner) {
        const bool is_u = corner == 1 || corner == 2, is_v = corner >= 2;
        double *at = wall->corner_m[corner];
        at[p->axis] = mesh->edge[p->axis][p->at];
        at[p->u] = mesh->edge[p->u][is_u ? high[0] : low[0]];
        at[p->v] = mesh->edge[p->v][is_v ? high[1] : low[1]];
    }
    return true;
}

/* Joins faces of one surface to rectangles: as long as possible along u, then
 * along v. The faces become NO_WALL. */
static bool join_faces(finder *f, const plane *p)
{
    const murk_fds_mesh *mesh = &f->run->mesh[p->mesh];
    const size_t nu = mesh->cells[p->u], nv = mesh->cells[p->v];
    bool has_memory = true;
    for (size_t first = 0; first < nu * nv && has_memory; ++first) {
        const uint32_t surface = p->face[first];
        if (surface == NO_WALL) {
            continue;
        }
        const size_t low[2] = {first % nu, first / nu};
        size_t high[2] = {low[0], low[1]};
        /* Along u, then along v. */
        while (high[0] < nu && p->face[low[1] * nu + high[0]] == surface) {
            ++high[0];
        }
        bool is_same = true;
        while (high[1] < nv && is_same) {
            for (size_t u = low[0]; u < high[0] && is_same; ++u) {
                is_same = p->face[high[1] * nu + u] == surface;
            }
            high[1] += is_same;
        }
        for (size_t v = low[1]; v < high[1]; ++v) {
            for (size_t u = low[0]; u < high[0]; ++u) {
                p->face[v * nu + u] = NO_WALL;
            }
        }
        has_memory = add_wall(f, p, low, high, surface - 1);
    }
    return has_memory;
}

/* Finds the walls of a mesh across an axis. */
static bool find_across(finder *f, size_t number, int axis)
{
    const murk_fds_mesh *mesh = &f->run->mesh[number];
    plane p = {
        .mesh = number, .axis = axis, .u = (axis + 1) % 3, .v = (axis + 2) % 3};
    const size_t nu = mesh->cells[p.u], nv = mesh->cells[p.v];
    p.face = calloc(nu * nv, sizeof *p.face);
    p.kind = calloc(nu * nv, sizeof *p.kind);
    bool has_memory = p.face && p.kind;
    for (p.at = 0; p.at <= mesh->cells[axis] && has_memory; ++p.at) {
        /* The faces of the plane one by one, then what covers them. */
        for (size_t i = 0; i < nu * nv; ++i) {
            size_t at[3];
            at[axis] = p.at;
            at[p.u] = i % nu;
            at[p.v] = i / nu;
            p.face[i] = face_at(f, &p, at, &p.kind[i]);
        }
        cover(f, &p);
        has_memory = join_faces(f, &p);
    }
    free(p.face);
    free(p.kind);
    return has_memory;
}

bool murk_fds_walls_find(murk_fds_walls *out, const murk_fds_run *run,
                         double time_s)
{
    finder f = {.run = run,
                .time_s = time_s,
                .owner = calloc(run->meshes, sizeof *f.owner),
                .state = calloc(run->meshes, sizeof *f.state),
                .out = out};
    *out = (murk_fds_walls){0};
    /* Solid cells, then the walls of each mesh across each axis. */
    bool has_memory = f.owner && f.state && mark_cells(&f);
    for (size_t i = 0; i < run->meshes && has_memory; ++i) {
        for (int axis = 0; axis < 3 && has_memory; ++axis) {
            has_memory = find_across(&f, i, axis);
        }
    }
    for (size_t i = 0; f.owner && f.state && i < run->meshes; ++i) {
        free(f.owner[i]);
        free(f.state[i]);
    }
    free(f.owner);
    free(f.state);
    if (!has_memory) {
        free(out->wall);
        *out = (murk_fds_walls){0};
    }
    return has_memory;
}
