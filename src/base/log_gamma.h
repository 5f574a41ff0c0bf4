/* The logarithm of the gamma function, safe on any thread: lgamma() of the C
 * library also writes a global variable, the sign. */
#ifndef MURK_BASE_LOG_GAMMA_H
#define MURK_BASE_LOG_GAMMA_H

/* ln Gamma(x), x > 0. */
double murk_log_gamma(double x);

#endif
