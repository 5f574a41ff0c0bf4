/* What this machine can spare. */
#ifndef MURK_BASE_MACHINE_H
#define MURK_BASE_MACHINE_H

/* Memory that can be had without pushing others out [bytes]: the least of the
 * system's own figure and this process's limit; infinite when unknown. */
double murk_machine_memory_bytes(void);

/* The most that this process has used at one time [bytes]. */
double murk_machine_peak_bytes(void);

#endif
