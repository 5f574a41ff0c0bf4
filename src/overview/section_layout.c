/* Lays out plan and sections on a sheet: chooses the part of the world, the
 * largest scale at which the views fit beside the legend, and the places of the
 * views. */
#include "overview/section_layout.h"

#include "world/section_cut.h"

/* The largest sheet if no size is asked for, in pixels: the width of a page at
 * 200 pixels an inch, and a height that most screens show at half size. */
#define SHEET_WIDTH  1600
#define SHEET_HEIGHT 1400

/* Sizes at unit 1 [pixels]. */
#define TEXT         15.0
#define MARGIN       16.0
#define MARGIN_RIGHT 48.0  /* half of the last number of an axis */
#define SCALE_LEFT   76.0  /* numbers to the left of a view */
#define SCALE_BELOW  44.0  /* numbers and the name of the axis below a view */
#define TITLE        74.0  /* of the sheet */
#define VIEW_TITLE   30.0  /* above each view */
#define COLUMN_MIN   330.0 /* room for the title of a view */
#define LEGEND_WIDTH 400.0
#define LEGEND_LINE  22.0

/* A domain that is more than so many times as large as everything in it along
 * an axis is not shown as a whole: things would be specks. */
#define DOMAIN_SHOWN_MAX 3.0
/* Space around what is shown, as a share of its size. */
#define AROUND_DOMAIN 0.02
#define AROUND_THINGS 0.1
/* Each side of what is shown is at least this share of the longest side, so
 * that a view of a flat scene has a height. */
#define FLATTEST 0.06

/* Steps of a bisection: 2^-50 of the largest scale. */
#define BISECTIONS 50

/* ---- the part of the world ---- */

static void choose_shown(murk_section_layout *l, const murk_section_request *r)
{
    const murk_box domain = r->stage->world.domain.box;
    const murk_candidates *c = r->candidates;
    const murk_box things = murk_stage_things_box(
        r->stage, c ? c->position : NULL, c ? c->usable : 0);
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
        double low = murk_component(domain.min, k);
        double high = murk_component(domain.max, k);
        const double from = murk_component(things.min, k);
        const double to = murk_component(things.max, k);
        double around = AROUND_DOMAIN * (high - low);
        if (to > from && high - low > DOMAIN_SHOWN_MAX * (to - from)) {
            around = AROUND_THINGS * (to - from);
            low = from;
            high = to;
            l->is_part = true;
        }
        /* The planes are always shown. */
        const double cut = murk_component(r->cut, k);
        low = fmin(low, cut) - around;
        high = fmax(high, cut) + around;
        longest = fmax(longest, high - low);
        murk_component_set(&l->shown.min, k, low);
        murk_component_set(&l->shown.max, k, high);
    }
    for (int k = 0; k < 3; ++k) {
        const double low = murk_component(l->shown.min, k);
        const double high = murk_component(l->shown.max, k);
        const double more = (FLATTEST * longest - (high - low)) / 2;
        murk_component_set(&l->shown.min, k, low - fmax(0, more));
        murk_component_set(&l->shown.max, k, high + fmax(0, more));
    }
}

/* ---- the sheet ---- */

/* Lengths of the sheet beside the views, and the space of the legend. */
typedef struct frame {
    double fixed[2]; /* to the right, down */
    double legend[2];
    double column_min;
    double size[3]; /* of what is shown [m] */
} frame;

/* The sheet's size at a scale in pixels per metre. */
static void size_at(const frame *f, double scale, double out[2])
{
    out[0] = f->fixed[0] + fmax(f->size[0] * scale, f->column_min) +
             fmax(f->size[1] * scale, f->legend[0]);
    out[1] = f->fixed[1] + fmax(f->size[1] * scale, f->legend[1]) +
             f->size[2] * scale;
}

static double largest_scale(const frame *f, const double sheet[2])
{
    double low = 0, high = sheet[0] / fmax(f->size[0], f->size[1]);
    for (int i = 0; i < BISECTIONS; ++i) {
        const double middle = (low + high) / 2;
        double size[2];
        size_at(f, middle, size);
        *(size[0] <= sheet[0] && size[1] <= sheet[1] ? &low : &high) = middle;
    }
    return low;
}

static void place_view(murk_section_layout *l, int i, double left, double top)
{
    murk_section_view *v = &l->view[i];
    v->left = floor(left);
    v->top = floor(top);
    v->width = floor((murk_component(l->shown.max, v->right) -
                      murk_component(l->shown.min, v->right)) *
                     v->scale);
    v->height = floor((murk_component(l->shown.max, v->up) -
                       murk_component(l->shown.min, v->up)) *
                      v->scale);
    v->width = fmax(1, v->width);
    v->height = fmax(1, v->height);
    v->low[0] = murk_component(l->shown.min, v->right);
    v->low[1] = murk_component(l->shown.min, v->up);
}

murk_section_layout murk_section_layout_make(const murk_section_request *r,
                                             size_t legend_lines)
{
    murk_section_layout l = {.width = r->pixels[0], .height = r->pixels[1]};
    const bool is_asked = l.width > 0;
    /* Letters grow with the sheet, and are still read on a small one. */
    const double width = is_asked ? (double)l.width : SHEET_WIDTH;
    const double height = is_asked ? (double)l.height : SHEET_HEIGHT;
    l.unit = fmax(0.7, fmin(width / SHEET_WIDTH, height / 1000));
    l.text = TEXT * l.unit;
    choose_shown(&l, r);
    /* The largest scale. */
    const murk_vec3 size = murk_sub(l.shown.max, l.shown.min);
    const double u = l.unit;
    const frame f = {
        .fixed = {u * (MARGIN + MARGIN_RIGHT + 2 * SCALE_LEFT),
                  u * (TITLE + 2 * (VIEW_TITLE + SCALE_BELOW) + MARGIN)},
        .column_min = u * COLUMN_MIN,
        .legend = {u * LEGEND_WIDTH, u * LEGEND_LINE * (double)legend_lines},
        .size = {size.x, size.y, size.z}};
    const double sheet[2] = {width, height};
    const double scale = largest_scale(&f, sheet);
    double used[2];
    size_at(&f, scale, used);
    l.width = is_asked ? l.width : (size_t)ceil(used[0]);
    l.height = is_asked ? l.height : (size_t)ceil(used[1]);
    /* The views. */
    const double left = u * (MARGIN + SCALE_LEFT),
                 top = u * (TITLE + VIEW_TITLE);
    const double row = fmax(size.y * scale, f.legend[1]);
    const double right =
        left + fmax(size.x * scale, f.column_min) + u * SCALE_LEFT;
    const double below = top + row + u * (SCALE_BELOW + VIEW_TITLE);
    const int right_up_along[MURK_SECTIONS][3] = {
        {0, 1, 2}, {0, 2, 1}, {1, 2, 0}};
    const double sign[MURK_SECTIONS] = {-1, 1, -1};
    for (int i = 0; i < MURK_SECTIONS; ++i) {
        murk_section_view *v = &l.view[i];
        v->right = right_up_along[i][0];
        v->up = right_up_along[i][1];
        v->along = right_up_along[i][2];
        v->sign = sign[i];
        v->cut_m = murk_component(r->cut, v->along);
        v->scale = scale;
    }
    place_view(&l, MURK_SECTION_PLAN, left, top + row - size.y * scale);
    place_view(&l, MURK_SECTION_FRONT, left, below);
    place_view(&l, MURK_SECTION_SIDE, right, below);
    l.legend[0] = right;
    l.legend[1] = u * TITLE;
    return l;
}
