#define LANES 4
#include "solve.h"
