/* Nodes of a phase table, and their construction. For use inside src/medium
 * only. */
#ifndef MURK_MEDIUM_PHASE_NODES_H
#define MURK_MEDIUM_PHASE_NODES_H

#include "medium/phase_table.h"

#include <stdbool.h>
#include <stdint.h>

/* 24 MB of nodes; Fournier-Forand needs some 5000. */
#define MURK_PHASE_NODES_MAX (1u << 20)

typedef struct murk_phase_node {
    double below; /* share of the light scattered by less than the angle of this
                     node */
    double s;     /* 1 - cos(angle), rising */
    double density;
} murk_phase_node;

/* The nodes and the guide follow the struct in one block of memory, so that a
 * copy of the block is a table once the pointers are set. */
struct murk_phase_table {
    size_t nodes, guides;  /* guides: a power of two */
    murk_phase_node *node; /* [nodes]; the last one at s = 2 */
    uint32_t *guide; /* [guides]: entry k is the last of the nodes 0 to nodes
                        - 2 whose `below` is at most k / guides, or node 0 */
    double power;    /* before node 0 the density is proportional to
                        s^power; > -1 */
    murk_phase_facts facts;
};

static inline size_t murk_phase_table_bytes(const murk_phase_table *table)
{
    return sizeof *table + table->nodes * sizeof *table->node +
           table->guides * sizeof *table->guide;
}

/* Sets the pointers of a table after the block was copied. */
static inline void murk_phase_table_attach(murk_phase_table *table)
{
    table->node = (murk_phase_node *)(void *)(table + 1);
    table->guide = (uint32_t *)(void *)(table->node + table->nodes);
}

/* The list of nodes while it is built, with a density of any scale. */
typedef struct murk_phase_nodes {
    murk_phase_node *node;
    size_t n, capacity;
    double power;
    bool is_full; /* no memory, or more than MURK_PHASE_NODES_MAX nodes: no more
                     are added */
} murk_phase_nodes;

/* Adds the first node; before it the density is proportional to s^power (s =
 * 0: nothing is before it). */
void murk_phase_nodes_begin(murk_phase_nodes *nodes, double s, double density,
                            double power);

/* Adds a node; the density is linear from the previous node. A node that
 * rounding puts on the previous one is left out. */
void murk_phase_nodes_line(murk_phase_nodes *nodes, double s, double density);

/* Adds nodes up to s so that the table is within MURK_PHASE_TOLERANCE of a
 * law with positive values. */
void murk_phase_nodes_law(murk_phase_nodes *nodes, double s,
                          double (*law)(const void *context, double s),
                          const void *context);

/* The integral over the sphere up to the last node. */
double murk_phase_nodes_integral(const murk_phase_nodes *nodes);

/* Makes the table: scales the integral to 1 and computes the facts. Takes
 * ownership of the nodes, also on failure. The last node must be at s = 2.
 * Fails at `where` with MURK_BAD_VALUE if the integral is not above 0, or with
 * MURK_NO_MEMORY if nodes->is_full or there is no memory. */
murk_status murk_phase_nodes_finish(murk_phase_table **out,
                                    murk_phase_nodes *nodes, const char *where,
                                    murk_error *err);

#endif
