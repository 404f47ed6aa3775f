#define LANES 2
#define SWEEP sweep_2
#include "sweep.h"
