#define LANES 1
#include "solve.h"
