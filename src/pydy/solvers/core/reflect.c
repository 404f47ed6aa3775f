/* A kernel of the motion in reversed time s = -t, from that of the motion in time.

   Its constants begin with the place of the other kernel's address and the number of outputs, the first
   ones, that are derivatives by time; those of the other kernel follow after REFLECTED doubles. */

#include "equations.h"

int32_t reflect(const double *s, const double *x, const double *r, const double *c, double *out)
{
    const int64_t *words = (const int64_t *)c;
    const double t = -s[0];
    const int64_t failed = call_kernel(words[0], &t, x, r, c + REFLECTED, out);
    for (int64_t i = 0; i < words[1]; i++)
        out[i] = -out[i];
    return (int32_t)failed;
}
