/* The limits on the memory of the control groups of Linux that this process is
 * in: those of a container, or of a job of a scheduler. */
#ifndef MURK_BASE_MEMORY_GROUP_H
#define MURK_BASE_MEMORY_GROUP_H

/* The memory that the groups leave [bytes], where pages of files count as
 * free, because the system takes them back; INFINITY without a limit. `list` is
 * the file with the groups of a process (/proc/self/cgroup), `root` the folder
 * of all groups
 * (/sys/fs/cgroup), of version 1 or 2.
 *
 * Source: Linux kernel documentation, admin-guide/cgroup-v1/memory.rst and
 * admin-guide/cgroup-v2.rst. */
double murk_memory_group_bytes(const char *list, const char *root);

#endif
