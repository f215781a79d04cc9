#pragma once
#include <optional>
#include <vector>

#include "ir/cl/record.h"

/// What the words of CAM systems mean in the words of APT. Records keep the spelling of their
/// system; who acts on them (controls, times, pictures) asks here.
namespace arelem::cl {

/// LOAD/TOOL,n,... is LOADTL/n,..., SELECT/TOOL,n is SELCTL/n. None for a post that is APT already,
/// and for words that have no counterpart.
[[nodiscard]] std::optional<Post> inApt(const Post& post);

/// The CUTTER values of a tool description, TLDATA/MILL,d,corner,length,taper,tip or
/// TLDATA/DRILL,MILL,d,corner,length,point,...: diameter and corner radius.
[[nodiscard]] std::optional<std::vector<double>> cutterOf(const Post& post);

}  // namespace arelem::cl
