#define LANES 8
#include "solve.h"
