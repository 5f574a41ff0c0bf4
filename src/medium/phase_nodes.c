/* Construction and use of phase tables (medium/phase_table.h): density
 * linear in s = 1 - cos(angle) between nodes. Nodes are placed by adaptive
 * halving; sampling uses a guide table (Chen and Asau, AIIE Trans. 6 (1974)
 * 163, doi:10.1080/05695557408974949) and the root of a quadratic. */
#include "medium/phase_nodes.h"

#include "base/interval.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

/* Solid angle per s: d(omega) = 2 pi ds. */
#define TWO_PI 6.283185307179586

/* 1 - cos of the smallest angle whose cosine is not rounded to 1. */
#define S_MIN 0x1p-54

static void add(murk_phase_nodes *nodes, murk_phase_node node)
{
    if (nodes->is_full) {
        return;
    }
    if (nodes->n == nodes->capacity) {
        const size_t capacity = nodes->capacity ? 2 * nodes->capacity : 1024;
        murk_phase_node *more =
            capacity > MURK_PHASE_NODES_MAX
                ? NULL
                : realloc(nodes->node, capacity * sizeof *more);
        if (!more) {
            nodes->is_full = true;
            return;
        }
        nodes->node = more;
        nodes->capacity = capacity;
    }
    nodes->node[nodes->n++] = node;
}

void murk_phase_nodes_begin(murk_phase_nodes *nodes, double s, double density,
                            double power)
{
    assert(nodes->n == 0 && s >= 0 && s < 2 && power > -1);
    nodes->power = power;
    add(nodes,
        (murk_phase_node){TWO_PI * density * s / (power + 1), s, density});
}

void murk_phase_nodes_line(murk_phase_nodes *nodes, double s, double density)
{
    if (nodes->is_full) {
        return;
    }
    const murk_phase_node last = nodes->node[nodes->n - 1];
    if (s > last.s) {
        const double share =
            TWO_PI * .5 * (last.density + density) * (s - last.s);
        add(nodes, (murk_phase_node){last.below + share, s, density});
    }
}

/* True if a straight line between two nodes is within MURK_PHASE_TOLERANCE of
 * the law at three points. */
static bool is_near(murk_phase_node from, murk_phase_node to,
                    double (*law)(const void *context, double s),
                    const void *context)
{
    for (int i = 1; i < 4; ++i) {
        const double s = from.s + .25 * i * (to.s - from.s);
        const double line =
            from.density + .25 * i * (to.density - from.density);
        const double want = law(context, s);
        if (!(fabs(line - want) <= MURK_PHASE_TOLERANCE * want)) {
            return false;
        }
    }
    return true;
}

/* Halves the interval until a straight line is close enough on each part. The
 * ends of the parts still to come are on a stack, the nearest on top. A part
 * that ends at more than four times the s at which it begins is always halved,
 * in log s (in s if it begins at 0). */
void murk_phase_nodes_law(murk_phase_nodes *nodes, double s,
                          double (*law)(const void *context, double s),
                          const void *context)
{
    /* Depth of the stack: 6 halvings in log s and 53 in s reach the last digit
     * of s. */
    enum { DEPTH = 80 };
    murk_phase_node waiting[DEPTH];
    size_t n = 0;
    waiting[n++] = (murk_phase_node){0, s, law(context, s)};
    while (n > 0 && !nodes->is_full) {
        const murk_phase_node from = nodes->node[nodes->n - 1];
        const murk_phase_node to = waiting[n - 1];
        const double middle = to.s > 4 * from.s && from.s > 0
                                  ? sqrt(from.s * to.s)
                                  : .5 * (from.s + to.s);
        if (n == DEPTH || !(middle > from.s && middle < to.s) ||
            (to.s <= 4 * from.s && is_near(from, to, law, context))) {
            murk_phase_nodes_line(nodes, to.s, to.density);
            --n;
        } else {
            waiting[n++] = (murk_phase_node){0, middle, law(context, middle)};
        }
    }
}

double murk_phase_nodes_integral(const murk_phase_nodes *nodes)
{
    return nodes->n > 0 ? nodes->node[nodes->n - 1].below : 0;
}

/* Integral of s times the density over the sphere: 1 minus the mean cosine. */
static double mean_s(const murk_phase_table *table)
{
    const murk_phase_node *node = table->node;
    double sum = node[0].density * node[0].s * node[0].s / (table->power + 2);
    for (size_t i = 0; i + 1 < table->nodes; ++i) {
        const double h = node[i + 1].s - node[i].s;
        sum += h * (.5 * node[i].s * (node[i].density + node[i + 1].density) +
                    h * (node[i].density + 2 * node[i + 1].density) / 6);
    }
    return TWO_PI * sum;
}

/* The last node at or before s, without the very last of the table; node 0 if
 * there is none. */
static size_t node_before(const murk_phase_table *table, double s)
{
    return murk_interval_of(&table->node[0].s,
                            sizeof *table->node / sizeof(double), table->nodes,
                            s);
}

/* Share of the light scattered by less than the angle with 1 - cos(angle) = s;
 * s must not be before node 0. */
static double share_below(const murk_phase_table *table, double s)
{
    const murk_phase_node *node = &table->node[node_before(table, s)];
    const double t = (s - node->s) / (node[1].s - node->s);
    const double here = node->density + t * (node[1].density - node->density);
    return node->below + TWO_PI * .5 * (node->density + here) * (s - node->s);
}

/* Sets for each of `guides` equal intervals of u the node at which a search for
 * u begins. */
static void fill_guide(murk_phase_table *table)
{
    size_t i = 0;
    for (size_t k = 0; k < table->guides; ++k) {
        const double u = (double)k / (double)table->guides;
        while (i + 2 < table->nodes && table->node[i + 1].below <= u) {
            ++i;
        }
        table->guide[k] = (uint32_t)i;
    }
}

murk_status murk_phase_nodes_finish(murk_phase_table **out,
                                    murk_phase_nodes *nodes, const char *where,
                                    murk_error *err)
{
    const double integral = murk_phase_nodes_integral(nodes);
    if (!nodes->is_full && !(integral > 0)) {
        free(nodes->node);
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "no light anywhere, the integral over the sphere "
                         "must be more than 0");
    }
    /* Copy the nodes, and scale the integral to 1. */
    murk_phase_table sizes = {
        .nodes = nodes->n, .guides = 1, .power = nodes->power};
    while (sizes.guides < sizes.nodes) {
        sizes.guides *= 2;
    }
    murk_phase_table *table =
        nodes->is_full ? NULL : malloc(murk_phase_table_bytes(&sizes));
    if (!table) {
        free(nodes->node);
        return murk_no_memory(err, where,
                              "for a phase function, or more than %u nodes",
                              MURK_PHASE_NODES_MAX);
    }
    *table = sizes;
    murk_phase_table_attach(table);
    for (size_t i = 0; i < table->nodes; ++i) {
        table->node[i] =
            (murk_phase_node){nodes->node[i].below / integral, nodes->node[i].s,
                              nodes->node[i].density / integral};
    }
    free(nodes->node);
    assert(table->nodes > 1 && table->node[table->nodes - 1].s == 2);
    /* The guide for sampling, then the facts. */
    fill_guide(table);
    table->facts.integral = integral;
    table->facts.mean_cosine = 1 - mean_s(table);
    table->facts.backward = 1 - share_below(table, 1);
    table->facts.nodes = table->nodes;
    *out = table;
    return MURK_OK;
}

void murk_phase_table_destroy(murk_phase_table *table)
{
    free(table);
}

const murk_phase_facts *murk_phase_table_facts(const murk_phase_table *table)
{
    return &table->facts;
}

double murk_phase_table_share(const murk_phase_table *table, double s)
{
    assert(s >= 0 && s <= 2);
    const murk_phase_node *first = table->node;
    if (s < first->s) {
        return first->below * pow(s / first->s, table->power + 1);
    }
    return share_below(table, s);
}

double murk_phase_table_density(const murk_phase_table *table, double mu)
{
    assert(mu >= -1 && mu <= 1);
    const double s = fmax(1 - mu, S_MIN);
    const murk_phase_node *node = table->node;
    if (s < node->s) {
        return node->density * pow(s / node->s, table->power);
    }
    node += node_before(table, s);
    const double t = (s - node->s) / (node[1].s - node->s);
    return node->density + t * (node[1].density - node->density);
}

/* Before the first node the power law is inverted. Beyond it the sample lies a
 * step t beyond the node before u, where t solves a = p t + (slope / 2) t^2:
 * 2 pi a is the share of the light between that node and the sample, p the
 * density of the node and `slope` that of the density. The form of the root
 * avoids cancellation. */
double murk_phase_table_sample(const murk_phase_table *table, double u)
{
    assert(u > 0 && u < 1);
    const murk_phase_node *node = table->node;
    if (u < node->below) {
        return 1 - node->s * pow(u / node->below, 1 / (table->power + 1));
    }
    node += table->guide[(size_t)(u * (double)table->guides)];
    while (node[1].below <= u) {
        ++node;
    }
    const double h = node[1].s - node->s, p = node->density;
    const double a = (u - node->below) / TWO_PI;
    const double slope = (node[1].density - p) / h;
    const double root = sqrt(fmax(0, p * p + 2 * a * slope));
    const double t = a > 0 ? 2 * a / (p + root) : 0;
    return 1 - (node->s + fmin(t, h));
}
