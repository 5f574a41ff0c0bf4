/* How a phase table is laid out, node by node; inside this room only. */
#ifndef MURK_MEDIUM_PHASE_NODES_H
#define MURK_MEDIUM_PHASE_NODES_H

#include "medium/phase_table.h"

#include <stdbool.h>
#include <stdint.h>

#define MURK_PHASE_NODES_MAX (1u << 20)

typedef struct murk_phase_node {
    double below; /* share of the light that turns by less */
    double s;     /* 1 - cos(angle), rising */
    double density;
} murk_phase_node;

struct murk_phase_table {
    murk_phase_node *node; /* [nodes]; the last one at s = 2 */
    size_t nodes;
    double power;    /* before node 0 the density is as s^power, > -1 */
    uint32_t *guide; /* [guides]: the last node that k / guides is not below */
    size_t guides;   /* a power of two */
    murk_phase_facts facts;
};

/* Nodes so far, of any scale. */
typedef struct murk_phase_nodes {
    murk_phase_node *node;
    size_t n, room;
    double power;
    bool is_full; /* no memory, or more than MURK_PHASE_NODES_MAX: from then on
                     nothing is added */
} murk_phase_nodes;

/* The first node; before it s^power (s = 0: nothing before). */
void murk_phase_nodes_begin(murk_phase_nodes *nodes, double s, double density,
                            double power);

/* A node whose way from the one before is linear. One that rounding puts on
 * the one before is left out. */
void murk_phase_nodes_line(murk_phase_nodes *nodes, double s, double density);

/* Nodes up to s within MURK_PHASE_TOLERANCE of a law above 0. */
void murk_phase_nodes_law(murk_phase_nodes *nodes, double s,
                          double (*law)(const void *context, double s),
                          const void *context);

/* The integral so far. */
double murk_phase_nodes_integral(const murk_phase_nodes *nodes);

/* Makes the table, its integral 1 and its facts those that nodes tell; takes
 * the nodes, also where it fails. The last node is at s = 2. */
murk_status murk_phase_nodes_finish(murk_phase_table **out,
                                    murk_phase_nodes *nodes, const char *where,
                                    murk_error *err);

#endif
