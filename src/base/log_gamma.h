/* The logarithm of the gamma function, safe on any thread: C's lgamma() also
 * writes its sign to a global variable. */
#ifndef MURK_BASE_LOG_GAMMA_H
#define MURK_BASE_LOG_GAMMA_H

/* ln Gamma(x), x > 0. */
double murk_log_gamma(double x);

#endif
