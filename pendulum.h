/* pendulum: exported by pydy 1.0.0. */

#ifndef PYDY_PENDULUM_H
#define PYDY_PENDULUM_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    PENDULUM_STATES = 6,
    PENDULUM_INPUTS = 1,
    PENDULUM_CONSTANTS = 6,
    PENDULUM_OUTPUTS = 0,
    PENDULUM_EVENTS = 0,
    PENDULUM_PREPARED = 36
};

typedef struct {
    double g;
    double l0;
    double l1;
    double m0;
    double m1;
    double m2;
} pendulum_constants;

extern const pendulum_constants pendulum_defaults;
extern const double pendulum_initial[]; /* states at the start */
extern const double pendulum_inputs[]; /* inputs at the start */
extern const char *const pendulum_state_names[];
extern const char *const pendulum_input_names[];
extern const char *const pendulum_constant_names[];
extern const char *const pendulum_output_names[];

/* Compute what all calls with the same constants share: an array of so many numbers. */
void pendulum_prepare(const pendulum_constants *constants, double *prepared);

/* Write the derivatives of the states. Returns 1 where the mass matrix is singular. */
int32_t pendulum_rates(double t, const double *x, const double *r,
    const double *prepared, double *out);

/* Write the outputs. Returns 1 where the mass matrix is singular. */
int32_t pendulum_outputs(double t, const double *x, const double *r,
    const double *prepared, double *out);

/* Write the derivatives of rates and outputs by states and inputs, row by row. Returns 1 where the mass matrix is singular. */
int32_t pendulum_jacobian(double t, const double *x, const double *r,
    const double *prepared, double *out);

#ifdef __cplusplus
}
#endif

#endif
