// Coefficients of LCONIC, scale and sign included: a program may hand them on to another one.
// With the lines 1-2, 4-5, 1-4, 2-5 as a x + b y + c, point 3 fixes k in L1 L2 + k L3 L4.
#include "tests/unit/runtime/define/forms.h"

namespace arelem::define::test {
namespace {

// L1: x, L2: 4 - x (both vertical), L3: 0.75 x - y, L4: 2 - 0.75 x - y; at (3, 1) they are 3, 1,
// 1.25, -1.25, hence k = 1.92.
TEST(LoftConic, FivePointsWithVerticalChords) {
  expectCanon(
      defined(T::lconic, {W::W_5PT, 0.0, 0.0, 0.0, 2.0, 3.0, 1.0, 4.0, 3.0, 4.0, -1.0}).canon,
      {-2.08, 1.92, 0, 0, 0, 0, 0, 3.44, -1.92, 0}, 1e-14);
}

// Flat lines have -1 before y. Tangent at (0,0): -y. Through (2,1) and (4,1): 1 - y. (0,0)-(2,1):
// x/2 - y. (0,0)-(4,1): x/4 - y. At (5,2): -2, -1, 0.5, -0.75, hence k = 2 / 0.375 = 16/3.
TEST(LoftConic, FlatLinesAreInSlopeForm) {
  const Entity conic =
      defined(T::lconic, {W::W_4PT1SL, 0.0, 0.0, 0.0, 5.0, 2.0, 2.0, 1.0, 4.0, 1.0});
  const double k = 16.0 / 3.0;
  expectCanon(conic.canon, {k / 8.0, 1.0 + k, 0, 0, 0, 0, -0.375 * k, 0, -0.5, 0}, 1e-14);
}

TEST(LoftConic, PlaceThatFixesTheConicIsNamedWhenItFails) {
  const Failure failure =
      refused(T::lconic, {W::W_5PT, 0.0, 0.0, 2.0, 0.0, 1.0, 0.0, 3.0, 1.0, 4.0, 5.0});
  EXPECT_NE(failure.message.find("point 3"), std::string::npos) << failure.message;
}

}  // namespace
}  // namespace arelem::define::test
