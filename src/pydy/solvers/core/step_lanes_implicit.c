/* The loop of lanes around steps of Radau IIA. */

#define IMPLICIT
#include "step_lanes.c"
