#define LANES 8
#define SWEEP sweep_8
#include "sweep.h"
