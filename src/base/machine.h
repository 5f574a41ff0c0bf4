/* Memory that the machine has free and that the process uses. */
#ifndef MURK_BASE_MACHINE_H
#define MURK_BASE_MACHINE_H

/* The memory that is available without swapping out other processes [bytes]:
 * the smaller of the figure of the system and the limit of this process;
 * infinite if unknown. */
double murk_machine_memory_bytes(void);

/* The largest memory that this process has used so far [bytes]. */
double murk_machine_peak_bytes(void);

#endif
