#include <ostream>

#include "ir/program/program.h"
