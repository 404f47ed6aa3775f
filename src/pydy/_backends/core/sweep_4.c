#define LANES 4
#define SWEEP sweep_4
#include "sweep.h"
