#pragma once
#include <initializer_list>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ir/diag/diagnostic.h"
#include "runtime/define/define.h"

/// Short spellings for tests of definitions: `defined(T::point, {W::INTOF, line1, line2})`.
namespace arelem::define::test {

using T = EntityType;
using W = Word;
using P = std::vector<Parameter>;

inline EntityPtr make(EntityType type, std::vector<double> canon) {
  Entity entity;
  entity.type = type;
  entity.canon = std::move(canon);
  return std::make_shared<const Entity>(std::move(entity));
}

inline EntityPtr point(double x, double y, double z = 0.0) {
  return make(T::point, {x, y, z});
}

/// The defined entity; a test failure with the message when there is none.
inline Entity defined(EntityType type, const P& parameters, const Context& context = {}) {
  Result<Entity> result = define(type, parameters, context);
  if (!result) {
    ADD_FAILURE() << result.failure().message << "\n" << result.failure().help;
    return {};
  }
  return *std::move(result);
}

inline EntityPtr definedPtr(EntityType type, const P& parameters) {
  return std::make_shared<const Entity>(defined(type, parameters));
}

/// The failure of a definition; a test failure when it succeeds.
inline Failure refused(EntityType type, const P& parameters) {
  Result<Entity> result = define(type, parameters, {});
  if (result) {
    ADD_FAILURE() << "a definition was expected to fail";
    return {};
  }
  return result.takeFailure();
}

inline std::string codeOf(const Failure& failure) {
  return std::string(failure.row->name);
}

/// All numbers within `allowance` times the largest expected one (at least 1).
inline void expectCanon(const std::vector<double>& actual,
                        const std::vector<double>& expected,
                        double allowance,
                        const std::string& what = "") {
  ASSERT_EQ(actual.size(), expected.size()) << what;
  double size = 1.0;
  for (const double v : expected) {
    size = std::max(size, std::abs(v));
  }
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(actual[i], expected[i], allowance * size) << what << " value " << i + 1;
  }
}

}  // namespace arelem::define::test
