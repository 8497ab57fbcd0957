#include <epsnet/epsnet.h>

#include "kernel/plane.h"

#ifndef OF_THE_PROJECT
#error "the project's definitions"
#endif
static_assert(kOwn == 1);
