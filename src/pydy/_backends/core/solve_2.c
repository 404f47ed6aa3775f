#define LANES 2
#include "solve.h"
