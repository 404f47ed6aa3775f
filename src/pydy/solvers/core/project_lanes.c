/* Constraints held in lanes: each lane has its own iterations, its own rank and its own rows that are
   redundant. */

#include "lanes.h"

#include "project.c"
