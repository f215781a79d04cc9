#pragma once
#include "ir/cl/post_word.h"
#include "runtime/interpret/action.h"

namespace arelem::runtime {

/// The post-processor word that an action passes on, else null.
[[nodiscard]] inline const cl::Post* passedPost(const Action& action) {
  const auto* pass = std::get_if<Pass>(&action.body);
  return pass != nullptr ? std::get_if<cl::Post>(&pass->body) : nullptr;
}

}  // namespace arelem::runtime
