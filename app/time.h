#pragma once
#include "app/command.h"

namespace arelem::app {

int runTime(const Invocation& invocation);

}  // namespace arelem::app
